// SPDX-License-Identifier: MIT
// Prints the tables of docs/pushing.md:
//
//     push_study LIBRARY [LABELS]
//
// for a library with pushes, with as many labels (1,500 unless given) of the proxy judge.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "database/files/library_writer.h"
#include "motion/error.h"
#include "motion/offset_spring.h"
#include "tests/bench/measures.h"
#include "tests/bench/push_fidelity.h"
#include "tests/bench/study.h"
#include "train/realism/proxy_judge.h"
#include "train/realism/realism_evaluation.h"

namespace flinch {
namespace {

using bench::percent;
using bench::PushFidelity;
using bench::PushStudy;
using bench::quantile;
using bench::State;
using motion::Role;
using runtime::PushCandidate;
using runtime::PushMotion;

void print_offset() {
  double worst = 0;
  for (const auto& [x0, v0] : {std::pair{0.3, 0.0}, std::pair{0.0, 1.0}, std::pair{-0.1, 0.7}}) {
    double x = x0;
    double v = v0;
    constexpr double kH = 1e-6;  // midpoint rule
    for (int k = 1; k <= 1'500'000; ++k) {
      const double xm = x + kH / 2 * v;
      const double vm = v + kH / 2 * (-50 * x - 10 * v);
      x += kH * vm;
      v += kH * (-50 * xm - 10 * vm);
      if (k % 10'000 != 0) continue;
      const auto spring = motion::offset_spring(static_cast<float>(k * kH));
      worst = std::max(worst,
                       std::abs(double{spring.position} * x0 + double{spring.velocity} * v0 - x));
    }
  }
  const auto after = motion::offset_spring(1.5F);
  std::printf(
      "\n## The offset\n\n| closed form against steps of 1 us, worst | a jump of 0.3 m "
      "after 1.5 s |\n| --- | --- |\n| %.1e m | %.2f mm |\n",
      worst, std::abs(300 * double{after.position}));
}

void print_fidelity(const char* name, const PushFidelity& fidelity) {
  const std::size_t played = fidelity.slips_mm.size();
  std::printf(
      "\n## Answered pushes: %s\n\n| asked | best Q above 0.5 | answered | "
      "played |\n| --- | --- | --- | --- |\n| %zu | %.1f %% | %.1f %% | %zu |\n",
      name, fidelity.asked, percent(fidelity.good, fidelity.asked),
      percent(fidelity.accepted, fidelity.asked), played);
  std::printf("\n| of those played | |\n| --- | --- |\n");
  std::printf("| fastest velocity within 0.65 s within 10 %% and 15 degrees | %.1f %% |\n",
              percent(fidelity.right, played));
  std::printf("| the same, of %zu with a recorded direction 35 degrees or more off | %.1f %% |\n",
              fidelity.off, percent(fidelity.off_right, fidelity.off));
  std::printf("| error of its speed, median and p90 | %.1f %%, %.1f %% |\n",
              quantile(fidelity.speed_errors, 0.5), quantile(fidelity.speed_errors, 0.9));
  std::printf("| error of its direction, median and p90 | %.1f, %.1f degrees |\n",
              quantile(fidelity.angle_errors, 0.5), quantile(fidelity.angle_errors, 0.9));
  std::printf(
      "| slip of a standing ankle beyond the recording's own, median, p99, worst | %.2f, "
      "%.2f, %.2f mm |\n",
      quantile(fidelity.slips_mm, 0.5), quantile(fidelity.slips_mm, 0.99),
      quantile(fidelity.slips_mm, 1));
  std::printf(
      "| step of a joint's velocity at the push, as a share of the clip's own p99: median, "
      "p90, worst | %.2f, %.2f, %.2f |\n",
      quantile(fidelity.seams, 0.5), quantile(fidelity.seams, 0.9), quantile(fidelity.seams, 1));
  std::printf("| longest change of a bone | %.1e m |\n", fidelity.bone_error_m);
}

/// A mean with half of its interval of 95 % over states.
struct MeanOverStates {
  double mean = 0;
  double half_width = 0;
};
MeanOverStates mean_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double mean = 0, squares = 0;
  for (const double one : values) mean += one / n;
  for (const double one : values) squares += (one - mean) * (one - mean);
  return {mean, n > 1 ? 1.96 * std::sqrt(squares / (n - 1) / n) : 0};
}

/// Pushes a character in one state from 72 directions, with 3 strengths, at 5 places. Returns how
/// many percent of these pushes are answered.
double answered_percent(const PushStudy& study, const State& state, const bench::PushModelOf& with,
                        const runtime::SearchOptions& options, bool is_baseline) {
  const runtime::PushModel& model = with.model;
  std::vector<std::byte> memory(model.memory_bytes);
  const auto character = models::components_of(
      with.realism, std::span(state.configuration.data(), with.realism.mean.size()));
  std::array<PushCandidate, 8> best{};
  std::size_t answered = 0, whole = 0;
  for (const Role place : motion::kPushPlaces) {
    for (int direction = 0; direction < 72; ++direction) {
      for (const float speed : {0.5F, 0.9F, 1.3F}) {
        const Eigen::Vector3f asked = bench::horizontal(speed, 5 * static_cast<float>(direction));
        const Eigen::Vector3f wanted = wanted_velocity(state, asked);
        ++whole;
        std::size_t count = 1;
        if (is_baseline) {
          best[0] = nearest_response(study, state, place, asked);
          const auto& response = model.components[static_cast<std::size_t>(best[0].response)];
          best[0].realism = models::estimate_realism(
              with.realism, realism_features(character, response, best[0], asked));
        } else {
          count = runtime::search_push(study.responses, model, state.configuration, place, asked,
                                       options, memory, best);
        }
        const auto answer = answer_of(study, model, state, std::span(best).first(count), place,
                                      asked, options.deforms);
        answered +=
            answer && runtime::is_faithful(peak_velocity(answer->motion, wanted), wanted) ? 1 : 0;
      }
    }
  }
  return percent(answered, whole);
}

void print_coverage(const PushStudy& study, const std::vector<State>& states) {
  struct Row {
    const char* name;
    runtime::SearchOptions options;
    bool is_baseline = false;
    bool is_paper = false;
  };
  const std::array rows{Row{"nearest configuration (the paper's baseline)", {false, false}, true},
                        Row{"search, without deformation", {false, false}},
                        Row{"with deformation", {true, false}},
                        Row{"with deformation and turning", {true, true}},
                        Row{"F and G of the paper", {}, false, true}};
  std::printf(
      "\n## Coverage: 72 directions x 3 strengths (0.5, 0.9, 1.3 m/s) x 5 places x %zu "
      "states\n\nAnswered: Q over 0.5, and the pushed joint reaches the asked velocity "
      "within 10 %% and 15 degrees. All rows have the same pushes and states.\n\n"
      "| | answered | 95 %% interval over states | more than the row above, interval |\n"
      "| --- | --- | --- | --- |\n",
      states.size());
  std::vector<double> above;
  for (const Row& row : rows) {
    std::vector<double> shares;
    for (const State& state : states)
      shares.push_back(answered_percent(study, state, row.is_paper ? study.paper : study.ours,
                                        row.options, row.is_baseline));
    const MeanOverStates answered = mean_of(shares);
    std::printf("| %s | %.1f %% | %.1f to %.1f %% |", row.name, answered.mean,
                answered.mean - answered.half_width, answered.mean + answered.half_width);
    for (std::size_t k = 0; k < above.size(); ++k) above[k] = shares[k] - above[k];
    const MeanOverStates more = mean_of(above);
    if (above.empty()) {
      std::printf(" |\n");
    } else {
      std::printf(" %.1f points, %.1f to %.1f |\n", more.mean, more.mean - more.half_width,
                  more.mean + more.half_width);
    }
    above = shares;
  }
}

void print_agreement(const PushStudy& study) {
  std::printf(
      "\n## Agreement with held-out labels of the %s\n\n| G | labels | agreement | chance | "
      "AUC | AUC of the nearest configuration |\n| --- | --- | --- | --- | --- | --- |\n",
      std::string(train::kProxyJudge).c_str());
  for (const auto& [name, kind] : {std::pair{"ours", train::RealismKind::ours},
                                   std::pair{"the paper's", train::RealismKind::paper}}) {
    for (const std::size_t most : {50UL, 100UL, 200UL, 400UL, 800UL, 1500UL}) {
      if (most > study.labels.labels.size()) break;
      const auto result = train::held_out_agreement(study.labels, kind, most);
      std::printf("| %s | %zu | %.3f | %.3f | %.3f | %.3f |\n", name, most, result.agreement,
                  result.chance, result.auc, result.baseline_auc);
    }
  }
}

/// CPU time of asking F and G for every response and width by comparing with every example.
double slow_search_us(const PushStudy& study, const State& state, Role place,
                      const Eigen::Vector3f& asked, float& checksum) {
  const double begin_s = bench::thread_cpu_s();
  const auto character = models::components_of(
      study.ours.realism, std::span(state.configuration.data(), study.ours.realism.mean.size()));
  for (std::size_t i = 0; i < study.responses.responses.size(); ++i) {
    PushCandidate candidate = runtime::deformed_candidate(study.responses, i, place, asked);
    for (const float taper : runtime::kTapers) {
      candidate.taper = taper;
      checksum += models::estimate_realism(
          study.ours.realism,
          realism_features(character, study.ours.model.components[i], candidate, asked));
    }
  }
  return 1e6 * (bench::thread_cpu_s() - begin_s);
}

void print_speed(const PushStudy& study, const std::vector<State>& states) {
  const runtime::PushModel& model = study.ours.model;
  std::vector<std::byte> memory(model.memory_bytes);
  std::vector<double> queries_us, slow_us, frames_us, begins_us;
  std::array<PushCandidate, 8> best{};
  float checksum = 0;
  for (const State& state : states) {
    for (int k = 0; k < 40; ++k) {
      const Eigen::Vector3f asked = bench::horizontal(0.9F, 9 * static_cast<float>(k));
      const Role place = motion::kPushPlaces[static_cast<std::size_t>(k) % 5];
      double begin_s = bench::thread_cpu_s();
      runtime::search_push(study.responses, model, state.configuration, place, asked, {}, memory,
                           best);
      queries_us.push_back(1e6 * (bench::thread_cpu_s() - begin_s));
      if (k == 0) slow_us.push_back(slow_search_us(study, state, place, asked, checksum));
      begin_s = bench::thread_cpu_s();
      const auto answer = answer_of(study, model, state, best, place, asked, true);
      begins_us.push_back(1e6 * (bench::thread_cpu_s() - begin_s));
      const PushMotion motion =
          answer ? answer->motion : push_motion_for(study, state, best[0], place, asked, true);
      begin_s = bench::thread_cpu_s();
      for (int frame = 0; frame < 60; ++frame)
        checksum += pose_at(motion, static_cast<float>(frame) / 60).root_position.x();
      frames_us.push_back(1e6 * (bench::thread_cpu_s() - begin_s) / 60);
    }
  }
  const double frame_us = quantile(frames_us, 0.5);
  std::printf("\n## Time, CPU (checksum %.3f)\n\n| | median | p99 |\n| --- | --- | --- |\n",
              double{checksum});
  std::printf("| search over %zu responses, %zu widths, %zu examples | %.0f us | %.0f us |\n",
              study.responses.responses.size(), runtime::kTapers.size(), study.ours.realism.size(),
              quantile(queries_us, 0.5), quantile(queries_us, 0.99));
  std::printf("| the same by comparing with every example | %.0f us | %.0f us |\n",
              quantile(slow_us, 0.5), quantile(slow_us, 0.99));
  std::printf("| matching the velocity of the best candidates | %.0f us | %.0f us |\n",
              quantile(begins_us, 0.5), quantile(begins_us, 0.99));
  std::printf("| a frame | %.1f us | %.1f us |\n", frame_us, quantile(frames_us, 0.99));
  std::printf("| 20 characters at 60 Hz, share of a core | %.2f %% | |\n",
              20 * 60 * frame_us * 1e-4);
}

void print_responses(const PushStudy& study) {
  std::vector<double> speeds, rises;
  std::size_t front = 0, behind = 0, side = 0;
  for (const runtime::PushResponse& response : study.responses.responses) {
    const motion::Push& push = *study.library.clip(response.clip).push;
    speeds.push_back(double{push.velocity.norm()});
    rises.push_back(double{response.rise_s});
    const float off = bench::angle_deg(push.velocity, Eigen::Vector3f::UnitX());
    ++(off < 45 ? behind : off > 135 ? front : side);
  }
  std::printf(
      "\n## Responses\n\n| responses | from the front, behind, a side | speed: median, min, "
      "max | contact to peak: median, min, max |\n| --- | --- | --- | --- |\n| %zu | %zu, "
      "%zu, %zu | %.2f, %.2f, %.2f m/s | %.2f, %.2f, %.2f s |\n",
      speeds.size(), front, behind, side, quantile(speeds, 0.5), quantile(speeds, 0),
      quantile(speeds, 1), quantile(rises, 0.5), quantile(rises, 0), quantile(rises, 1));
}

void label(PushStudy& study, std::size_t count) {
  const train::ProxyJudge judge(study.responses);
  std::vector<train::Label> labels = train::proxy_labels(study.responses, judge, count, 1);
  std::vector<double> qualities;
  for (const train::Label& one : labels) qualities.push_back(double{one.quality});
  const auto good = std::ranges::count_if(qualities, [](double q) { return q > 0.5; });
  std::printf(
      "\n## Labels\n\n| labels | good | Q: p10, median, p90 |\n| --- | --- | --- |\n| %zu | "
      "%.1f %% | %.2f, %.2f, %.2f |\n",
      count, percent(static_cast<std::size_t>(good), count), quantile(qualities, 0.1),
      quantile(qualities, 0.5), quantile(qualities, 0.9));
  study.labels = train::configurations_of(study.responses, std::move(labels));
}

void fit(PushStudy& study, train::RealismKind kind, bench::PushModelOf& to) {
  to.realism = train::fit_realism(study.labels, kind, std::string(train::kProxyJudge));
  to.model = runtime::prepare_push_model(study.responses, &to.realism);
}

void run(const bench::StudyArguments& arguments) {
  PushStudy study;
  study.library = database::load_library(arguments.text(0));
  study.prepared = runtime::prepare(study.library);
  study.responses = runtime::prepare_push_responses(study.prepared);
  if (study.responses.responses.empty()) throw Error(arguments.text(0), "has no pushes");
  print_responses(study);
  print_offset();
  label(study, arguments.number_or<std::size_t>(1, 1500));
  fit(study, train::RealismKind::ours, study.ours);
  fit(study, train::RealismKind::paper, study.paper);
  print_speed(study, everyday_states(study, 20));
  const std::vector<State> states = everyday_states(study, 10);
  print_fidelity("ours", measure_fidelity(study, study.ours.model, states));
  print_fidelity("F and G of the paper", measure_fidelity(study, study.paper.model, states));
  print_coverage(study, everyday_states(study, 20));
  print_agreement(study);
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"push_study LIBRARY [LABELS]", 1, 2},
                                   flinch::run);
}

// SPDX-License-Identifier: MIT
// Prints the tables of docs/pushing.md:
//
//     push_study LIBRARY [LABELS]
//
// for a library with pushes, with as many labels (1,500 unless given) of the proxy judge.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "database/files/library_writer.h"
#include "motion/error.h"
#include "motion/offset_spring.h"
#include "motion/rotation.h"
#include "runtime/push/push_deformation.h"
#include "tests/bench/measures.h"
#include "tests/bench/study.h"
#include "train/realism/proxy_judge.h"
#include "train/realism/realism_evaluation.h"

namespace flinch {
namespace {

using bench::quantile;
using motion::Role;
using runtime::PushCandidate;
using runtime::PushMotion;

constexpr float kStep_s = 1.0F / 240;

struct Study {
  database::ClipLibrary library;
  runtime::PreparedLibrary prepared;
  runtime::PushResponses responses;
  train::LabelledConfigurations labels;
  models::RealismModel realism;
  runtime::PushModel model;
};

/// A character's state when it is pushed, and C_t.
struct State {
  motion::Pose before;
  motion::Pose now;
  runtime::BodyConfiguration configuration;
};

State state_at(const Study& study, const motion::Motion& motion, float time_s) {
  State state{motion::sample(motion, time_s - kStep_s), motion::sample(motion, time_s), {}};
  state.configuration =
      runtime::body_configuration(study.prepared.skeleton(), state.before, state.now, kStep_s);
  return state;
}

/// `count` states, spread over all idle and unannotated clips by their length.
std::vector<State> everyday_states(const Study& study, std::size_t count) {
  std::vector<std::pair<const motion::Motion*, float>> times;
  for (const motion::Clip& clip : study.library.clips) {
    if (clip.purpose == motion::Purpose::push || clip.annotation) continue;
    for (float time_s = 0.1F; time_s < clip.motion.duration_s(); time_s += 0.1F)
      times.emplace_back(&clip.motion, time_s);
  }
  std::vector<State> states;
  for (std::size_t k = 0; k < count && !times.empty(); ++k) {
    const auto& [motion, time_s] = times[k * times.size() / count];
    states.push_back(state_at(study, *motion, time_s));
  }
  return states;
}

Eigen::Vector3f horizontal(float speed, float degrees) {
  const float direction = motion::radians(degrees);
  return speed * Eigen::Vector3f(std::cos(direction), std::sin(direction), 0);
}

float angle_deg(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return motion::degrees(std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0F, 1.0F)));
}

PushMotion motion_for(const Study& study, const State& state, const PushCandidate& candidate,
                      Role place, const Eigen::Vector3f& asked, bool deforms = true) {
  const auto response = static_cast<std::size_t>(candidate.response);
  const Eigen::Quaternionf facing =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::facing(state.now));
  const runtime::PushDeformation deformation{place, candidate.taper, facing * candidate.deformation,
                                             study.responses.responses[response].rise_s};
  PushMotion motion = make_push_motion(study.responses, response, candidate.turn, deformation,
                                       state.before, state.now, kStep_s);
  if (deforms) match_velocity(facing * asked, motion);
  return motion;
}

struct Answer {
  PushCandidate candidate;
  PushMotion motion;
};

/// What Character::push() would play of these candidates, best first.
std::optional<Answer> answer_of(const Study& study, const State& state,
                                std::span<const PushCandidate> candidates, Role place,
                                const Eigen::Vector3f& asked, bool deforms) {
  const Eigen::Vector3f wanted =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::facing(state.now)) * asked;
  for (const PushCandidate& candidate : candidates) {
    if (!(candidate.realism > runtime::kGoodRealism)) break;
    const PushMotion motion = motion_for(study, state, candidate, place, asked, deforms);
    if (runtime::is_faithful(peak_velocity(motion, wanted), wanted)) return {{candidate, motion}};
  }
  return std::nullopt;
}

motion::JointFrames joints(const Study& study, const motion::Pose& pose) {
  return motion::forward_kinematics(study.prepared.skeleton(), pose);
}

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

/// Changes of joints' velocities from frame to frame, m/s.
std::vector<double> velocity_steps(const Study& study, const std::vector<motion::Pose>& poses,
                                   float step_s) {
  std::vector<double> steps;
  for (std::size_t k = 2; k < poses.size(); ++k) {
    const auto a = joints(study, poses[k - 2]);
    const auto b = joints(study, poses[k - 1]);
    const auto c = joints(study, poses[k]);
    double most = 0;
    for (const Role role : motion::kRoles)
      most = std::max(
          most,
          double{(c.position[role] - 2 * b.position[role] + a.position[role]).norm() / step_s});
    steps.push_back(most);
  }
  return steps;
}

/// The worst slip of an ankle from where its foot stood when the push came, m, until the response
/// lifts the foot; of feet that stand for at least 0.1 s.
double standing_slip_m(const Study& study, const PushMotion& motion) {
  double worst = 0;
  for (const motion::Side side : motion::kSides) {
    const runtime::PushFoot& foot = motion.feet[side];
    if (!foot.stands || foot.fade.begin_s < 0.1F) continue;
    const Role ankle = motion::roles_of(side).foot;
    const auto clip_ankle = [&](float time_s) -> Eigen::Vector3f {
      return joints(study, motion::placed(motion::sample(study.prepared.clip(motion.clip).motion,
                                                         motion.contact_s + time_s),
                                          motion.yaw, motion.translation))
          .position[ankle];
    };
    const Eigen::Vector3f offset = foot.offset;
    for (float time_s = 0; time_s < std::min(foot.fade.begin_s, motion.duration_s);
         time_s += 1.0F / 60) {
      const Eigen::Vector3f shown = joints(study, pose_at(motion, time_s)).position[ankle];
      const Eigen::Vector3f rolled =
          foot.pivot + motion::rotation_about(Eigen::Vector3f::UnitZ(), foot.yaw) *
                           (clip_ankle(time_s) - foot.pivot);
      worst = std::max(worst, double{(shown - rolled - offset).head<2>().norm()});
    }
  }
  return worst;
}

/// The fastest velocity along the asked one within 0.65 s, over 1/15 s, from every 1/120 s.
Eigen::Vector3f fine_peak(const Study& study, const PushMotion& motion,
                          const Eigen::Vector3f& wanted) {
  const auto place_at = [&](float time_s) {
    return joints(study, pose_at(motion, time_s)).position[motion.place];
  };
  constexpr float kHalf_s = runtime::kClipVelocityInterval_s / 2;
  Eigen::Vector3f fastest = Eigen::Vector3f::Zero();
  for (float time_s = kHalf_s; time_s < 0.65F - kHalf_s; time_s += 1.0F / 120) {
    const Eigen::Vector3f velocity =
        (place_at(time_s + kHalf_s) - place_at(time_s - kHalf_s)) / (2 * kHalf_s);
    if (velocity.dot(wanted) > fastest.dot(wanted)) fastest = velocity;
  }
  return fastest;
}

double share(std::size_t part, std::size_t whole) {
  return whole > 0 ? 100 * static_cast<double>(part) / static_cast<double>(whole) : 0;
}

void print_fidelity(const Study& study, const std::vector<State>& states,
                    std::span<std::byte> memory) {
  std::size_t asked_count = 0, good = 0, accepted = 0, at_peak = 0, off = 0, off_right = 0;
  std::vector<double> slips, seams, errors, angles;
  double bone_error = 0;
  for (const State& state : states) {
    const Eigen::Quaternionf facing =
        motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::facing(state.now));
    for (const Role place : motion::kPushPlaces) {
      for (int degrees = 0; degrees < 360; degrees += 15) {
        for (const float speed : {0.5F, 0.9F, 1.3F}) {
          ++asked_count;
          const Eigen::Vector3f asked = horizontal(speed, static_cast<float>(degrees));
          std::array<PushCandidate, 8> best{};
          const std::size_t count = runtime::search_push(
              study.responses, study.model, state.configuration, place, asked, {}, memory, best);
          good += best[0].realism > runtime::kGoodRealism ? 1 : 0;
          const auto answer =
              answer_of(study, state, std::span(best).first(count), place, asked, true);
          if (!answer) continue;
          ++accepted;
          if (accepted % 4 != 0) continue;  // a quarter of them is played
          const PushMotion& motion = answer->motion;
          const Eigen::Vector3f wanted = facing * asked;
          const Eigen::Vector3f peak = fine_peak(study, motion, wanted);
          const bool right_peak = runtime::is_faithful(peak, wanted);
          errors.push_back(std::abs(double{peak.head<2>().norm() / wanted.norm()} - 1) * 100);
          angles.push_back(double{angle_deg({peak.x(), peak.y(), 0}, wanted)});
          at_peak += right_peak ? 1 : 0;
          const auto& own =
              study.responses.responses[static_cast<std::size_t>(answer->candidate.response)]
                  .velocity[runtime::push_place_index(place)];
          if (angle_deg({own.x(), own.y(), 0}, asked) > 35) {
            ++off;
            off_right += right_peak ? 1 : 0;
          }
          slips.push_back(1e3 * standing_slip_m(study, motion));
          // Seams: two frames before the push and two after it.
          std::vector<motion::Pose> shown{state.before, state.now, pose_at(motion, kStep_s),
                                          pose_at(motion, 2 * kStep_s)};
          const auto clip = study.prepared.clip(motion.clip).motion;
          std::vector<motion::Pose> own_poses;
          for (float t = 0; t < motion.duration_s; t += kStep_s)
            own_poses.push_back(motion::sample(clip, motion.contact_s + t));
          const double usual = quantile(velocity_steps(study, own_poses, kStep_s), 0.99);
          seams.push_back(quantile(velocity_steps(study, shown, kStep_s), 1) / usual);
          const auto then = joints(study, pose_at(motion, 0.2F));
          for (const Role role : motion::kRoles) {
            if (role == Role::pelvis) continue;
            const double length =
                double{(then.position[role] - then.position[motion::kParents[role]]).norm()};
            bone_error =
                std::max(bone_error,
                         std::abs(length - double{study.prepared.skeleton().offset[role].norm()}));
          }
        }
      }
    }
  }
  const std::size_t played = slips.size();
  std::printf(
      "\n## Accepted pushes\n\n| asked | best Q above 0.5 | accepted: reaches the velocity, too | "
      "played |\n| --- | --- | --- | --- |\n| %zu | %.1f %% | %.1f %% | %zu |\n",
      asked_count, share(good, asked_count), share(accepted, asked_count), played);
  std::printf("\n| of those played | |\n| --- | --- |\n");
  std::printf("| fastest velocity within 0.65 s within 10 %% and 15 degrees | %.1f %% |\n",
              share(at_peak, played));
  std::printf("| the same, of %zu with a recorded direction 35 degrees or more off | %.1f %% |\n",
              off, share(off_right, off));
  std::printf("| error of its speed, median and p90 | %.1f %%, %.1f %% |\n", quantile(errors, 0.5),
              quantile(errors, 0.9));
  std::printf("| error of its direction, median and p90 | %.1f, %.1f degrees |\n",
              quantile(angles, 0.5), quantile(angles, 0.9));
  std::printf(
      "| slip of a standing ankle beyond the recording's own, median, p99, worst | %.2f, "
      "%.2f, %.2f mm |\n",
      quantile(slips, 0.5), quantile(slips, 0.99), quantile(slips, 1));
  std::printf(
      "| step of a joint's velocity at the push, as a share of the clip's own p99: median, "
      "p90, worst | %.2f, %.2f, %.2f |\n",
      quantile(seams, 0.5), quantile(seams, 0.9), quantile(seams, 1));
  std::printf("| longest change of a bone | %.1e m |\n", bone_error);
}

/// The response of the nearest configuration, as it is.
PushCandidate nearest_response(const Study& study, const State& state, Role place,
                               const Eigen::Vector3f& asked) {
  std::size_t nearest = 0;
  const auto distance = [&](std::size_t i) {
    return (study.responses.responses[i].configuration - state.configuration).squaredNorm();
  };
  for (std::size_t i = 1; i < study.responses.responses.size(); ++i) {
    if (distance(i) < distance(nearest)) nearest = i;
  }
  PushCandidate candidate = runtime::deformed_candidate(study.responses, nearest, place, asked,
                                                        {.deforms = false, .turns = false});
  candidate.taper = 1;
  return candidate;
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

void print_coverage(const Study& study, const std::vector<State>& states,
                    std::span<std::byte> memory) {
  struct Row {
    const char* name;
    runtime::SearchOptions options;
    bool is_baseline;
  };
  const std::array rows{Row{"nearest configuration (the paper's baseline)", {false, false}, true},
                        Row{"search, without deformation", {false, false}, false},
                        Row{"with deformation", {true, false}, false},
                        Row{"with deformation and turning", {true, true}, false}};
  std::printf(
      "\n## Coverage: 72 directions x 3 strengths (0.5, 0.9, 1.3 m/s) x 5 places x %zu "
      "states\n\nAnswered: Q over 0.5, and the pushed joint reaches the asked velocity "
      "within 10 %% and 15 degrees. All rows have the same pushes and states.\n\n"
      "| | answered | 95 %% interval over states | more than the row above, interval |\n"
      "| --- | --- | --- | --- |\n",
      states.size());
  std::array<PushCandidate, 8> best{};
  std::vector<double> above;
  for (const Row& row : rows) {
    std::vector<double> shares;
    for (const State& state : states) {
      std::size_t answered = 0, whole = 0;
      for (const Role place : motion::kPushPlaces) {
        for (int direction = 0; direction < 72; ++direction) {
          for (const float speed : {0.5F, 0.9F, 1.3F}) {
            const Eigen::Vector3f asked = horizontal(speed, 5 * static_cast<float>(direction));
            ++whole;
            std::size_t count = 1;
            if (row.is_baseline) {
              best[0] = nearest_response(study, state, place, asked);
              const auto& basis = study.realism;
              const auto character = models::components_of(
                  basis, std::span(state.configuration.data(), basis.mean.size()));
              best[0].realism = models::estimate_realism(
                  basis,
                  realism_features(
                      character, study.model.components[static_cast<std::size_t>(best[0].response)],
                      best[0], asked));
            } else {
              count = runtime::search_push(study.responses, study.model, state.configuration, place,
                                           asked, row.options, memory, best);
            }
            answered += answer_of(study, state, std::span(best).first(count), place, asked,
                                  row.options.deforms)
                            ? 1
                            : 0;
          }
        }
      }
      shares.push_back(share(answered, whole));
    }
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

void print_agreement(const Study& study) {
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
double slow_search_us(const Study& study, const State& state, Role place,
                      const Eigen::Vector3f& asked, float& checksum) {
  const double begin_s = bench::thread_cpu_s();
  const auto character = models::components_of(
      study.realism, std::span(state.configuration.data(), study.realism.mean.size()));
  for (std::size_t i = 0; i < study.responses.responses.size(); ++i) {
    PushCandidate candidate = runtime::deformed_candidate(study.responses, i, place, asked);
    for (const float taper : runtime::kTapers) {
      candidate.taper = taper;
      checksum += models::estimate_realism(
          study.realism, realism_features(character, study.model.components[i], candidate, asked));
    }
  }
  return 1e6 * (bench::thread_cpu_s() - begin_s);
}

void print_speed(const Study& study, const std::vector<State>& states,
                 std::span<std::byte> memory) {
  std::vector<double> queries_us, slow_us, frames_us, begins_us;
  std::array<PushCandidate, 8> best{};
  float checksum = 0;
  for (const State& state : states) {
    for (int k = 0; k < 40; ++k) {
      const Eigen::Vector3f asked = horizontal(0.9F, 9 * static_cast<float>(k));
      const Role place = motion::kPushPlaces[static_cast<std::size_t>(k) % 5];
      double begin_s = bench::thread_cpu_s();
      runtime::search_push(study.responses, study.model, state.configuration, place, asked, {},
                           memory, best);
      queries_us.push_back(1e6 * (bench::thread_cpu_s() - begin_s));
      if (k == 0) slow_us.push_back(slow_search_us(study, state, place, asked, checksum));
      begin_s = bench::thread_cpu_s();
      const auto answer = answer_of(study, state, best, place, asked, true);
      begins_us.push_back(1e6 * (bench::thread_cpu_s() - begin_s));
      const PushMotion motion =
          answer ? answer->motion : motion_for(study, state, best[0], place, asked);
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
              study.responses.responses.size(), runtime::kTapers.size(), study.realism.size(),
              quantile(queries_us, 0.5), quantile(queries_us, 0.99));
  std::printf("| the same by comparing with every example | %.0f us | %.0f us |\n",
              quantile(slow_us, 0.5), quantile(slow_us, 0.99));
  std::printf("| matching the velocity of the best candidates | %.0f us | %.0f us |\n",
              quantile(begins_us, 0.5), quantile(begins_us, 0.99));
  std::printf("| a frame | %.1f us | %.1f us |\n", frame_us, quantile(frames_us, 0.99));
  std::printf("| 20 characters at 60 Hz, share of a core | %.2f %% | |\n",
              20 * 60 * frame_us * 1e-4);
}

void print_responses(const Study& study) {
  std::vector<double> speeds, rises;
  std::size_t front = 0, behind = 0, side = 0;
  for (const runtime::PushResponse& response : study.responses.responses) {
    const motion::Push& push = *study.library.clip(response.clip).push;
    speeds.push_back(double{push.velocity.norm()});
    rises.push_back(double{response.rise_s});
    const float off = angle_deg(push.velocity, Eigen::Vector3f::UnitX());
    ++(off < 45 ? behind : off > 135 ? front : side);
  }
  std::printf(
      "\n## Responses\n\n| responses | from the front, behind, a side | speed: median, min, "
      "max | contact to peak: median, min, max |\n| --- | --- | --- | --- |\n| %zu | %zu, "
      "%zu, %zu | %.2f, %.2f, %.2f m/s | %.2f, %.2f, %.2f s |\n",
      speeds.size(), front, behind, side, quantile(speeds, 0.5), quantile(speeds, 0),
      quantile(speeds, 1), quantile(rises, 0.5), quantile(rises, 0), quantile(rises, 1));
}

void label(Study& study, std::size_t count) {
  const train::ProxyJudge judge(study.responses);
  std::vector<train::Label> labels = train::proxy_labels(study.responses, judge, count, 1);
  std::vector<double> qualities;
  for (const train::Label& one : labels) qualities.push_back(double{one.quality});
  const auto good = std::ranges::count_if(qualities, [](double q) { return q > 0.5; });
  std::printf(
      "\n## Labels\n\n| labels | good | Q: p10, median, p90 |\n| --- | --- | --- |\n| %zu | "
      "%.1f %% | %.2f, %.2f, %.2f |\n",
      count, share(static_cast<std::size_t>(good), count), quantile(qualities, 0.1),
      quantile(qualities, 0.5), quantile(qualities, 0.9));
  study.labels = train::configurations_of(study.responses, std::move(labels));
}

void run(const bench::StudyArguments& arguments) {
  Study study;
  study.library = database::load_library(arguments.text(0));
  study.prepared = runtime::prepare(study.library);
  study.responses = runtime::prepare_push_responses(study.prepared);
  if (study.responses.responses.empty()) throw Error(arguments.text(0), "has no pushes");
  print_responses(study);
  print_offset();
  label(study, arguments.number_or<std::size_t>(1, 1500));
  study.realism =
      train::fit_realism(study.labels, train::RealismKind::ours, std::string(train::kProxyJudge));
  study.model = runtime::prepare_push_model(study.responses, &study.realism);
  std::vector<std::byte> memory(study.model.memory_bytes);
  print_speed(study, everyday_states(study, 20), memory);
  print_fidelity(study, everyday_states(study, 10), memory);
  print_coverage(study, everyday_states(study, 20), memory);
  print_agreement(study);
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"push_study LIBRARY [LABELS]", 1, 2},
                                   flinch::run);
}

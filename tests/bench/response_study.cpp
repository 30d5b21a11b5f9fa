// SPDX-License-Identifier: MIT
// Measures the responses of all clips of a library to random threats:
//
//     response_study LIBRARY [THREATS]
//
// and prints what docs/response.md quotes.
#include <algorithm>
#include <cstdio>
#include <random>
#include <vector>

#include "database/files/library_writer.h"
#include "lookahead/oracle/response_motion.h"
#include "motion/rotation.h"
#include "motion/support_polygon.h"
#include "runtime/response/prepared_library.h"
#include "tests/bench/measures.h"
#include "tests/bench/study.h"
#include "tests/runtime/response/response_quality.h"

namespace flinch {
namespace {

struct Row {
  float value = 0;
  std::string what;  // description of the response
};

void print_rows(const char* name, const char* unit, float scale, std::vector<Row> rows) {
  if (rows.empty()) return;
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.value < b.value; });
  const auto at = [&](double share) {
    return scale * rows[bench::quantile_index(rows.size(), share)].value;
  };
  std::printf("| %s, %s | %zu | %.3g | %.3g | %.3g | %.3g | %s |\n", name, unit, rows.size(),
              double{at(0.5)}, double{at(0.95)}, double{at(0.99)}, double{at(1)},
              rows.back().what.c_str());
}

/// A response in which no foot leaves the ground before the peak, with the weight shifted over the
/// support foot all the same, as Zordan et al. do.
runtime::Response with_shift(const runtime::Response& planned) {
  constexpr float kShift_s = 0.3F;  // as weight_shift.cpp has them
  constexpr float kBack_s = 0.45F;
  constexpr float kMargin_m = 0.015F;
  constexpr float kOvershoot = 1.17F;
  constexpr float kDip = 0.2F;
  const runtime::PreparedLibrary& library = *planned.library;
  const runtime::Sole& sole = library.soles[planned.support];
  const motion::JointFrames frames =
      motion::forward_kinematics(library.skeleton(), runtime::pose_at(planned, planned.begin_s));
  const motion::FootPose foot = motion::foot_pose(frames, planned.support);
  const Eigen::Quaternionf heading =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::yaw_of(foot.orientation));
  const Eigen::Vector2f centre =
      (heading.conjugate() * (motion::centre_of_mass(library.body_model, frames) - foot.ankle))
          .head<2>();
  const Eigen::Vector2f missing =
      motion::fraction_to_inside(kMargin_m, sole.hull, centre, sole.middle) *
      (sole.middle - centre);
  runtime::Response shifted = planned;
  runtime::WeightShift& shift = shifted.shifts[0];
  shift.interval = {planned.begin_s - kShift_s, planned.begin_s + kBack_s};
  shift.hold = {planned.begin_s, planned.begin_s};
  shift.pelvis = kOvershoot * (heading * Eigen::Vector3f(missing.x(), missing.y(), 0));
  shift.pelvis.z() = -kDip * shift.pelvis.norm();
  shifted.first_motion_s = shift.interval.begin_s;
  return shifted;
}

/// What a weight shift would cost where both feet stay.
void print_shifts(const runtime::PreparedLibrary& library) {
  constexpr float kImpact_s = 1;
  std::vector<double> way_m, work;
  int stay = 0;
  int clips = 0;
  for (int clip = 0; clip < static_cast<int>(library.library->clips.size()); ++clip) {
    if (!library.clip(clip).annotation) continue;
    ++clips;
    const runtime::Response planned = runtime::make_response(library, {}, clip, kImpact_s);
    if (!planned.shifts[0].pelvis.isZero(0)) continue;
    ++stay;
    const runtime::Response shifted = with_shift(planned);
    way_m.push_back(double{shifted.shifts[0].pelvis.head<2>().norm()});
    work.push_back(lookahead::response_work_j(library, shifted) /
                   lookahead::response_work_j(library, planned));
  }
  std::printf(
      "\nIn %d of %d responses no weight is shifted. A shift over the support foot would move the "
      "pelvis by %.1f cm in the median, %.1f in 95 %%, and multiply the work by %.2f, %.2f.\n",
      stay, clips, 100 * bench::quantile(way_m, 0.5), 100 * bench::quantile(way_m, 0.95),
      bench::quantile(work, 0.5), bench::quantile(work, 0.95));
}

void run(const bench::StudyArguments& arguments) {
  const database::ClipLibrary library = database::load_library(arguments.text(0));
  const int threats = arguments.number_or(1, 200);
  const runtime::PreparedLibrary prepared = runtime::prepare(library);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> part(0, 1);
  std::vector<Row> slip, added, below, seam, lift, extrapolated, peak;
  for (int clip = 0; clip < static_cast<int>(library.clips.size()); ++clip) {
    const motion::Clip& played = library.clip(clip);
    if (!played.annotation || clip == library.idle) continue;
    for (int i = 0; i < threats; ++i) {
      const float time_s = 0.25F + 0.95F * part(random);
      const features::CharacterState state{
          8 * part(random), {2 * part(random), -part(random)}, 6.28F * part(random) - 3.14F};
      const runtime::Response response = runtime::make_response(prepared, state, clip, time_s);
      const tests::ResponseQuality q = tests::measure_response(response, time_s);
      const std::string what = played.name + " at " + std::to_string(time_s);
      slip.push_back({q.support_slip_m, what});
      added.push_back({std::max(q.support_slip_m - q.clip_slip_m, 0.0F), what});
      below.push_back({q.below_ground_m, what});
      seam.push_back({q.seam_share, what + ": " + q.seam});
      if (q.lift_margin_m < 1) {
        lift.push_back({-q.lift_margin_m, what + ", lifts at " + std::to_string(q.lift_s)});
        extrapolated.push_back({-q.extrapolated_margin_m, what});
      }
      if (q.peak_error_s) peak.push_back({*q.peak_error_s, what});
    }
  }
  std::printf(
      "| measure | responses | median | p95 | p99 | worst | of |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n");
  print_rows("slip of the support foot", "mm", 1e3F, slip);
  print_rows("beyond the slip of the clip itself", "mm", 1e3F, added);
  print_rows("foot below ground", "mm", 1e3F, below);
  print_rows("velocity step at a seam", "of the clip's 99th percentile", 1, seam);
  print_rows("centre of mass beyond the standing sole when the other foot lifts", "mm", 1e3F, lift);
  print_rows("extrapolated centre of mass beyond it, then", "mm", 1e3F, extrapolated);
  print_rows("peak from impact, where there is time", "frames of 1/60 s", 60, peak);
  print_shifts(prepared);
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"response_study LIBRARY [THREATS]", 1, 2},
                                   flinch::run);
}

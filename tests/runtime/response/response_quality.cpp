// SPDX-License-Identifier: MIT
#include "tests/runtime/response/response_quality.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/rotation.h"
#include "motion/support_polygon.h"
#include "runtime/response/prepared_library.h"

namespace flinch::tests {
namespace {

using motion::JointFrames;
using motion::Pose;
using motion::Role;
using motion::Side;
using runtime::PreparedLibrary;
using runtime::Response;

constexpr float kRate = 120;         // Hz, of the measurements
constexpr float kOnGround = 0.005F;  // m
constexpr float kFrame = 1.0F / 60;  // s, interval of velocities

// Distance of a point inside a sole's outline, seen from above, m.
float margin_in_sole(const PreparedLibrary& library, const JointFrames& frames, Side side,
                     const Eigen::Vector3f& point) {
  const motion::FootPose foot = motion::foot_pose(frames, side);
  const Eigen::Quaternionf heading =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::yaw_of(foot.orientation));
  const Eigen::Vector3f local = heading.conjugate() * (point - foot.ankle);
  return motion::signed_distance_inside(library.soles[side].hull, local.head<2>());
}

// The centre of mass, and where it would come to rest if the body fell as a pendulum over the point
// below: x + v / w0, w0 = sqrt(g / height), the extrapolated centre of mass of Hof et al. (2005).
struct Centre {
  Eigen::Vector3f place;
  Eigen::Vector3f extrapolated;
};

Centre centre_at(const Response& r, float time_s) {
  constexpr float kGravity = 9.81F;
  const auto place_at = [&](float t) {
    return motion::centre_of_mass(
        r.library->body_model,
        motion::forward_kinematics(r.library->skeleton(), runtime::pose_at(r, t)));
  };
  const Eigen::Vector3f place = place_at(time_s);
  const Eigen::Vector3f velocity = (place - place_at(time_s - kFrame)) / kFrame;
  return {place, place + std::sqrt(place.z() / kGravity) * velocity};
}

// Tracks the points of a sole on the ground while their foot carries more weight.
struct SoleTrack {
  std::vector<std::optional<Eigen::Vector3f>> landed;
  float slip_m = 0;

  void follow(const std::vector<Eigen::Vector3f>& points, bool supports) {
    landed.resize(points.size());
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (!supports || points[p].z() > kOnGround) {
        landed[p].reset();
      } else if (!landed[p]) {
        landed[p] = points[p];
      } else {
        slip_m = std::max(slip_m, (points[p] - *landed[p]).head<2>().norm());
      }
    }
  }
};

// Both soles at one time.
struct Standing {
  motion::PerSide<std::vector<Eigen::Vector3f>> points;
  motion::PerSide<bool> stands{};
  std::optional<Side> support;  // the standing foot nearer to the centre of mass
};

Standing standing_of(const PreparedLibrary& library, const JointFrames& frames) {
  Standing standing;
  for (Side side : motion::kSides) {
    standing.points[side] = motion::sole_points(library.soles[side], frames, side);
    standing.stands[side] = motion::lowest_z(standing.points[side]) <= kOnGround;
  }
  standing.support = motion::support_foot(
      motion::centre_of_mass(library.body_model, frames),
      [&](Side side) { return standing.stands[side]; },
      [&](Side side) { return motion::foot_pose(frames, side).ankle; });
  return standing;
}

float slip_of(const PreparedLibrary& library, const motion::Clip& clip) {
  motion::PerSide<SoleTrack> tracks;
  for (float t = clip.annotation->onset_s; t <= clip.annotation->end_s; t += 1 / kRate) {
    const Standing standing = standing_of(
        library, motion::forward_kinematics(library.skeleton(), motion::sample(clip.motion, t)));
    for (Side side : motion::kSides) {
      tracks[side].follow(standing.points[side], standing.support == side);
    }
  }
  return std::max(tracks[Side::left].slip_m, tracks[Side::right].slip_m);
}

void measure_feet(const Response& r, ResponseQuality& quality) {
  const PreparedLibrary& library = *r.library;
  motion::PerSide<SoleTrack> tracks;
  motion::PerSide<bool> stood{true, true};
  for (int k = 0; static_cast<float>(k) <= (runtime::duration_s(r) + 0.1F) * kRate; ++k) {
    const float time_s = static_cast<float>(k) / kRate;
    const JointFrames frames =
        motion::forward_kinematics(library.skeleton(), runtime::pose_at(r, time_s));
    const Standing standing = standing_of(library, frames);
    for (Side side : motion::kSides) {
      tracks[side].follow(standing.points[side], standing.support == side);
      quality.below_ground_m =
          std::max(quality.below_ground_m, -motion::lowest_z(standing.points[side]));
      const bool leaves =
          stood[side] && !standing.stands[side] && standing.stands[motion::other(side)];
      const bool first = side != r.support && time_s < r.peak_s && quality.lift_margin_m == 1;
      const bool home = r.feet[side].return_lift_m > 0 && time_s > r.feet[side].return_step.begin_s;
      if (leaves && (first || home)) {
        const Centre centre = centre_at(r, time_s);
        const Side standing_foot = motion::other(side);
        const float margin = margin_in_sole(library, frames, standing_foot, centre.place);
        if (margin < quality.lift_margin_m) {
          quality.lift_margin_m = margin;
          quality.lift_s = time_s;
        }
        quality.extrapolated_margin_m =
            std::min(quality.extrapolated_margin_m,
                     margin_in_sole(library, frames, standing_foot, centre.extrapolated));
      }
      stood[side] = standing.stands[side];
    }
  }
  quality.support_slip_m = std::max(tracks[Side::left].slip_m, tracks[Side::right].slip_m);
}

// Change of a joint's velocity at a time: (q_+ q^-1 - q q_-^-1) / dt, as rotation vectors.
float velocity_step(const Pose& before, const Pose& at, const Pose& after, Role role, float dt_s) {
  const auto velocity = [&](const Pose& from, const Pose& to) {
    return motion::rotation_vector(to.rotation[role] * from.rotation[role].conjugate());
  };
  return (velocity(at, after) - velocity(before, at)).norm() / dt_s;
}

void measure_seam(const Response& r, float time_s, const char* name, float own,
                  ResponseQuality& quality) {
  if (!std::isfinite(time_s) || time_s < kFrame) return;
  const Pose before = runtime::pose_at(r, time_s - kFrame);
  const Pose at = runtime::pose_at(r, time_s);
  const Pose after = runtime::pose_at(r, time_s + kFrame);
  for (Role role : motion::kRoles) {
    const float share = velocity_step(before, at, after, role, kFrame) / own;
    if (share > quality.seam_share) {
      quality.seam_share = share;
      quality.seam = std::string(name) + ", " + std::string(motion::name_of(role)) + ", at " +
                     std::to_string(time_s);
    }
  }
}

}  // namespace

float velocity_step_of(const motion::Clip& clip, float playback_rate) {
  std::vector<float> steps;
  const float dt_s = kFrame * playback_rate;  // clip time per frame
  const float last_s = clip.motion.duration_s();
  for (float t = dt_s; t + dt_s <= last_s; t += dt_s) {
    const Pose before = motion::sample(clip.motion, t - dt_s);
    const Pose at = motion::sample(clip.motion, t);
    const Pose after = motion::sample(clip.motion, t + dt_s);
    float most = 0;
    for (Role role : motion::kRoles) {
      most = std::max(most, velocity_step(before, at, after, role, kFrame));
    }
    steps.push_back(most);
  }
  if (steps.empty()) return 0;
  std::sort(steps.begin(), steps.end());
  return steps[static_cast<std::size_t>(0.99F * static_cast<float>(steps.size() - 1))];
}

ResponseQuality measure_response(const Response& r, float time_to_impact_s) {
  ResponseQuality quality;
  measure_feet(r, quality);
  quality.clip_slip_m = slip_of(*r.library, r.library->clip(r.clip));
  const float own = velocity_step_of(r.library->clip(r.clip), r.playback_rate);
  measure_seam(r, r.first_motion_s, "start", own, quality);
  measure_seam(r, r.begin_s, "begin of the clip", own, quality);
  measure_seam(r, r.begin_s + r.blend_duration_s, "end of the blend", own, quality);
  measure_seam(r, r.end_s, "end of the clip", own, quality);
  measure_seam(r, runtime::duration_s(r), "back at idle", own, quality);
  for (const runtime::FootPlan& plan : r.feet) {
    if (plan.offset.yaw != 0 || !plan.offset.translation.isZero(0)) {
      measure_seam(r, plan.correction.begin_s, "step", own, quality);
      measure_seam(r, plan.correction.end_s, "end of step", own, quality);
    }
    measure_seam(r, plan.return_step.begin_s, "step home", own, quality);
    measure_seam(r, plan.return_step.end_s, "end of step home", own, quality);
  }
  for (const runtime::WeightShift& shift : r.shifts) {
    measure_seam(r, shift.interval.begin_s, "weight shift", own, quality);
    measure_seam(r, shift.hold.begin_s, "weight shifted", own, quality);
    measure_seam(r, shift.hold.end_s, "weight leaves", own, quality);
    measure_seam(r, shift.interval.end_s, "weight back", own, quality);
  }
  if (r.playback_rate < runtime::kMaxPlaybackRate) {
    quality.peak_error_s = std::abs(r.peak_s - time_to_impact_s);
  }
  return quality;
}

}  // namespace flinch::tests

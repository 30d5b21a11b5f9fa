// SPDX-License-Identifier: MIT
#include "runtime/response/brace.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"
#include "runtime/response/foot_plan.h"
#include "runtime/response/leaving_plan.h"
#include "runtime/response/prepared_library.h"
#include "runtime/response/response_plan.h"
#include "runtime/response/response_pose.h"
#include "runtime/response/return_plan.h"

namespace flinch::runtime {
namespace {

using motion::FootPose;
using motion::Side;

bool is_usable(const RuledThreat& threat) {
  return features::is_usable(threat.threat) && threat.target_point.allFinite() &&
         velocity_at(threat.threat, threat.time_to_impact_s).norm() > 0.01F &&
         threat.delay_s >= 0 && threat.delay_s < threat.time_to_impact_s;
}

// The threat as it will be at the impact, on the straight line on which it then comes: the thesis
// keeps the values at the collision.
database::AimedThreat aimed(const RuledThreat& threat) {
  database::AimedThreat at_impact{threat.threat, threat.target_point};
  at_impact.threat.velocity = velocity_at(threat.threat, threat.time_to_impact_s);
  at_impact.threat.position =
      threat.target_point - threat.time_to_impact_s * at_impact.threat.velocity;
  return at_impact;
}

// Equation 4.1, as far as there is time.
void set_brace_timing(const RuledThreat& threat, Response& r) {
  constexpr database::ThreatRange kRange;
  const Eigen::Vector3f velocity = aimed(threat).threat.velocity;
  const float speed =
      database::normalised(velocity.norm(), kRange.min_speed_mps, kRange.max_speed_mps);
  const Eigen::Vector3f facing =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), r.state.facing) * Eigen::Vector3f::UnitX();
  const float cosine = -facing.dot(velocity.normalized());
  r.begin_s = std::max(threat.time_to_impact_s - database::time_to_contact_s(speed, cosine),
                       threat.delay_s);
  r.peak_s = threat.time_to_impact_s;
  r.end_s = r.peak_s + database::kHold;
}

// Flat on the ground, below where they are.
motion::PerSide<FootPose> planted_feet(const Response& r, const motion::Pose& pose) {
  motion::PerSide<FootPose> feet;
  for (Side side : motion::kSides) {
    FootPose& foot = feet[side];
    foot = source_foot_in(r, side, pose);
    foot.ankle.z() = motion::measure_foot(r.library->skeleton(), side).ankle_height;
    foot.orientation =
        motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::yaw_of(foot.orientation));
  }
  return feet;
}

// The key poses start a little ahead in the motion, so that the body keeps its momentum.
void plan_brace(const RuledThreat& threat, Response& r) {
  const PreparedLibrary& library = *r.library;
  const motion::Figure figure{library.library->character, library.body_model};
  const database::AimedThreat at_impact = aimed(threat);
  const motion::Pose source = source_pose_at(r, r.begin_s);
  const motion::PerSide<FootPose> feet = planted_feet(r, source);
  r.brace.sustained =
      braced_pose(figure, source_pose_at(r, r.begin_s + database::kSustainedLookAhead), at_impact,
                  database::rule_controls(at_impact), feet);
  r.blend_duration_s = r.peak_s - r.begin_s;
  if (threat.startles && r.blend_duration_s > 2 * database::kStartle) {
    r.brace.startle_s = database::kStartle;
    r.blend_duration_s = database::kStartle;
    r.brace.startled = motion::with_feet(
        library.skeleton(),
        database::startle(figure, source_pose_at(r, r.begin_s + database::kStartleLookAhead),
                          at_impact),
        feet);
  }
  const Start start{source, clip_pose_at(r, r.begin_s)};
  for (Side side : motion::kSides) plan_foot(r, side, start);
  r.arcs_in = motion::shorter_arcs(start.source, start.clip);
  r.support = weight_bearing_foot(r, source);
  r.return_duration_s = database::kRecovery;
}

}  // namespace

// A pelvis takes most of the body along; the feet stay, so it must go a little farther. The thesis
// minimises equation 3.3 over the pelvis and the controls; moving the pelvis alone reaches the same
// place of the centre of mass and leaves the rules as they are.
motion::Pose braced_pose(const motion::Figure& figure, const motion::Pose& pose,
                         const database::AimedThreat& threat,
                         const database::RuleControls& controls,
                         const motion::PerSide<motion::FootPose>& feet) {
  constexpr float kOvershoot = 1.17F;
  constexpr float kNear_m = 1e-3F;
  constexpr int kRounds = 5;
  const database::ThreatGeometry geometry = database::threat_geometry(figure, pose, threat);
  const Eigen::Vector2f toward = geometry.to_threat.head<2>().normalized();
  const auto shifted = [&](const Eigen::Vector2f& shift_m) {
    motion::Pose moved = pose;
    moved.root_position.head<2>() += shift_m;
    return database::apply_rules(figure, moved, geometry, controls, feet);
  };
  const auto centre_of = [&](const motion::Pose& at) -> Eigen::Vector2f {
    return motion::centre_of_mass(figure.bodies, motion::forward_kinematics(figure.skeleton(), at))
        .head<2>();
  };
  Eigen::Vector2f shift_m = Eigen::Vector2f::Zero();
  motion::Pose braced = shifted(shift_m);
  const Eigen::Vector2f goal = centre_of(braced) + database::kBraceDistance * toward;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::Vector2f missing = goal - centre_of(braced);
    if (missing.norm() < kNear_m) break;
    shift_m += kOvershoot * missing;
    braced = shifted(shift_m);
  }
  return braced;
}

Response make_brace(const PreparedLibrary& library, const features::CharacterState& state,
                    const RuledThreat& threat, const Inertialization& inertialization) noexcept {
  Response r;
  if (!is_usable_start(library, state, threat.time_to_impact_s, inertialization) ||
      !is_usable(threat)) {
    return r;
  }
  r.library = &library;
  r.clip = kNoClip;
  r.state = state;
  r.rest = state;
  r.home = state;
  r.inertialization = inertialization;
  set_brace_timing(threat, r);
  const bool walked = walks(library, state, inertialization);
  if (walked) plan_leaving(r);
  plan_brace(threat, r);
  if (walked) r.home = features::later(library.stance_of(state).loop, state, r.leave_s);
  plan_return(r);
  r.first_motion_s = walked ? r.leave_s : r.begin_s;
  return r;
}

}  // namespace flinch::runtime

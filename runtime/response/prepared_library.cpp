// SPDX-License-Identifier: MIT
#include "runtime/response/prepared_library.h"

#include <utility>

namespace flinch::runtime {

PreparedLibrary prepare(const database::ClipLibrary& library, std::vector<Footwork> footwork) {
  PreparedLibrary prepared;
  prepared.library = &library;
  prepared.joint_limits = motion::human_joint_limits();
  prepared.leg_limits = {
      {{{&motion::joint_limits_named("left_hip"), &motion::joint_limits_named("left_ankle")},
        {&motion::joint_limits_named("right_hip"), &motion::joint_limits_named("right_ankle")}}}};
  for (const char* name : {"left_wrist", "right_wrist"}) {
    const motion::JointLimits& limits = motion::joint_limits_named(name);
    prepared.wrist_limits[limits.to] = &limits;
  }
  prepared.body_model = motion::make_body_model(library.character);
  const motion::Skeleton& skeleton = library.character.skeleton;
  for (motion::Side side : motion::kSides) {
    prepared.soles[side] = make_sole(skeleton, side);
  }
  const features::CollisionFigure figure =
      features::make_collision_figure(skeleton, prepared.body_model);
  prepared.reach_m = figure.reach_m;
  prepared.body_reach_m = figure.body_reach_m;
  const auto idle = static_cast<std::size_t>(library.idle);
  if (idle < library.clips.size() && !library.clips[idle].motion.poses.empty()) {
    for (const int clip : database::stance_clips(library)) {
      prepared.stances.push_back(prepare_stance(skeleton, prepared.body_model, prepared.soles, clip,
                                                database::loop_of(library, clip)));
    }
  }
  prepared.footwork = std::move(footwork);
  if (!prepared.footwork.empty()) return prepared;
  prepared.footwork.reserve(library.clips.size());
  for (const motion::Clip& clip : library.clips) {
    prepared.footwork.push_back(footwork_of(skeleton, prepared.body_model, prepared.soles, clip));
  }
  return prepared;
}

}  // namespace flinch::runtime

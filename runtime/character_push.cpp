// SPDX-License-Identifier: MIT
// How a character answers a push (Arikan et al. 2005, section 4).
#include <algorithm>

#include "motion/rotation.h"
#include "runtime/character.h"
#include "runtime/graph/motion_graph.h"
#include "runtime/pose_check.h"
#include "runtime/push/push_deformation.h"
#include "runtime/push/push_search.h"

namespace flinch::runtime {
namespace {

constexpr float kMinPush_mps = 0.05F;
constexpr float kMaxPush_mps = 20;

bool is_usable_push(motion::Role place, const Eigen::Vector3f& velocity) {
  return motion::is_push_place(place) && velocity.head<2>().norm() >= kMinPush_mps &&
         velocity.norm() <= kMaxPush_mps;  // false where a component is not a number
}

}  // namespace

Status Character::push(motion::Role place, const Eigen::Vector3f& push_velocity,
                       Workspace& workspace) noexcept {
  if (!library_->is_loaded()) return Status::not_loaded;
  if (!is_usable_push(place, push_velocity)) return Status::bad_push;
  const Eigen::Vector3f velocity(push_velocity.x(), push_velocity.y(), 0);
  const PushResponses& responses = library_->push_responses();
  const PushModel& model = library_->push_model();
  if (responses.responses.empty()) return Status::without_pushes;
  if (model.realism == nullptr) return Status::without_realism;
  if (workspace.memory().size() < library_->selection_bytes()) return Status::other_workspace;

  // Only a response to a threat has no poses before its beginning.
  const float step_s = kVelocityInterval_s;
  const auto now_s = static_cast<float>(time_s_);
  const motion::Pose now = pose_after(now_s);
  const motion::Pose before = is_responding() && now_s < step_s ? now : pose_after(now_s - step_s);
  const float facing = motion::facing(now);
  const Eigen::Vector3f asked =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), -facing) * velocity;
  const BodyConfiguration configuration =
      body_configuration(library_->prepared().skeleton(), before, now, step_s);
  push_candidate_count_ = search_push(responses, model, configuration, place, asked, {},
                                      workspace.memory(), push_candidates_);
  for (const PushCandidate& candidate : push_candidates()) {
    if (!(candidate.realism >= kGoodRealism)) break;
    const auto response = static_cast<std::size_t>(candidate.response);
    const PushDeformation deformation{
        place, candidate.taper,
        motion::rotation_about(Eigen::Vector3f::UnitZ(), facing) * candidate.deformation,
        responses.responses[response].rise_s};
    PushMotion motion =
        make_push_motion(responses, response, candidate.turn, deformation, before, now, step_s);
    if (!model.realism->theta) {  // the paper plays what its F says
      match_velocity(velocity, motion);
      if (!is_faithful(peak_velocity(motion, velocity), velocity)) continue;
    }
    begin_push(motion);
    return Status::ok;
  }
  return Status::no_good_answer;
}

void Character::begin_push(const PushMotion& motion) noexcept {
  push_ = motion;
  is_answering_push_ = true;
  if (walk_.graph != nullptr) {
    const GraphExit& exit = walk_.graph->exits[static_cast<std::size_t>(motion.clip)];
    walk_.leave_s = exit.leave_s - motion.contact_s;
    walk_.node = exit.node;
  }
  response_ = {};
  inertialization_ = {};
  delayed_clip_.reset();
  waiting_count_ = 0;
  time_s_ = 0;
  time_to_impact_s_ = std::numeric_limits<double>::infinity();
}

// The response has ended: the character goes from its last pose back to idle.
void Character::finish_push(float dt_s) noexcept {
  const PushMotion over = push_;
  const float step_s = std::clamp(dt_s, 1e-3F, kVelocityInterval_s);
  set_pose(pose_at(over, over.duration_s - step_s), pose_at(over, over.duration_s), step_s);
  settle();
}

}  // namespace flinch::runtime

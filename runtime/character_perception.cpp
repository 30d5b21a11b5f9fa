// SPDX-License-Identifier: MIT
// How a character perceives threats and answers them.
#include <algorithm>
#include <array>
#include <cmath>

#include "features/feature_layout.h"
#include "features/impact_prediction.h"
#include "runtime/character.h"
#include "runtime/pose_check.h"
#include "runtime/response/brace.h"
#include "runtime/response/prepared_library.h"
#include "runtime/selection.h"

namespace flinch::runtime {
namespace {

using motion::Pose;
using motion::Role;

constexpr double kMaxPoseAge_s = 0.1;  // of a pose after which the game's motion goes on

/// Whether a call that returns this was not refused.
bool is_answer(Status status) {
  return status == Status::ok || status == Status::misses || status == Status::unnoticed;
}

bool is_time_to_impact(float time_s) {
  return time_s > 0 && time_s <= features::kMaxHorizon_s;
}

/// The impact on a character that keeps its pose and moves along the ground.
features::PredictedImpact predict_impact(const features::Threat& threat,
                                         const features::CollisionFigure& figure, const Pose& now,
                                         const Eigen::Vector3f& drift_mps) noexcept {
  const features::PredictionOptions options;
  const auto pose_at = [&](float time_s) {
    Pose pose = now;
    pose.root_position += time_s * drift_mps;
    return pose;
  };
  const Eigen::Vector3f way = options.horizon_s * drift_mps;
  const features::MotionBounds bounds{now.root_position + 0.5F * way, 0.5F * way.norm(),
                                      drift_mps.norm()};
  return features::predict_impact(threat, figure, features::PredictedMotion(pose_at, bounds),
                                  options);
}

/// Where the character sees from.
Eigen::Vector3f eye_of(const motion::Skeleton& skeleton, const Pose& pose) {
  constexpr std::array kToHead{Role::pelvis, Role::abdomen, Role::chest, Role::neck, Role::head};
  return motion::forward_kinematics(skeleton, pose, kToHead).position[Role::head];
}

}  // namespace

void Character::limit_perception(const PerceptionLimits& limits, std::uint64_t seed) noexcept {
  limits_ = limits;
  seed_ = seed;
}

void Character::perceive_as(const Character& other) noexcept {
  limits_ = other.limits_;
  seed_ = other.seed_;
  threats_ = other.threats_;
}

Status Character::predict(const features::Threat& threat, Perception& perception) const noexcept {
  if (!library_->is_loaded()) return Status::not_loaded;
  if (!features::is_usable(threat)) return Status::bad_threat;
  const PreparedLibrary& library = library_->prepared();
  const Pose now = pose();
  const Eigen::Vector3f eye = eye_of(library.skeleton(), now);
  const Perceived seen = runtime::perceive(threat, eye, limits_, seed_, threats_);
  if (!seen.noticed) return Status::unnoticed;
  features::CharacterState state = current_state();
  const PreparedStance& stance = library.stance_of(state);
  const features::PredictedImpact impact =
      is_in_stance() ? features::predict_impact(seen.threat, library.figure(), stance.loop,
                                                stance.bounds, state)
                     : predict_impact(seen.threat, library.figure(), now, current_drift_mps());
  if (!is_in_stance() && stance.loop.travels()) state.stance = 0;  // where it comes to rest
  if (impact.outcome == features::Outcome::unusable) return Status::bad_threat;
  if (impact.outcome == features::Outcome::miss) return Status::misses;
  const float time_s = std::max(impact.time_to_impact_s, 1e-3F);
  if (!is_in_stance()) state.position += time_s * current_drift_mps().head<2>();
  perception = {{seen.threat, impact.aimed_at, time_s, state}, seen.delay_s};
  return Status::ok;
}

/// How a character goes on that walks or that the game animates; other characters come to rest.
Eigen::Vector3f Character::current_drift_mps() const noexcept {
  if (is_walking()) {
    const auto now_s = static_cast<float>(time_s_);
    const Eigen::Vector3f way =
        pose_after(now_s).root_position - pose_after(now_s - kVelocityInterval_s).root_position;
    return Eigen::Vector3f(way.x(), way.y(), 0) / kVelocityInterval_s;
  }
  const bool is_animated = !is_responding() && is_settling() && time_s_ < kMaxPoseAge_s;
  return is_animated ? drift_mps_ : Eigen::Vector3f(Eigen::Vector3f::Zero());
}

Status Character::notice(const features::Threat& threat, Perception& perception) noexcept {
  return counted(predict(threat, perception));
}

Notice Character::notice(std::span<const features::Threat> threats,
                         std::span<Perception> most_urgent) noexcept {
  if (!library_->is_loaded()) return {};
  Notice noticed{Status::misses};
  const std::uint64_t threats_before = threats_;
  for (const features::Threat& threat : threats) {
    Perception perception;
    const Status status = notice(threat, perception);
    if (!is_answer(status)) {
      threats_ = threats_before;
      return {status};
    }
    if (status == Status::unnoticed) noticed.status = status;
    if (status != Status::ok) continue;
    // Insertion into the most urgent so far; of equally urgent ones the first stays first.
    const auto first = most_urgent.begin();
    const auto end = first + static_cast<std::ptrdiff_t>(noticed.count);
    const auto at = std::upper_bound(
        first, end, perception, [](const Perception& sooner, const Perception& later) {
          return sooner.scenario.time_to_impact_s < later.scenario.time_to_impact_s;
        });
    const bool is_full = noticed.count == most_urgent.size();
    if (is_full) ++noticed.ignored;
    if (is_full && at == end) continue;
    std::move_backward(at, is_full ? end - 1 : end, is_full ? end : end + 1);
    *at = perception;
    if (!is_full) ++noticed.count;
  }
  if (noticed.count > 0) noticed.status = Status::ok;
  return noticed;
}

Status Character::perceive(std::span<const features::Threat> threats,
                           Workspace& workspace) noexcept {
  if (!library_->is_loaded()) return Status::not_loaded;
  if (workspace.memory().size() < library_->selection_bytes()) return Status::other_workspace;
  std::array<Perception, kMaxThreats> urgent{};
  const Notice noticed = notice(threats, urgent);
  if (noticed.count == 0) return noticed.status;
  std::array<Waiting, kMaxThreats - 1> waiting{};
  for (std::size_t i = 1; i < noticed.count; ++i) {
    std::array<models::Candidate, 1> best{};
    std::size_t count = 0;
    rank(urgent[i], workspace, best, count);
    waiting[i - 1] = {best[0].clip, urgent[i].scenario.target,
                      double{urgent[i].scenario.time_to_impact_s}};
  }
  const Status status = rank_and_answer(urgent[0], workspace);
  if (status != Status::ok) return status;
  waiting_ = waiting;
  waiting_count_ = noticed.count - 1;
  return Status::ok;
}

/// Begins the response to the next threat that leaves time for one.
void Character::answer_next() noexcept {
  while (waiting_count_ > 0) {
    const Waiting next = waiting_[0];
    std::move(waiting_.begin() + 1, waiting_.end(), waiting_.begin());
    const std::size_t left = --waiting_count_;
    if (next.time_to_impact_s < double{kMinBlend_s}) continue;
    if (begin(next.clip, static_cast<float>(next.time_to_impact_s)) != Status::ok) continue;
    waiting_count_ = left;
    target_ = next.target;
    time_to_impact_s_ = next.time_to_impact_s;
    return;
  }
}

Status Character::perceive(const features::Threat& threat, Workspace& workspace) noexcept {
  Perception perception;
  const Status status = predict(threat, perception);
  return counted(status == Status::ok ? rank_and_answer(perception, workspace) : status);
}

Status Character::perceive(const features::Threat& threat, motion::Target target,
                           float time_to_impact_s, Workspace& workspace) noexcept {
  if (!library_->is_loaded()) return Status::not_loaded;
  if (!features::is_usable(threat) || !is_time_to_impact(time_to_impact_s))
    return Status::bad_threat;
  const Eigen::Vector3f eye = eye_of(library_->prepared().skeleton(), pose());
  const Perceived seen = runtime::perceive(threat, eye, limits_, seed_, threats_);
  if (!seen.noticed) return counted(Status::unnoticed);
  const features::Scenario scenario{seen.threat, target, time_to_impact_s, current_state()};
  return counted(rank_and_answer({scenario, seen.delay_s}, workspace));
}

// A refused threat draws no random numbers: the next is perceived as if the call had not been made.
Status Character::counted(Status status) noexcept {
  if (is_answer(status)) ++threats_;
  return status;
}

Status Character::rank(const Perception& perception, Workspace& workspace,
                       std::span<models::Candidate> best, std::size_t& count) const noexcept {
  if (!library_->is_loaded() || library_->selector().clips.empty()) return Status::not_loaded;
  count = 0;
  if (best.empty()) return Status::ok;
  const features::FeatureVector x =
      features::feature_vector(library_->selector().layout, perception.scenario,
                               library_->prepared().figure_in(perception.scenario.state));
  const Selection selection =
      select(workspace, library_->selector(), x, perception.scenario.target, best);
  if (selection.status != SelectStatus::ok) return Status::other_workspace;
  count = selection.count;
  return Status::ok;
}

Response Character::plan(const Perception& perception, int clip) const noexcept {
  const float time_s = perception.scenario.time_to_impact_s - perception.delay_s;
  if (!library_->is_loaded() || !is_time_to_impact(time_s)) return {};
  features::CharacterState state = current_state();
  if (!is_responding() && !is_pushed())
    state = features::later(current_loop(), state, perception.delay_s);
  return make_response(library_->prepared(), state, clip, time_s, current_inertialization(state));
}

Status Character::answer(const Perception& perception, int clip,
                         std::span<const models::Candidate> candidates) noexcept {
  if (!library_->is_loaded()) return Status::not_loaded;
  const features::Scenario& scenario = perception.scenario;
  if (!is_time_to_impact(scenario.time_to_impact_s)) return Status::bad_threat;
  if (perception.delay_s > 0) {
    waiting_count_ = 0;
    delayed_clip_ = clip;
    delay_s_ = double{perception.delay_s};
  } else if (const Status status = begin(clip, scenario.time_to_impact_s); status != Status::ok) {
    return status;
  }
  candidate_count_ = std::min(candidates.size(), kMaxCandidates);
  std::copy_n(candidates.begin(), candidate_count_, candidates_.begin());
  target_ = scenario.target;
  time_to_impact_s_ = double{scenario.time_to_impact_s};
  return Status::ok;
}

Status Character::rank_and_answer(const Perception& perception, Workspace& workspace) noexcept {
  std::array<models::Candidate, kMaxCandidates> candidates{};
  std::size_t count = 0;
  const Status status = rank(perception, workspace, candidates, count);
  if (status != Status::ok) return status;
  return answer(perception, candidates[0].clip, std::span(candidates).first(count));
}

Status Character::respond(int clip, float time_to_impact_s) noexcept {
  if (!library_->is_loaded()) return Status::not_loaded;
  if (!is_time_to_impact(time_to_impact_s)) return Status::bad_threat;
  const Status status = begin(clip, time_to_impact_s);
  if (status == Status::ok) time_to_impact_s_ = double{time_to_impact_s};
  return status;
}

Response Character::plan_brace(const Perception& perception, bool startles) const noexcept {
  if (!library_->is_loaded()) return {};
  const features::Scenario& scenario = perception.scenario;
  const features::CharacterState state = current_state();
  const float time_s = scenario.time_to_impact_s;
  features::Threat threat = scenario.threat;
  if (threat.rod)
    threat = striking_ball(threat, time_s,
                           predict_character(library_->prepared().figure_in(state), state, time_s)
                               .target_centres[scenario.target]);
  return make_brace(library_->prepared(), state,
                    {threat, position_at(threat, time_s), time_s, perception.delay_s, startles},
                    current_inertialization(state));
}

Status Character::brace(const features::Threat& threat, bool startles) noexcept {
  Perception perception;
  const Status status = predict(threat, perception);
  if (status != Status::ok) return counted(status);
  const Response response = plan_brace(perception, startles);
  if (!is_valid(response)) return Status::bad_threat;
  begin(response);
  candidate_count_ = 0;
  target_ = perception.scenario.target;
  time_to_impact_s_ = double{perception.scenario.time_to_impact_s};
  return counted(Status::ok);
}

}  // namespace flinch::runtime

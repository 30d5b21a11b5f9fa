// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "database/library/library.h"
#include "runtime/push/push_search.h"
#include "train/realism/realism_fit.h"

// The pushes that push_study asks for, and what characters do about them.
namespace flinch::bench {

/// F and G, fitted to the labels.
struct PushModelOf {
  models::RealismModel realism;
  runtime::PushModel model;
};

struct PushStudy {
  database::ClipLibrary library;
  runtime::PreparedLibrary prepared;
  runtime::PushResponses responses;
  train::LabelledConfigurations labels;
  PushModelOf ours;
  PushModelOf paper;
};

/// The time between the two poses of a state, s.
inline constexpr float kStateStep_s = 1.0F / 240;

/// A character's state when it is pushed, and C_t.
struct State {
  motion::Pose before;
  motion::Pose now;
  runtime::BodyConfiguration configuration;
};

/// `count` states, spread over all idle and unannotated clips by their length.
std::vector<State> everyday_states(const PushStudy& study, std::size_t count);

/// A horizontal velocity, m/s and degrees from the facing.
Eigen::Vector3f horizontal(float speed, float degrees);

/// The angle between two vectors, degrees.
float angle_deg(const Eigen::Vector3f& a, const Eigen::Vector3f& b);

motion::JointFrames joints_of(const PushStudy& study, const motion::Pose& pose);

/// The response of a candidate; with `matches`, bent until the pushed joint has the asked velocity.
runtime::PushMotion push_motion_for(const PushStudy& study, const State& state,
                                    const runtime::PushCandidate& candidate, motion::Role place,
                                    const Eigen::Vector3f& asked, bool matches);

/// The velocity that is asked in the frame of the facing, in the world.
Eigen::Vector3f wanted_velocity(const State& state, const Eigen::Vector3f& asked);

struct Answer {
  runtime::PushCandidate candidate;
  runtime::PushMotion motion;
};

/// What Character::push() would play of these candidates, best first. Where F is the paper's, or
/// without `deforms`, the motion is as it is; the exact F plays only what reaches the asked
/// velocity.
std::optional<Answer> answer_of(const PushStudy& study, const runtime::PushModel& model,
                                const State& state,
                                std::span<const runtime::PushCandidate> candidates,
                                motion::Role place, const Eigen::Vector3f& asked, bool deforms);

/// The response of the nearest configuration, as it is.
runtime::PushCandidate nearest_response(const PushStudy& study, const State& state,
                                        motion::Role place, const Eigen::Vector3f& asked);

/// `part` of `whole`, %; 0 of nothing.
double percent(std::size_t part, std::size_t whole);

}  // namespace flinch::bench

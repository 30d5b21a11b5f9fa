// SPDX-License-Identifier: MIT
#include "tests/bench/push_fidelity.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"
#include "tests/bench/measures.h"

namespace flinch::bench {

using motion::Role;
using runtime::PushCandidate;
using runtime::PushMotion;

namespace {

/// Changes of joints' velocities from frame to frame, m/s.
std::vector<double> velocity_steps(const PushStudy& study, const std::vector<motion::Pose>& poses,
                                   float step_s) {
  std::vector<double> steps;
  for (std::size_t k = 2; k < poses.size(); ++k) {
    const auto a = joints_of(study, poses[k - 2]);
    const auto b = joints_of(study, poses[k - 1]);
    const auto c = joints_of(study, poses[k]);
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
double standing_slip_m(const PushStudy& study, const PushMotion& motion) {
  double worst = 0;
  for (const motion::Side side : motion::kSides) {
    const runtime::PushFoot& foot = motion.feet[side];
    if (!foot.stands || foot.fade.begin_s < 0.1F) continue;
    const Role ankle = motion::roles_of(side).foot;
    const auto clip_ankle = [&](float time_s) -> Eigen::Vector3f {
      return joints_of(study, motion::placed(motion::sample(study.prepared.clip(motion.clip).motion,
                                                            motion.contact_s + time_s),
                                             motion.yaw, motion.translation))
          .position[ankle];
    };
    const Eigen::Vector3f offset = foot.offset;
    for (float time_s = 0; time_s < std::min(foot.fade.begin_s, motion.duration_s);
         time_s += 1.0F / 60) {
      const Eigen::Vector3f shown = joints_of(study, pose_at(motion, time_s)).position[ankle];
      const Eigen::Vector3f rolled =
          foot.pivot + motion::rotation_about(Eigen::Vector3f::UnitZ(), foot.yaw) *
                           (clip_ankle(time_s) - foot.pivot);
      worst = std::max(worst, double{(shown - rolled - offset).head<2>().norm()});
    }
  }
  return worst;
}

/// The fastest velocity along the asked one within 0.65 s, over 1/15 s, from every 1/120 s.
Eigen::Vector3f fine_peak(const PushStudy& study, const PushMotion& motion,
                          const Eigen::Vector3f& wanted) {
  const auto place_at = [&](float time_s) {
    return joints_of(study, pose_at(motion, time_s)).position[motion.place];
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

/// Steps of joints' velocities at the push, as a share of the clip's own.
double seam_of(const PushStudy& study, const State& state, const PushMotion& motion) {
  // Two frames before the push and two after it.
  const std::vector<motion::Pose> shown{state.before, state.now, pose_at(motion, kStateStep_s),
                                        pose_at(motion, 2 * kStateStep_s)};
  const motion::Motion& clip = study.prepared.clip(motion.clip).motion;
  std::vector<motion::Pose> own;
  for (float t = 0; t < motion.duration_s; t += kStateStep_s)
    own.push_back(motion::sample(clip, motion.contact_s + t));
  return quantile(velocity_steps(study, shown, kStateStep_s), 1) /
         quantile(velocity_steps(study, own, kStateStep_s), 0.99);
}

double bone_error_m(const PushStudy& study, const motion::Pose& pose) {
  const motion::JointFrames frames = joints_of(study, pose);
  double worst = 0;
  for (const Role role : motion::kRoles) {
    if (role == Role::pelvis) continue;
    const double length =
        double{(frames.position[role] - frames.position[motion::kParents[role]]).norm()};
    worst =
        std::max(worst, std::abs(length - double{study.prepared.skeleton().offset[role].norm()}));
  }
  return worst;
}

void measure(const PushStudy& study, const State& state, const Answer& answer,
             const Eigen::Vector3f& asked, PushFidelity& fidelity) {
  const PushMotion& motion = answer.motion;
  const Eigen::Vector3f wanted = wanted_velocity(state, asked);
  const Eigen::Vector3f peak = fine_peak(study, motion, wanted);
  const bool is_right = runtime::is_faithful(peak, wanted);
  fidelity.speed_errors.push_back(std::abs(double{peak.head<2>().norm() / wanted.norm()} - 1) *
                                  100);
  fidelity.angle_errors.push_back(double{angle_deg({peak.x(), peak.y(), 0}, wanted)});
  fidelity.right += is_right ? 1 : 0;
  const Eigen::Vector3f& own =
      study.responses.responses[static_cast<std::size_t>(answer.candidate.response)]
          .velocity[runtime::push_place_index(motion.place)];
  if (angle_deg({own.x(), own.y(), 0}, asked) > 35) {
    ++fidelity.off;
    fidelity.off_right += is_right ? 1 : 0;
  }
  fidelity.slips_mm.push_back(1e3 * standing_slip_m(study, motion));
  fidelity.seams.push_back(seam_of(study, state, motion));
  fidelity.bone_error_m =
      std::max(fidelity.bone_error_m, bone_error_m(study, pose_at(motion, 0.2F)));
}

}  // namespace

PushFidelity measure_fidelity(const PushStudy& study, const runtime::PushModel& model,
                              const std::vector<State>& states) {
  PushFidelity fidelity;
  std::vector<std::byte> memory(model.memory_bytes);
  for (const State& state : states) {
    for (const Role place : motion::kPushPlaces) {
      for (int degrees = 0; degrees < 360; degrees += 15) {
        for (const float speed : {0.5F, 0.9F, 1.3F}) {
          ++fidelity.asked;
          const Eigen::Vector3f asked = horizontal(speed, static_cast<float>(degrees));
          std::array<PushCandidate, 8> best{};
          const std::size_t count = runtime::search_push(
              study.responses, model, state.configuration, place, asked, {}, memory, best);
          fidelity.good += best[0].realism > runtime::kGoodRealism ? 1 : 0;
          const auto answer =
              answer_of(study, model, state, std::span(best).first(count), place, asked, true);
          if (!answer) continue;
          ++fidelity.accepted;
          if (fidelity.accepted % 4 == 0) measure(study, state, *answer, asked, fidelity);
        }
      }
    }
  }
  return fidelity;
}

}  // namespace flinch::bench

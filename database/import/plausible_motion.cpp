// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "database/import/plausibility.h"
#include "database/library/library_bounds.h"
#include "database/quality/joint_positions.h"
#include "database/quality/quality.h"
#include "motion/error.h"

namespace flinch::database {
namespace {

using Eigen::Vector3f;
using motion::PerRole;
using motion::Role;

// How far a joint may be beyond its limit for half of a clip, degrees.
constexpr float kMaxUsualExcess_deg = 60;
// How far a sole may slip while it stands, m.
constexpr float kMaxSlip_m = 0.6F;
// Exporters put their pose into the first frames, not into the middle.
constexpr double kMaxLeadIn_s = 0.5;

std::string metres_text(float distance_m) {
  char text[32];
  const bool is_far = distance_m >= 1000;
  std::snprintf(text, sizeof text, is_far ? "%.1f km" : "%.2f m",
                static_cast<double>(is_far ? distance_m / 1000 : distance_m));
  return text;
}

// Frames of a source as joints' places in the world. Limbs follow from orientations relative to the
// T-pose and the lengths of their bones.
class SourceJoints {
 public:
  SourceJoints(const Source& source, const SourceMotion& motion) : motion_(motion) {
    for (Role role : motion::kRoles) {
      const double length_m = bone_length_m(source, role);
      length_[role] = std::isfinite(length_m) ? static_cast<float>(length_m) : 0.0F;
    }
  }

  JointPositions at(std::size_t number) const {
    const SourceFrame& frame = motion_.frames[number];
    JointPositions joints{};
    joints[Role::pelvis] = frame.hip_centre;
    joints[Role::chest] = frame.hip_centre + frame.trunk.chest;
    joints[Role::head] = frame.hip_centre + frame.trunk.head;
    joints[Role::left_upper_arm] = frame.hip_centre + frame.trunk.left_shoulder;
    joints[Role::right_upper_arm] = frame.hip_centre + frame.trunk.right_shoulder;
    for (Role upper : {Role::left_upper_arm, Role::right_upper_arm}) {
      const bool is_left = upper == Role::left_upper_arm;
      const Vector3f outward(0, is_left ? 1.0F : -1.0F, 0);
      const Role forearm = is_left ? Role::left_forearm : Role::right_forearm;
      const Role hand = is_left ? Role::left_hand : Role::right_hand;
      joints[forearm] = joints[upper] + bone(frame, upper, outward);
      joints[hand] = joints[forearm] + bone(frame, forearm, outward);
    }
    joints[Role::left_foot] = frame.foot[0].ankle;
    joints[Role::right_foot] = frame.foot[1].ankle;
    joints[Role::left_shin] = frame.foot[0].ankle + bone(frame, Role::left_shin, Vector3f::UnitZ());
    joints[Role::right_shin] =
        frame.foot[1].ankle + bone(frame, Role::right_shin, Vector3f::UnitZ());
    return joints;
  }

 private:
  Vector3f bone(const SourceFrame& frame, Role role, const Vector3f& direction) const {
    return frame.orientation[role] * (length_[role] * direction);
  }

  const SourceMotion& motion_;
  PerRole<float> length_{};
};

// Frames of a source from `first` to `last`, both included, from 0.
struct Part {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t count() const { return last - first + 1; }
};

Part part_of(const SourceMotion& motion, const Segment& segment) {
  const auto frame_at = [&](double time_s) {
    const auto number = static_cast<std::size_t>(std::lround(time_s / motion.frame_time_s));
    return std::min(number, motion.frames.size() - 1);
  };
  return {frame_at(segment.start_s), frame_at(segment.end_s)};
}

class FrameJudge {
 public:
  FrameJudge(const Source& source, const SourceMotion& motion, const Part& part)
      : joints_(source, motion),
        first_number_(static_cast<std::size_t>(source.report.first_frame)),
        frame_time_s_(motion.frame_time_s),
        part_(part) {
    JointPositions before = joints_.at(part.first);
    for (std::size_t frame = part.first; frame < part.last; ++frame) {
      const JointPositions after = joints_.at(frame + 1);
      if (pose_distance(before, after) > reach_m(1)) jumps_.push_back(frame);
      before = after;
    }
  }

  std::vector<std::string> notes() {
    judge_lead_in();
    judge_jumps();
    return notes_;
  }

 private:
  // How far a body can go in so many frames.
  float reach_m(std::size_t frames) const {
    return kMaxBodySpeed_mps * static_cast<float>(frame_time_s_) * static_cast<float>(frames);
  }
  float distance(std::size_t one, std::size_t other) const {
    return pose_distance(joints_.at(one), joints_.at(other));
  }

  // As the file numbers them, from 1.
  std::string number(std::size_t frame) const { return std::to_string(frame + first_number_); }
  std::string named(const Part& part) const {
    if (part.count() == 1) return "frame " + number(part.first);
    return "frames " + number(part.first) + " to " + number(part.last);
  }
  std::string kept(const Part& part) const {
    if (part.first == 1 && first_number_ == 1 && part.last == part_.last) return "--skip-first";
    return "--frames " + number(part.first) + ":" + number(part.last);
  }

  // The frames of a pose that was put before the recording: a T-pose, or one that the body leaves
  // faster than it can, and the frames in which it does.
  void judge_lead_in() {
    const std::size_t first = part_.first;
    const bool is_calibration = is_t_pose(joints_.at(first));
    std::size_t last = first;  // of the pose
    while (is_calibration && last < part_.last && is_t_pose(joints_.at(last + 1))) ++last;
    // A file that holds nothing but such a pose may be a rest file.
    if (last == part_.last) return;
    const auto lead_in = static_cast<std::size_t>(kMaxLeadIn_s / frame_time_s_);
    std::size_t left = last;  // the last frame before the recording
    for (std::size_t jump : jumps_) {
      if (jump <= last + lead_in) left = std::max(left, jump);
    }
    const bool is_left_at_once = !jumps_.empty() && jumps_.front() <= last + lead_in;
    if (!is_calibration && !is_left_at_once) return;
    if (!is_calibration) last = jumps_.front();
    std::string note = named({first, last}) + (first == last ? " is" : " are");
    if (is_calibration) note += " a T-pose";
    const float gap_m = distance(last, last + 1);
    if (gap_m > reach_m(1)) {
      note += std::string(is_calibration ? "," : "") + " " + metres_text(gap_m) + " from frame " +
              number(last + 1);
    }
    notes_.push_back(note + "; leave out what is not recorded with " +
                     kept({left + 1, part_.last}));
    std::erase_if(jumps_, [&](std::size_t jump) { return jump <= left; });
    part_.first = left + 1;
  }

  void judge_jumps() {
    if (jumps_.empty()) return;
    const std::size_t first = jumps_.front();
    const auto back = std::ranges::find_if(jumps_, [&](std::size_t jump) {
      return jump > first && distance(first, jump + 1) <= reach_m(jump + 1 - first);
    });
    const bool comes_back = back != jumps_.end();
    std::string note = comes_back ? named({first + 1, *back}) + ": the body is away by "
                                  : named({first, first + 1}) + ": the body jumps by ";
    note += metres_text(distance(first, first + 1));
    const auto told = comes_back ? back - jumps_.begin() + 1 : 1;
    const auto more = std::ssize(jumps_) - told;
    if (more > 0) note += ", and jumps " + std::to_string(more) + " times more";
    notes_.push_back(note + "; keep the longest part without jumps with " + kept(longest_part()));
  }

  Part longest_part() const {
    Part longest{part_.first, part_.first};
    std::size_t first = part_.first;
    const auto consider = [&](std::size_t last) {
      const Part part{first, last};
      if (part.count() > longest.count()) longest = part;
      first = last + 1;
    };
    for (std::size_t jump : jumps_) consider(jump);
    consider(part_.last);
    return longest;
  }

  SourceJoints joints_;
  std::size_t first_number_;  // of the file's frames, that of the source's first
  double frame_time_s_;
  Part part_;
  std::vector<std::size_t> jumps_;  // frames after which the body is elsewhere
  std::vector<std::string> notes_;
};

void judge_quality(const ClipQuality& quality, std::vector<std::string>& notes) {
  if (quality.usual_limit_excess_deg > kMaxUsualExcess_deg) {
    const auto excess_deg = std::lround(quality.usual_limit_excess_deg);
    notes.push_back(quality.usual_limit_joint + " is " + std::to_string(excess_deg) +
                    " degrees beyond its limit for half of the time; look at the roles with info, "
                    "correct them with --roles, or the standing pose with --rest");
  }
  // Where the body jumps, its feet do too.
  if (quality.support_drift_m > kMaxSlip_m && notes.empty()) {
    notes.push_back("a sole slips by " + metres_text(quality.support_drift_m) +
                    " while it stands; leave such frames out with --frames");
  }
}

// The last frame of the source before the clip is too far away, from 0; nothing if it never is.
std::optional<std::size_t> last_near_frame(const JudgedClip& judged) {
  const std::vector<motion::Pose>& poses = judged.clip.motion.poses;
  const auto far = std::ranges::find_if(poses, [](const motion::Pose& pose) {
    return !((pose.root_position.array().abs() <= kMaxDistance_m).all());
  });
  if (far == poses.end()) return std::nullopt;
  const double time_s =
      judged.segment.start_s +
      static_cast<double>(far - poses.begin()) / static_cast<double>(judged.clip.motion.rate_hz);
  return static_cast<std::size_t>(
      std::max(0.0, std::ceil(time_s / judged.motion.frame_time_s) - 1));
}

}  // namespace

void require_near(const std::string& where, const JudgedClip& judged) {
  const std::optional<std::size_t> last = last_near_frame(judged);
  if (!last) return;
  const std::vector<std::string> jumps =
      FrameJudge(judged.source, judged.motion, part_of(judged.motion, judged.segment)).notes();
  const auto first_number = static_cast<std::size_t>(judged.source.report.first_frame);
  const std::string way = jumps.empty() ? "keep the frames before with --frames :" +
                                              std::to_string(*last + first_number)
                                        : jumps.front();
  throw Error(where, "the clip \"" + judged.clip.name +
                         "\" goes farther than 1 km from where it starts, the most that a library "
                         "holds; " +
                         way + ", or frames in a manifest");
}

std::vector<std::string> judge_motion(const JudgedClip& judged) {
  const Part part = part_of(judged.motion, judged.segment);
  std::vector<std::string> notes = FrameJudge(judged.source, judged.motion, part).notes();
  judge_quality(measure_joints_and_feet(judged.figure, judged.clip, kJudged_hz), notes);
  return notes;
}

}  // namespace flinch::database

// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "database/import/plausibility.h"
#include "database/import/source_character.h"
#include "database/quality/quality.h"
#include "motion/error.h"
#include "motion/rotation.h"

namespace flinch::database {
namespace {

// Angles in radians are within a turn, 6.28, or little more.
constexpr double kMaxRadians = 7;
// Someone who moves turns some joint farther than this, 40 degrees; arms that hang do already.
constexpr double kMinRadians = 0.7;
// How far a joint may be beyond its limit for half of the time, degrees.
constexpr float kHumanExcess_deg = 10;

bool is_rotation(BvhChannel channel) {
  return channel >= BvhChannel::x_rotation;
}

// Calls use(index into values) for every angle, frame by frame, until it returns false.
template <class Use>
void for_each_angle(const Bvh& bvh, Use use) {
  const auto width = static_cast<std::size_t>(bvh.channel_count);
  for (std::size_t frame = 0; frame < bvh.values.size(); frame += width) {
    for (const BvhJoint& joint : bvh.joints) {
      for (std::size_t i = 0; i < joint.channels.size(); ++i) {
        const std::size_t at = frame + static_cast<std::size_t>(joint.first_channel) + i;
        if (is_rotation(joint.channels[i]) && !use(at)) return;
      }
    }
  }
}

// The search ends at the first angle above kMaxRadians.
double largest_angle(const Bvh& bvh) {
  double largest = 0;
  for_each_angle(bvh, [&](std::size_t at) {
    largest = std::max(largest, std::abs(bvh.values[at]));
    return largest <= kMaxRadians;
  });
  return largest;
}

Bvh read_as_radians(Bvh bvh) {
  for_each_angle(bvh, [&](std::size_t at) {
    bvh.values[at] = motion::degrees(bvh.values[at]);
    return true;
  });
  return bvh;
}

bool moves_like_a_human(Bvh bvh, SourceOptions options) try {
  options.frames = {};  // already chosen
  const Source source = analyse_source(std::move(bvh), options);
  const SourceMotion motion = source_motion(source);
  const motion::Figure figure = motion::make_figure(character_of(source));
  const Segment whole{0, motion.duration_s(), 0};
  motion::Clip clip;
  clip.motion = retarget(motion, figure.skeleton(), whole, kJudged_hz);
  const ClipQuality quality = measure_joints_and_feet(figure, clip, kJudged_hz);
  return quality.usual_limit_excess_deg <= kHumanExcess_deg &&
         judge_motion({source, motion, whole, figure, clip}).empty();
} catch (const Error&) {
  return false;
}

}  // namespace

std::vector<std::string> judge_angles(const Source& source, const SourceOptions& options) {
  if (source.report.kind != FileKind::bvh) return {};
  const double largest = largest_angle(source.bvh);
  if (largest < kMinRadians || largest > kMaxRadians ||
      !moves_like_a_human(read_as_radians(source.bvh), options)) {
    return {};
  }
  return {"no rotation is beyond " + std::to_string(static_cast<int>(std::ceil(largest))) +
          ", and the figure moves like a human if they are radians; BVH has degrees: multiply them "
          "by 57.2958"};
}

}  // namespace flinch::database

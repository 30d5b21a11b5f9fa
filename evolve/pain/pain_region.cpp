// SPDX-License-Identifier: MIT
#include "evolve/pain/pain_region.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flinch::evolve {
namespace {

using motion::Body;

constexpr PerPainRegion<std::string_view> kNames{"eyes",
                                                 "nose",
                                                 "face",
                                                 "head",
                                                 "neck",
                                                 "chest",
                                                 "stomach",
                                                 "pelvis",
                                                 "upper_arm",
                                                 "forearm_inside",
                                                 "forearm_outside",
                                                 "palm",
                                                 "back_of_hand",
                                                 "thigh",
                                                 "shin",
                                                 "foot"};

// Parts of the height of the head from chin (0) to crown (1). The eyes are half-way up; the three
// thirds of a face from chin to hairline end below the nose and at the brow. Breadths are those of
// mean adults: 3.2 cm between the eyes, 9.2 cm over both, a nose of 3.6 cm, a head of 23 cm.
struct Patch {
  float bottom;
  float top;
  float inner;  // distance from the middle, in heights of the head
  float outer;
};
constexpr Patch kEyes{0.44F, 0.56F, 0.07F, 0.20F};
constexpr Patch kNose{0.26F, 0.50F, 0, 0.08F};
constexpr float kHairline = 0.74F;
constexpr float kFaceAzimuth = 70 * std::numbers::pi_v<float> / 180;  // to either side

bool is_on(const Patch& patch, float height, float aside) {
  return height >= patch.bottom && height <= patch.top && aside >= patch.inner &&
         aside <= patch.outer;
}

PainRegion region_of_head(const motion::Shape& capsule, const Eigen::Vector3f& point) {
  const Eigen::Vector3f from_centre = point - capsule.centre;
  if (std::abs(std::atan2(from_centre.y(), from_centre.x())) > kFaceAzimuth)
    return PainRegion::head;
  const float head_height = 2 * (capsule.half_length + capsule.radius);
  const float height = 0.5F + from_centre.z() / head_height;
  const float aside = std::abs(from_centre.y()) / head_height;
  if (is_on(kEyes, height, aside)) return PainRegion::eyes;
  if (is_on(kNose, height, aside)) return PainRegion::nose;
  return height <= kHairline ? PainRegion::face : PainRegion::head;
}

}  // namespace

std::string_view name_of(PainRegion region) {
  return kNames[region];
}

std::optional<PainRegion> pain_region_named(std::string_view name) {
  const auto found = std::ranges::find(kPainRegions, name, [](PainRegion r) { return name_of(r); });
  return found == kPainRegions.end() ? std::nullopt : std::optional(*found);
}

std::vector<PainRegion> regions_of(Body body) {
  switch (body) {
    case Body::head:
      return {PainRegion::eyes, PainRegion::nose, PainRegion::face, PainRegion::head};
    case Body::neck:
      return {PainRegion::neck};
    case Body::chest:
      return {PainRegion::chest};
    case Body::abdomen:
      return {PainRegion::stomach};
    case Body::pelvis:
      return {PainRegion::pelvis};
    case Body::left_upper_arm:
    case Body::right_upper_arm:
      return {PainRegion::upper_arm};
    case Body::left_forearm:
    case Body::right_forearm:
      return {PainRegion::forearm_inside, PainRegion::forearm_outside};
    case Body::left_hand:
    case Body::right_hand:
      return {PainRegion::palm, PainRegion::back_of_hand};
    case Body::left_thigh:
    case Body::right_thigh:
      return {PainRegion::thigh};
    case Body::left_shin:
    case Body::right_shin:
      return {PainRegion::shin};
    case Body::left_foot:
    case Body::right_foot:
      break;
  }
  return {PainRegion::foot};
}

// In the rest pose the palms face down, and every joint's frame is the world's: the inside of a
// hand or forearm is below its middle.
PainRegion pain_region_at(const motion::BodyModel& bodies, Body body,
                          const Eigen::Vector3f& point) {
  const motion::Shape& shape = bodies[body].shape;
  const bool is_inside = point.z() < shape.centre.z();
  switch (body) {
    case Body::head:
      return region_of_head(shape, point);
    case Body::neck:
      return PainRegion::neck;
    case Body::chest:
      return PainRegion::chest;
    case Body::abdomen:
      return PainRegion::stomach;
    case Body::pelvis:
      return PainRegion::pelvis;
    case Body::left_upper_arm:
    case Body::right_upper_arm:
      return PainRegion::upper_arm;
    case Body::left_forearm:
    case Body::right_forearm:
      return is_inside ? PainRegion::forearm_inside : PainRegion::forearm_outside;
    case Body::left_hand:
    case Body::right_hand:
      return is_inside ? PainRegion::palm : PainRegion::back_of_hand;
    case Body::left_thigh:
    case Body::right_thigh:
      return PainRegion::thigh;
    case Body::left_shin:
    case Body::right_shin:
      return PainRegion::shin;
    case Body::left_foot:
    case Body::right_foot:
      break;
  }
  return PainRegion::foot;
}

}  // namespace flinch::evolve

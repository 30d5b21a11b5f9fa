// SPDX-License-Identifier: MIT
#include "evolve/pain/pain_region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "motion/body_distance.h"
#include "motion/default_character.h"
#include "motion/mirror.h"

namespace flinch::evolve {
namespace {

using Eigen::Vector3f;
using motion::Body;

class PainRegionTest : public testing::Test {
 protected:
  motion::Physique character_ = motion::default_character();
  motion::BodyModel bodies_ = make_body_model(character_);

  /// The region of the point of the head's surface at a height from the chin, m, and so far to the
  /// left; `forward` 1 for the front, -1 for the back.
  PainRegion on_head(float above_chin, float left, float forward) const {
    const motion::Shape& shape = bodies_[Body::head].shape;
    const float z = above_chin - shape.half_length - shape.radius;
    const float in_cap = std::max(std::abs(z) - shape.half_length, 0.0F);
    const float x = std::sqrt(shape.radius * shape.radius - in_cap * in_cap - left * left);
    EXPECT_TRUE(std::isfinite(x));
    return pain_region_at(bodies_, Body::head, shape.centre + Vector3f(forward * x, left, z));
  }
};

// By a man's face of 22.8 cm from chin to crown (the default character's): pupils 3.1 cm to either
// side, half-way up; the tip of the nose 8 cm above the chin, the mouth 4.5 cm, the forehead 15 cm.
TEST_F(PainRegionTest, OfAFaceAreWhereAFaceHasThem) {
  const motion::Shape& shape = bodies_[Body::head].shape;
  EXPECT_NEAR(2 * (shape.half_length + shape.radius), 0.228, 0.01);
  EXPECT_EQ(on_head(0.114F, 0.031F, 1), PainRegion::eyes);
  EXPECT_EQ(on_head(0.114F, -0.031F, 1), PainRegion::eyes);
  EXPECT_EQ(on_head(0.08F, 0, 1), PainRegion::nose);
  EXPECT_EQ(on_head(0.105F, 0, 1), PainRegion::nose);  // its bridge, between the eyes
  EXPECT_EQ(on_head(0.045F, 0, 1), PainRegion::face);
  EXPECT_EQ(on_head(0.08F, 0.04F, 1), PainRegion::face);  // a cheek
  EXPECT_EQ(on_head(0.15F, 0, 1), PainRegion::face);
  EXPECT_EQ(on_head(0.2F, 0, 1), PainRegion::head);
  EXPECT_EQ(on_head(0.114F, 0.031F, -1), PainRegion::head);
  EXPECT_EQ(on_head(0.08F, 0, -1), PainRegion::head);
  EXPECT_EQ(on_head(0.114F, shape.radius - 1e-4F, 1), PainRegion::head);  // an ear
}

TEST_F(PainRegionTest, OfHandsAndForearmsArePalmAndBackInTheRestPose) {
  for (const auto& [hand, forearm, sign] : {std::tuple{Body::left_hand, Body::left_forearm, 1.0F},
                                            {Body::right_hand, Body::right_forearm, -1.0F}}) {
    EXPECT_EQ(pain_region_at(bodies_, hand, {0, sign * 0.1F, -0.01F}), PainRegion::palm);
    EXPECT_EQ(pain_region_at(bodies_, hand, {0, sign * 0.1F, 0.01F}), PainRegion::back_of_hand);
    EXPECT_EQ(pain_region_at(bodies_, forearm, {0, sign * 0.1F, -0.03F}),
              PainRegion::forearm_inside);
    EXPECT_EQ(pain_region_at(bodies_, forearm, {0, sign * 0.1F, 0.03F}),
              PainRegion::forearm_outside);
  }
}

TEST_F(PainRegionTest, AreMirrorImagesOfEachOther) {
  for (const Body body : motion::kBodies) {
    const Body other = body_of(mirrored(role_of(body)));
    for (int i = 0; i < 500; ++i) {
      const Vector3f point = 0.2F * Vector3f::Random();
      EXPECT_EQ(pain_region_at(bodies_, body, point),
                pain_region_at(bodies_, other, {point.x(), -point.y(), point.z()}))
          << name_of(body);
    }
  }
}

TEST_F(PainRegionTest, HaveNamesThatAreFoundAgain) {
  std::set<std::string_view> names;
  for (const PainRegion region : kPainRegions) {
    EXPECT_EQ(pain_region_named(name_of(region)), region);
    names.insert(name_of(region));
  }
  EXPECT_EQ(names.size(), std::size_t{kPainRegionCount});
  EXPECT_EQ(pain_region_named("ear"), std::nullopt);
}

}  // namespace
}  // namespace flinch::evolve

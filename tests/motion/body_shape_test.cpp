// SPDX-License-Identifier: MIT
// Tests the bodies' outlines with points on their surfaces and a containment test that is
// independent of how the outlines are made.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "motion/body.h"
#include "motion/default_character.h"
#include "tests/motion/random_motion.h"

namespace flinch::motion {
namespace {

// Depth of a point, in the shape's own frame, inside the shape, m: negative outside.
float depth(const Shape& shape, const Eigen::Vector3f& point) {
  if (shape.kind == Shape::Kind::capsule) {
    const float on_axis = std::clamp(point.z(), -shape.half_length, shape.half_length);
    return shape.radius - (point - Eigen::Vector3f(0, 0, on_axis)).norm();
  }
  return (shape.half_extents - point.cwiseAbs()).minCoeff();
}

std::vector<Eigen::Vector3f> surface_points(const Shape& shape, std::mt19937& random, int count) {
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3f direction = tests::random_direction(random);
    if (shape.kind == Shape::Kind::capsule) {
      const float axis = tests::uniform(random, -shape.half_length, shape.half_length);
      points.push_back(shape.radius * direction + Eigen::Vector3f(0, 0, axis));
    } else {
      points.push_back(
          shape.half_extents.cwiseProduct(direction / direction.cwiseAbs().maxCoeff()));
    }
  }
  return points;
}

struct PlacedShape {
  Eigen::Isometry3f to_world;
};

PlacedShape place(const Physique& character, const BodyModel& model, Body body) {
  const JointFrames rest = forward_kinematics(character.skeleton, rest_pose(character.skeleton));
  const Shape& shape = model[body].shape;
  PlacedShape placed;
  placed.to_world.setIdentity();
  placed.to_world.translate(rest.position[role_of(body)]);
  placed.to_world.translate(shape.centre);
  placed.to_world.rotate(shape.orientation);
  return placed;
}

bool are_adjacent(Body a, Body b) {
  return parent_of(a) == b || parent_of(b) == a;
}

float deepest_overlap(const Physique& character, Body a, Body b, std::mt19937& random) {
  const BodyModel model = make_body_model(character);
  const Eigen::Isometry3f from_a =
      place(character, model, b).to_world.inverse() * place(character, model, a).to_world;
  float deepest = -1;
  for (const Eigen::Vector3f& point : surface_points(model[a].shape, random, 2000)) {
    deepest = std::max(deepest, depth(model[b].shape, from_a * point));
  }
  return deepest;
}

TEST(BodyShapes, NonAdjacentBodiesDoNotOverlapInTheRestPose) {
  std::mt19937 random(1);
  int pairs = 0;
  for (Sex sex : {Sex::female, Sex::male}) {
    Physique character = default_character();
    character.sex = sex;
    for (Body a : kBodies) {
      for (Body b : kBodies) {
        if (a == b || are_adjacent(a, b)) continue;
        EXPECT_LE(deepest_overlap(character, a, b, random), 1e-4F)
            << name_of(a) << " in " << name_of(b);
        ++pairs;
      }
    }
  }
  EXPECT_EQ(pairs, 2 * (17 * 16 - 2 * 16));
}

TEST(BodyShapes, AdjacentBodiesAlmostTouchInTheRestPose) {
  std::mt19937 random(2);
  const Physique character = default_character();
  for (Body body : kBodies) {
    const std::optional<Body> parent = parent_of(body);
    if (!parent) continue;
    const float gap = -std::max(deepest_overlap(character, body, *parent, random),
                                deepest_overlap(character, *parent, body, random));
    EXPECT_LT(gap, 0.03F) << name_of(body);
  }
}

TEST(BodyShapes, SolesLieOnTheGround) {
  const Physique character = default_character();
  const BodyModel model = make_body_model(character);
  for (Body foot : {Body::left_foot, Body::right_foot}) {
    const Eigen::Isometry3f to_world = place(character, model, foot).to_world;
    const Eigen::Vector3f& half = model[foot].shape.half_extents;
    for (float x : {-1.0F, 1.0F}) {
      for (float y : {-1.0F, 1.0F}) {
        const Eigen::Vector3f corner = half.cwiseProduct(Eigen::Vector3f(x, y, -1));
        EXPECT_NEAR((to_world * corner).z(), 0, 1e-6F);
      }
    }
  }
}

TEST(BodyShapes, HeadReachesFromChinToCrown) {
  const Physique character = default_character();
  const BodyModel model = make_body_model(character);
  const Shape& head = model[Body::head].shape;
  const float middle = place(character, model, Body::head).to_world.translation().z();
  const float half = head.half_length + head.radius;
  EXPECT_NEAR(middle + half, 1.75F, 1e-5F);                 // the crown
  EXPECT_NEAR(middle - half, 1.75F * (1 - 0.130F), 1e-5F);  // the chin, Drillis and Contini
}

// The volume of a limb, pi r^2 (2 h + 4 r / 3), times the density of muscle, 1060 kg/m^3.
TEST(BodyShapes, LimbVolumesMatchTheirMass) {
  const BodyModel model = make_body_model(default_character());
  for (Body body : {Body::left_upper_arm, Body::right_forearm, Body::left_shin}) {
    const Shape& shape = model[body].shape;
    const float volume = std::numbers::pi_v<float> * shape.radius * shape.radius *
                         (2 * shape.half_length + 4 * shape.radius / 3);
    EXPECT_NEAR(1060 * volume, model[body].mass_kg, 1e-3F * model[body].mass_kg);
  }
}

TEST(BodyShapes, CentresOfMassLieInsideTheShapes) {
  for (Sex sex : {Sex::female, Sex::male}) {
    Physique character = default_character();
    character.sex = sex;
    const BodyModel model = make_body_model(character);
    for (Body body : kBodies) {
      const Shape& shape = model[body].shape;
      const Eigen::Vector3f local =
          shape.orientation.conjugate() * (model[body].centre_of_mass - shape.centre);
      EXPECT_GT(depth(shape, local), 0) << name_of(body);
    }
  }
}

TEST(BodyShapes, ScaleWithTheCharacter) {
  Physique large = default_character();
  for (Role role : kRoles) {
    large.skeleton.offset[role] *= 1.2F;
    large.skeleton.tip[role] *= 1.2F;
  }
  large.mass_kg *= 1.2F * 1.2F * 1.2F;
  const BodyModel small_model = make_body_model(default_character());
  const BodyModel large_model = make_body_model(large);
  for (Body body : kBodies) {
    const Shape& a = small_model[body].shape;
    const Shape& b = large_model[body].shape;
    EXPECT_NEAR(b.radius, 1.2F * a.radius, 1e-4F);
    EXPECT_LT((b.half_extents - 1.2F * a.half_extents).norm(), 1e-4F);
    EXPECT_LT((large_model[body].centre_of_mass - 1.2F * small_model[body].centre_of_mass).norm(),
              1e-4F);
  }
}

TEST(BodyShapes, ZeroLengthBonesGetSmallShapes) {
  Physique character = default_character();
  for (Role role : {Role::abdomen, Role::head, Role::left_foot, Role::left_toes}) {
    character.skeleton.offset[role].setZero();
  }
  character.skeleton.tip[Role::left_toes].setZero();
  character.skeleton.tip[Role::left_hand].setZero();
  for (const BodyProperties& body : make_body_model(character)) {
    EXPECT_TRUE(body.centre_of_mass.allFinite());
    EXPECT_TRUE(body.shape.centre.allFinite());
    EXPECT_TRUE(body.shape.orientation.coeffs().allFinite());
    const float size = body.shape.kind == Shape::Kind::capsule ? body.shape.radius
                                                               : body.shape.half_extents.minCoeff();
    EXPECT_GT(size, 0.0003F);
  }
}

}  // namespace
}  // namespace flinch::motion

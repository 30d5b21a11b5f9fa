// SPDX-License-Identifier: MIT
#include "motion/skin/figure_skin.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <set>

#include "motion/body_distance.h"
#include "motion/default_character.h"
#include "motion/figure.h"
#include "tests/motion/random_motion.h"

namespace flinch::motion {
namespace {

using Eigen::Vector3f;
using Triangle = std::array<std::uint32_t, 3>;

constexpr std::size_t kMaxVertices = 6000;
constexpr int kPieces = 8;  // the body; two eyes, eyebrows and ears; the lips

std::vector<Triangle> all_triangles(const FigureSkin& skin) {
  std::vector<Triangle> all;
  for (const auto& some : skin.triangles) all.insert(all.end(), some.begin(), some.end());
  return all;
}

Physique scaled(Physique character, float scale) {
  character.mass_kg *= scale * scale * scale;
  for (Vector3f& offset : character.skeleton.offset) offset *= scale;
  for (Vector3f& tip : character.skeleton.tip) tip *= scale;
  return character;
}

// Characters of all kinds: by default, women, light and heavy, a child, bones in odd directions.
std::vector<Physique> characters() {
  const Physique common = default_character();
  std::vector<Physique> all{common, common, common, common, scaled(common, 0.55F)};
  all[1].sex = Sex::female;
  all[2].mass_kg = 45;
  all[3].mass_kg = 120;
  std::mt19937 random(1);
  for (int i = 0; i < 4; ++i) {
    all.push_back(common);
    all.back().skeleton = tests::with_crooked_bones(common.skeleton, random);
  }
  return all;
}

std::vector<Vector3f> posed(const FigureSkin& skin, const Physique& character, const Pose& pose) {
  const JointFrames rest = forward_kinematics(character.skeleton, rest_pose(character.skeleton));
  const JointFrames frames = forward_kinematics(character.skeleton, pose);
  std::vector<Vector3f> positions;
  for (std::size_t v = 0; v < skin.positions.size(); ++v) {
    Vector3f sum = Vector3f::Zero();
    for (std::size_t i = 0; i < kMaxSkinJoints; ++i) {
      const Role joint = skin.joints[v][i];
      sum += skin.weights[v][i] *
             (frames.position[joint] +
              frames.orientation[joint] * (skin.positions[v] - rest.position[joint]));
    }
    positions.push_back(sum);
  }
  return positions;
}

TEST(FigureSkin, IsAClosedSurfaceForEveryCharacter) {
  for (const Physique& character : characters()) {
    const FigureSkin skin = make_figure_skin(character);
    const std::size_t count = skin.positions.size();
    ASSERT_LE(count, kMaxVertices);
    ASSERT_EQ(skin.normals.size(), count);
    ASSERT_EQ(skin.joints.size(), count);
    ASSERT_EQ(skin.weights.size(), count);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    std::set<std::uint32_t> used;
    for (const auto& [a, b, c] : all_triangles(skin)) {
      ASSERT_LT(std::max({a, b, c}), count);
      used.insert({a, b, c});
      for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) ++edges[edge];
    }
    EXPECT_EQ(used.size(), count);
    for (const auto& [edge, passes] : edges) {
      EXPECT_EQ(passes, 1);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
    }
    // Euler's formula for pieces without holes.
    EXPECT_EQ(count + all_triangles(skin).size(), edges.size() / 2 + 2 * kPieces);
  }
}

// The body model's outlines have the volume of the mass at the density of muscle, but for head,
// trunk and hands.
TEST(FigureSkin, HasAboutTheVolumeOfItsMass) {
  const FigureSkin skin = make_figure_skin(default_character());
  double volume = 0;
  for (const auto& [a, b, c] : all_triangles(skin)) {
    volume += skin.positions[a].cross(skin.positions[b]).dot(skin.positions[c]) / 6;
  }
  EXPECT_NEAR(volume, 75.0 / 1060, 0.1 * 75 / 1060);
}

TEST(FigureSkin, WeightsOfEveryVertexAddUpToOne) {
  for (const Physique& character : characters()) {
    const FigureSkin skin = make_figure_skin(character);
    for (const auto& weights : skin.weights) {
      float sum = 0;
      float before = 1;
      for (const float weight : weights) {
        EXPECT_GE(weight, 0);
        EXPECT_LE(weight, before);
        sum += weight;
        before = weight;
      }
      EXPECT_NEAR(sum, 1, 1e-6F);
    }
  }
}

TEST(FigureSkin, EveryJointMovesSomeVertices) {
  const FigureSkin skin = make_figure_skin(default_character());
  PerRole<float> sums{};
  for (std::size_t v = 0; v < skin.positions.size(); ++v) {
    for (std::size_t i = 0; i < kMaxSkinJoints; ++i) sums[skin.joints[v][i]] += skin.weights[v][i];
  }
  for (const Role role : kRoles) EXPECT_GT(sums[role], 5) << name_of(role);
}

// Neighbours share most of their weights, so that bent joints stay smooth.
TEST(FigureSkin, WeightsChangeGraduallyAlongTheSurface) {
  const FigureSkin skin = make_figure_skin(default_character());
  const auto weights_of = [&](std::uint32_t v) {
    PerRole<float> all{};
    for (std::size_t i = 0; i < kMaxSkinJoints; ++i) all[skin.joints[v][i]] += skin.weights[v][i];
    return all;
  };
  for (const Triangle& triangle : all_triangles(skin)) {
    const PerRole<float> a = weights_of(triangle[0]);
    const PerRole<float> b = weights_of(triangle[1]);
    float change = 0;
    for (const Role role : kRoles) change += 0.5F * std::abs(a[role] - b[role]);
    EXPECT_LT(change, 0.5F) << skin.positions[triangle[0]].transpose();
  }
}

TEST(FigureSkin, NormalsAreUnitAndPointOutward) {
  for (const Physique& character : {characters()[0], characters()[4]}) {
    const FigureSkin skin = make_figure_skin(character);
    for (const Vector3f& normal : skin.normals) EXPECT_NEAR(normal.norm(), 1, 1e-5F);
    for (const auto& [a, b, c] : all_triangles(skin)) {
      const Vector3f area =
          (skin.positions[b] - skin.positions[a]).cross(skin.positions[c] - skin.positions[a]);
      EXPECT_GT(area.norm(), 1e-10F);
      // The webs between the fingers are too sharp for one normal.
      const bool is_hand =
          skin.joints[a][0] == Role::left_hand || skin.joints[a][0] == Role::right_hand;
      EXPECT_TRUE(is_hand || area.dot(skin.normals[a]) > 0) << skin.positions[a].transpose();
    }
  }
}

TEST(FigureSkin, HalvesOfASymmetricCharacterAreMirrorImages) {
  for (const Physique& character : characters()) {
    const FigureSkin skin = make_figure_skin(character);
    std::multimap<float, std::size_t> by_height;
    for (std::size_t v = 0; v < skin.positions.size(); ++v) {
      by_height.emplace(skin.positions[v].z(), v);
    }
    for (std::size_t v = 0; v < skin.positions.size(); ++v) {
      const auto mirror = [](const Vector3f& p) { return Vector3f(p.x(), -p.y(), p.z()); };
      const Vector3f position = mirror(skin.positions[v]);
      constexpr float kTolerance = 1e-5F;
      const auto end = by_height.upper_bound(position.z() + kTolerance);
      bool found = false;
      for (auto it = by_height.lower_bound(position.z() - kTolerance); it != end && !found; ++it) {
        const std::size_t other = it->second;
        if ((skin.positions[other] - position).norm() > kTolerance) continue;
        if ((skin.normals[other] - mirror(skin.normals[v])).norm() > 1e-3F) continue;
        PerRole<float> difference{};
        for (std::size_t i = 0; i < kMaxSkinJoints; ++i) {
          difference[skin.joints[other][i]] += skin.weights[other][i];
          difference[mirrored(skin.joints[v][i])] -= skin.weights[v][i];
        }
        found = std::all_of(difference.begin(), difference.end(),
                            [](float weight) { return std::abs(weight) < 1e-5F; });
      }
      ASSERT_TRUE(found) << "vertex at " << skin.positions[v].transpose();
    }
  }
}

// How often the surface winds around a point: the sum of the triangles' solid angles (van Oosterom
// and Strackee 1983) / 4 pi. 1 inside, 0 outside.
double winding(const std::vector<Vector3f>& positions, const std::vector<Triangle>& triangles,
               const Vector3f& point) {
  double sum = 0;
  for (const auto& [i, j, k] : triangles) {
    const Eigen::Vector3d a = (positions[i] - point).cast<double>();
    const Eigen::Vector3d b = (positions[j] - point).cast<double>();
    const Eigen::Vector3d c = (positions[k] - point).cast<double>();
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)),
                          la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (4 * std::numbers::pi);
}

// A point on the surface of an outline, in the frame of its joint.
Vector3f random_point_on(const Shape& shape, std::mt19937& random) {
  Vector3f point = tests::random_vector(random, 1);
  if (shape.kind == Shape::Kind::box) {
    Eigen::Index side = 0;
    point.cwiseAbs().maxCoeff(&side);
    point[side] = point[side] < 0 ? -1.0F : 1.0F;
    point = point.cwiseProduct(shape.half_extents);
  } else {
    const float along = tests::uniform(random, -1, 1) * (shape.half_length + shape.radius);
    const float axis = std::clamp(along, -shape.half_length, shape.half_length);
    const float across = std::sqrt(shape.radius * shape.radius - (along - axis) * (along - axis));
    const float angle = tests::uniform(random, 0, 6.28F);
    point = {across * std::cos(angle), across * std::sin(angle), along};
  }
  return shape.centre + shape.orientation * point;
}

struct Fit {
  float skin_outside = 0;     // of the outlines, at most, m
  float outline_outside = 0;  // of the skin, at most, m, at random points
};

Fit fit_of(const Physique& character, const Pose& pose, int points_per_body, std::mt19937& random) {
  const FigureSkin skin = make_figure_skin(character);
  const std::vector<Vector3f> positions = posed(skin, character, pose);
  const std::vector<Triangle> triangles = all_triangles(skin);
  const Figure figure = make_figure(character);
  const JointFrames frames = forward_kinematics(character.skeleton, pose);
  Fit fit;
  for (const Vector3f& position : positions) {
    fit.skin_outside = std::max(fit.skin_outside, distance_to_figure(figure, frames, position));
  }
  for (const Body body : kBodies) {
    for (int i = 0; i < points_per_body; ++i) {
      const Role joint = role_of(body);
      const Vector3f point =
          frames.position[joint] +
          frames.orientation[joint] * random_point_on(figure.bodies[body].shape, random);
      float nearest = std::numeric_limits<float>::infinity();
      for (const Vector3f& position : positions) {
        nearest = std::min(nearest, (position - point).norm());
      }
      if (nearest <= fit.outline_outside || winding(positions, triangles, point) > 0.5) continue;
      fit.outline_outside = nearest;
    }
  }
  return fit;
}

// What is seen is what is hit: the surface and the outlines that a ball meets are never far apart.
TEST(FigureSkin, FollowsTheOutlinesThatABallMeets) {
  std::mt19937 random(2);
  float worst_skin = 0;
  float worst_outline = 0;
  for (const Physique& character : characters()) {
    const float unit = stature(character.skeleton) / 1.75F;
    for (const float max_angle : {0.0F, 0.6F}) {
      Pose pose = rest_pose(character.skeleton);
      if (max_angle > 0) {
        for (Eigen::Quaternionf& rotation : pose.rotation) {
          rotation = tests::random_rotation(random, max_angle);
        }
      }
      const Fit fit = fit_of(character, pose, 40, random);
      worst_skin = std::max(worst_skin, fit.skin_outside / unit);
      worst_outline = std::max(worst_outline, fit.outline_outside / unit);
    }
  }
  RecordProperty("skin_outside_m", std::to_string(worst_skin));
  RecordProperty("outline_outside_m", std::to_string(worst_outline));
  EXPECT_LT(worst_skin, 0.05F);
  EXPECT_LT(worst_outline, 0.07F);
}

TEST(FigureSkin, StandsOnTheGroundAndReachesCrownFingertipsAndToes) {
  for (const Physique& character : {characters()[0], characters()[1], characters()[4]}) {
    const FigureSkin skin = make_figure_skin(character);
    const float height = stature(character.skeleton);
    Eigen::AlignedBox3f box;
    for (const Vector3f& position : skin.positions) box.extend(position);
    const JointFrames rest = forward_kinematics(character.skeleton, rest_pose(character.skeleton));
    const Vector3f fingertip =
        rest.position[Role::left_hand] + character.skeleton.tip[Role::left_hand];
    const Vector3f toes = rest.position[Role::left_toes] + character.skeleton.tip[Role::left_toes];
    EXPECT_NEAR(box.min().z(), 0, 0.002F * height);
    EXPECT_NEAR(box.max().z(), height, 0.01F * height);
    EXPECT_NEAR(box.max().y(), fingertip.y(), 0.01F * height);
    EXPECT_NEAR(box.max().x(), toes.x(), 0.01F * height);
  }
}

// The nose: the foremost point of the head, in the middle, between chin and brow.
TEST(FigureSkin, FacesForward) {
  const Physique character = default_character();
  const FigureSkin skin = make_figure_skin(character);
  Eigen::AlignedBox3f head;
  Vector3f nose = Vector3f::Constant(-1);
  for (std::size_t v = 0; v < skin.positions.size(); ++v) {
    if (skin.joints[v][0] != Role::head) continue;
    head.extend(skin.positions[v]);
    if (skin.positions[v].x() > nose.x()) nose = skin.positions[v];
  }
  EXPECT_NEAR(nose.y(), 0, 1e-5F);
  EXPECT_GT(nose.z(), head.min().z() + 0.2F * head.sizes().z());
  EXPECT_LT(nose.z(), head.center().z());
  EXPECT_GT(nose.x() - head.center().x(), head.center().y() - head.min().y());
  for (const auto& [a, b, c] : skin.triangles[Covering::eyes]) {
    EXPECT_GT(skin.positions[a].x(), head.center().x());
    EXPECT_GT(skin.positions[a].z(), nose.z());
  }
}

TEST(FigureSkin, IsFiniteForBonesWithoutLength) {
  Physique character = default_character();
  for (const Role role : {Role::left_hand, Role::right_hand, Role::left_foot, Role::right_toes,
                          Role::left_forearm, Role::right_shin, Role::neck}) {
    character.skeleton.offset[role].setZero();
    character.skeleton.tip[role].setZero();
  }
  const FigureSkin skin = make_figure_skin(character);
  for (const Vector3f& position : skin.positions) EXPECT_TRUE(position.allFinite());
}

}  // namespace
}  // namespace flinch::motion

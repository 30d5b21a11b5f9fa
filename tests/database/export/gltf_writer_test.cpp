// SPDX-License-Identifier: MIT
#include "database/export/gltf_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "database/files/file_io.h"
#include "glb_reader.h"
#include "motion/default_character.h"
#include "motion/skin/figure_skin.h"
#include "tests/motion/random_motion.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/not_finite.h"
#include "tests/scenes/synthetic_library.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::database {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;
using Eigen::Vector3f;
using motion::kRoles;
using motion::Role;
using testing::HasSubstr;
using tests::error_of;
using tests::Glb;
using tests::kNan;

// Rotation to glTF's axes, by its specification X left, Y up, Z forward, from ours: X forward, Y
// left, Z up.
Eigen::Matrix3d from_ours() {
  Eigen::Matrix3d matrix;
  matrix << Vector3d::UnitZ(), Vector3d::UnitX(), Vector3d::UnitY();
  return matrix;
}

motion::Motion random_motion(std::mt19937& random, int count) {
  motion::Motion motion;
  motion.rate_hz = 30;
  for (int k = 0; k < count; ++k) motion.poses.push_back(tests::random_pose(random));
  return motion;
}

motion::Physique crooked_character(std::mt19937& random) {
  motion::Physique character = motion::default_character();
  character.skeleton = tests::with_crooked_bones(character.skeleton, random);
  return character;
}

void expect_joints(const motion::Skeleton& skeleton, const motion::Pose& pose, const Glb& glb,
                   double time_s, const std::string& suffix = "") {
  const motion::JointFrames expected = forward_kinematics(skeleton, pose);
  const std::vector<Affine3d> scene = tests::scene_at(glb, time_s);
  for (const Role role : kRoles) {
    const auto node = static_cast<std::size_t>(
        tests::node_named(glb, std::string(motion::name_of(role)) + suffix));
    EXPECT_LT(
        (scene[node].translation() - from_ours() * expected.position[role].cast<double>()).norm(),
        1e-5)
        << motion::name_of(role) << " at " << time_s << " s";
    const Eigen::Matrix3d turn = expected.orientation[role].cast<double>().toRotationMatrix();
    EXPECT_LT((scene[node].linear() - from_ours() * turn * from_ours().transpose()).norm(), 1e-5)
        << motion::name_of(role);
  }
}

TEST(GltfWriter, JointsAreWhereForwardKinematicsPutsThem) {
  std::mt19937 random(1);
  for (int round = 0; round < 5; ++round) {
    const motion::Physique character = crooked_character(random);
    const motion::Motion motion = random_motion(random, 8);
    const Glb glb = tests::read_glb(make_glb(character, motion));
    for (std::size_t k = 0; k < motion.poses.size(); ++k) {
      expect_joints(character.skeleton, motion.poses[k], glb, static_cast<double>(k) / 30);
    }
  }
}

TEST(GltfWriter, JointsAreWhereTheMotionIsSampledBetweenItsPoses) {
  const ClipLibrary library = scenes::synthetic_library();
  for (const motion::Clip& clip : library.clips) {
    const Glb glb = tests::read_glb(make_glb(library.character, clip.motion));
    for (const float time_s : {0.004F, 0.123F, 0.49F, 0.777F}) {
      expect_joints(library.character.skeleton, sample(clip.motion, time_s), glb, double{time_s});
    }
  }
}

TEST(GltfWriter, QuaternionsAreUnitAndSignContinuous) {
  std::mt19937 random(2);
  motion::Motion motion = random_motion(random, 40);
  for (std::size_t k = 0; k < motion.poses.size(); k += 2) {
    for (Eigen::Quaternionf& rotation : motion.poses[k].rotation) {
      rotation.coeffs() *= -1.0005F;  // the same rotation, slightly off unit length
    }
  }
  const Glb glb = tests::read_glb(make_glb(motion::default_character(), motion));
  int seen = 0;
  for (const auto& channel : glb.document["animations"][0]["channels"]) {
    if (channel["target"]["path"] != "rotation") continue;
    const auto& sampler =
        glb.document["animations"][0]["samplers"].at(channel["sampler"].get<std::size_t>());
    const std::vector<double> keys = tests::numbers_of(glb, sampler["output"]);
    ASSERT_EQ(keys.size(), 4 * motion.poses.size());
    for (std::size_t k = 0; k < motion.poses.size(); ++k) {
      const Eigen::Map<const Eigen::Vector4d> key(keys.data() + 4 * k);
      EXPECT_NEAR(key.norm(), 1, 1e-6);
      const double* before = keys.data() + 4 * (k > 0 ? k - 1 : 0);
      EXPECT_GE(key.dot(Eigen::Map<const Eigen::Vector4d>(before)), 0) << k;
    }
    ++seen;
  }
  EXPECT_EQ(seen, motion::kRoleCount);
}

TEST(GltfWriter, SkinInTheBindPoseEqualsTheMesh) {
  std::mt19937 random(3);
  const motion::Physique character = crooked_character(random);
  const Glb glb = tests::read_glb(make_glb(character, random_motion(random, 2)));
  const std::vector<Affine3d> rest = tests::scene_at_rest(glb);
  const auto& attributes = glb.document["meshes"][0]["primitives"][0]["attributes"];
  const std::vector<double> mesh = tests::numbers_of(glb, attributes["POSITION"]);
  const std::vector<Vector3d> skinned = tests::skinned_positions(glb, 0, rest);
  ASSERT_GT(skinned.size(), 1000U);
  for (std::size_t i = 0; i < skinned.size(); ++i) {
    EXPECT_LT((skinned[i] - Eigen::Map<const Vector3d>(mesh.data() + 3 * i)).norm(), 1e-6);
  }
}

TEST(GltfWriter, SkinMovesWithTheJointsOfThePose) {
  std::mt19937 random(4);
  const motion::Physique character = crooked_character(random);
  const motion::Motion motion = random_motion(random, 3);
  const Glb glb = tests::read_glb(make_glb(character, motion));
  const motion::FigureSkin figure = motion::make_figure_skin(character);
  const motion::JointFrames rest =
      forward_kinematics(character.skeleton, motion::rest_pose(character.skeleton));
  for (std::size_t k = 0; k < motion.poses.size(); ++k) {
    const motion::JointFrames frames = forward_kinematics(character.skeleton, motion.poses[k]);
    const std::vector<Vector3d> skin =
        tests::skinned_positions(glb, 0, tests::scene_at(glb, static_cast<double>(k) / 30));
    ASSERT_EQ(skin.size(), figure.positions.size());
    for (std::size_t v = 0; v < skin.size(); ++v) {
      Vector3f expected = Vector3f::Zero();
      for (std::size_t i = 0; i < motion::kMaxSkinJoints; ++i) {
        const Role joint = figure.joints[v][i];
        expected += figure.weights[v][i] *
                    (frames.position[joint] +
                     frames.orientation[joint] * (figure.positions[v] - rest.position[joint]));
      }
      EXPECT_LT((skin[v] - from_ours() * expected.cast<double>()).norm(), 1e-4);
    }
  }
}

TEST(GltfWriter, EveryFigureOfAGroupPlaysItsOwnMotion) {
  std::mt19937 random(21);
  const motion::Physique character = crooked_character(random);
  std::vector<motion::Motion> motions;
  for (int k = 0; k < 3; ++k) motions.push_back(random_motion(random, 4));
  const Glb glb = tests::read_glb(make_group_glb(character, motions));
  for (std::size_t k = 0; k < motions[0].poses.size(); ++k) {
    const double time_s = static_cast<double>(k) / 30;
    expect_joints(character.skeleton, motions[0].poses[k], glb, time_s);
    expect_joints(character.skeleton, motions[1].poses[k], glb, time_s, "_2");
    expect_joints(character.skeleton, motions[2].poses[k], glb, time_s, "_3");
  }
  ASSERT_EQ(glb.document["skins"].size(), 3U);
  EXPECT_EQ(glb.document["skins"][2]["skeleton"], tests::node_named(glb, "pelvis_3"));
  const auto figure = static_cast<std::size_t>(tests::node_named(glb, "figure_3"));
  EXPECT_EQ(glb.document["nodes"][figure]["skin"], 2);
  motions[1].poses.pop_back();
  EXPECT_THAT(error_of([&] { make_group_glb(character, motions); }), HasSubstr("differ in length"));
  EXPECT_THAT(error_of([&] { make_group_glb(character, {}); }), HasSubstr("no motions"));
}

TEST(GltfWriter, EachMaterialHasThePartOfTheFigureThatItCovers) {
  const motion::Physique character = motion::default_character();
  std::mt19937 random(12);
  const Glb glb = tests::read_glb(make_glb(character, random_motion(random, 2)));
  const motion::FigureSkin figure = motion::make_figure_skin(character);
  const auto& primitives = glb.document["meshes"][0]["primitives"];
  ASSERT_EQ(primitives.size(), std::size_t{motion::kCoveringCount});
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const std::vector<double> indices = tests::numbers_of(glb, primitives[i]["indices"]);
    const auto& triangles = figure.triangles[static_cast<motion::Covering>(i)];
    ASSERT_EQ(indices.size(), 3 * triangles.size());
    EXPECT_EQ(indices[0], triangles[0][0]);
    EXPECT_EQ(indices.back(), triangles.back()[2]);
    EXPECT_EQ(primitives[i]["attributes"], primitives[0]["attributes"]);  // written once
  }
  const auto& materials = glb.document["materials"];
  EXPECT_EQ(materials.at(primitives[5]["material"].get<std::size_t>())["name"], "trousers");
}

TEST(GltfWriter, FigureStandsUprightOnTheGroundAndFacesForward) {
  const motion::Physique character = motion::default_character();
  motion::Motion motion;
  motion.poses.push_back(motion::rest_pose(character.skeleton));
  const Glb glb = tests::read_glb(make_glb(character, motion));
  const std::vector<Affine3d> scene = tests::scene_at(glb, 0);
  const std::vector<Vector3d> skin = tests::skinned_positions(glb, 0, scene);
  const auto box_of = [&](std::size_t primitive) {
    Eigen::AlignedBox3d box;
    for (const double vertex :
         tests::numbers_of(glb, glb.document["meshes"][0]["primitives"][primitive]["indices"])) {
      box.extend(skin[static_cast<std::size_t>(vertex)]);
    }
    return box;
  };
  const Eigen::AlignedBox3d hair = box_of(1);
  const Eigen::AlignedBox3d eyes = box_of(2);
  const Eigen::AlignedBox3d shoes = box_of(6);
  EXPECT_NEAR(shoes.min().y(), 0, 3e-3);
  EXPECT_NEAR(hair.max().y(), 1.75, 0.01);
  EXPECT_NEAR(eyes.center().x(), 0, 1e-6);
  EXPECT_GT(eyes.min().z(), hair.center().z());
  // The left hand is on the left in glTF.
  EXPECT_GT(scene[static_cast<std::size_t>(tests::node_named(glb, "left_hand"))].translation().x(),
            0.5);
}

// What importers of other tools rely on: ozz drops nodes above the skeleton, Assimp 5.2.5 reads
// weights of bytes wrongly, and animation keys that are not linear are resampled by many.
TEST(GltfWriter, KeepsToWhatEveryImporterReads) {
  std::mt19937 random(13);
  const motion::Motion motion = random_motion(random, 4);
  const BallTrack ball{0.1F, std::vector<std::optional<Vector3f>>(4, Vector3f(1, 2, 3))};
  const Glb glb = tests::read_glb(make_glb(motion::default_character(), motion, ball));
  const auto& nodes = glb.document["nodes"];
  std::vector<std::string> roots;
  for (const auto& root : glb.document["scenes"][0]["nodes"]) {
    roots.push_back(nodes.at(root.get<std::size_t>())["name"]);
  }
  EXPECT_EQ(roots, (std::vector<std::string>{"figure", "pelvis", "ball"}));
  for (const auto& node : nodes) {
    const std::string name = node["name"];
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string::npos) << name;
    EXPECT_FALSE(node.contains("rotation") || node.contains("scale") || node.contains("matrix"));
  }
  const auto& attributes = glb.document["meshes"][0]["primitives"][0]["attributes"];
  const auto& accessors = glb.document["accessors"];
  EXPECT_EQ(accessors.at(attributes["WEIGHTS_0"].get<std::size_t>())["componentType"], 5126);
  EXPECT_EQ(accessors.at(attributes["JOINTS_0"].get<std::size_t>())["componentType"], 5121);
  EXPECT_FALSE(attributes.contains("JOINTS_1"));
  const auto& animation = glb.document["animations"][0];
  for (const auto& channel : animation["channels"]) {
    const bool is_scale = channel["target"]["path"] == "scale";
    EXPECT_EQ(animation["samplers"].at(channel["sampler"].get<std::size_t>())["interpolation"],
              is_scale ? "STEP" : "LINEAR");
  }
  const std::string generator = glb.document["asset"]["generator"];
  EXPECT_THAT(generator, testing::MatchesRegex("Flinch [0-9]+[.][0-9]+[.][0-9]+"));
}

// The joints of each motion, by the file's own nodes, where its keys are its poses.
TEST(GltfWriter, SeveralMotionsAreAnAnimationEach) {
  std::mt19937 random(14);
  const motion::Physique character = crooked_character(random);
  std::vector<NamedMotion> motions;
  for (const int count : {3, 1, 5}) {
    motions.push_back({"motion_" + std::to_string(count), random_motion(random, count), {}});
    motions.back().motion.rate_hz = static_cast<float>(10 * count);
  }
  Glb glb = tests::read_glb(make_glb(character, motions));
  const auto animations = glb.document["animations"];
  ASSERT_EQ(animations.size(), 3U);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    EXPECT_EQ(animations[i]["name"], motions[i].name);
    EXPECT_FALSE(animations[i].contains("extras"));
    glb.document["animations"] = nlohmann::json::array({animations[i]});
    for (std::size_t k = 0; k < motions[i].motion.poses.size(); ++k) {
      expect_joints(character.skeleton, motions[i].motion.poses[k], glb,
                    static_cast<double>(k) / double{motions[i].motion.rate_hz});
    }
  }
  EXPECT_THAT(error_of([&] { make_glb(character, std::span<const NamedMotion>()); }),
              HasSubstr("no motions"));
  motions[1].motion.poses.clear();
  EXPECT_THAT(error_of([&] { make_glb(character, motions); }), HasSubstr("no poses"));
}

TEST(GltfWriter, ExtrasTellWhatIsKnown) {
  std::mt19937 random(15);
  const motion::Motion motion = random_motion(random, 2);
  const motion::Physique character = motion::default_character();
  const auto extras_of = [&](const MotionFacts& facts) {
    const Glb glb = tests::read_glb(make_glb(character, motion, std::nullopt, facts));
    return glb.document["animations"][0].value("extras", nlohmann::json());
  };
  EXPECT_TRUE(extras_of({}).is_null());
  const motion::Annotation annotation{motion::Target::pelvis,
                                      static_cast<float>(-std::numbers::pi / 4),
                                      motion::Degree::exaggerated,
                                      0.1F,
                                      0.35F,
                                      1.25F};
  EXPECT_EQ(extras_of({.clip = "Duck", .annotation = annotation}),
            nlohmann::json::parse(R"({"clip": "Duck", "target": "pelvis", "direction_degrees": -45,
              "degree": "exaggerated", "onset_s": 0.1, "peak_s": 0.35, "end_s": 1.25})"));
  EXPECT_EQ(extras_of({.clip = "Duck",
                       .impact_s = 0.5F,
                       .contact_s = 0.48F,
                       .hit_body = motion::Body::left_forearm,
                       .impulse_ns = 3.2F}),
            nlohmann::json::parse(R"({"clip": "Duck", "impact_s": 0.5, "contact_s": 0.48,
              "hit_body": "left_forearm", "impulse_ns": 3.2})"));
}

TEST(GltfWriter, BallFollowsItsTrackAndHasZeroScaleWhileAbsent) {
  std::mt19937 random(5);
  const motion::Motion motion = random_motion(random, 10);
  BallTrack ball{0.2F, {}};
  for (int k = 0; k < 10; ++k) {
    const bool is_there = k >= 2 && k != 5 && k < 8;
    ball.positions.push_back(is_there ? std::optional(tests::random_vector(random, 3))
                                      : std::nullopt);
  }
  const Glb glb = tests::read_glb(make_glb(motion::default_character(), motion, ball));
  const auto node = static_cast<std::size_t>(tests::node_named(glb, "ball"));
  const int waits_at[10] = {2, 2, 2, 3, 4, 4, 6, 7, 7, 7};
  for (std::size_t k = 0; k < 10; ++k) {
    // Just after the key, whose time is rounded.
    const Affine3d place = tests::scene_at(glb, static_cast<double>(k) / 30 + 1e-6)[node];
    const Vector3f expected = *ball.positions[static_cast<std::size_t>(waits_at[k])];
    EXPECT_LT((place.translation() - from_ours() * expected.cast<double>()).norm(), 1e-3);
    EXPECT_NEAR(place.linear().norm(), ball.positions[k] ? std::sqrt(3) : 0, 1e-6) << k;
  }
  // Halfway between keys the ball is on the straight line, and visible until the key that hides it.
  const Affine3d between = tests::scene_at(glb, 3.5 / 30)[node];
  const Vector3f middle = 0.5F * (*ball.positions[3] + *ball.positions[4]);
  EXPECT_LT((between.translation() - from_ours() * middle.cast<double>()).norm(), 1e-5);
  EXPECT_NEAR(tests::scene_at(glb, 4.9 / 30)[node].linear().norm(), std::sqrt(3), 1e-6);

  const auto& attributes = glb.document["meshes"][1]["primitives"][0]["attributes"];
  const std::vector<double> sphere = tests::numbers_of(glb, attributes["POSITION"]);
  for (std::size_t i = 0; i < sphere.size(); i += 3) {
    EXPECT_NEAR(Eigen::Map<const Vector3d>(sphere.data() + i).norm(), 0.2, 1e-6);
  }
}

TEST(GltfWriter, AbsentBallHasZeroScale) {
  std::mt19937 random(6);
  const BallTrack ball{0.1F, std::vector<std::optional<Vector3f>>(3)};
  const Glb glb =
      tests::read_glb(make_glb(motion::default_character(), random_motion(random, 3), ball));
  const auto node = static_cast<std::size_t>(tests::node_named(glb, "ball"));
  for (const double time_s : {0.0, 0.03, 0.1}) {
    EXPECT_EQ(tests::scene_at(glb, time_s)[node].matrix().block(0, 0, 3, 4).norm(), 0);
  }
}

TEST(GltfWriter, NoBallNodeWithoutABall) {
  std::mt19937 random(7);
  const Glb glb = tests::read_glb(make_glb(motion::default_character(), random_motion(random, 3)));
  EXPECT_THROW(tests::node_named(glb, "ball"), std::runtime_error);
  EXPECT_EQ(glb.document["meshes"].size(), 1U);
  EXPECT_EQ(glb.document["animations"][0]["channels"].size(), 22U);
}

TEST(GltfWriter, AccessorBoundsMatchAndViewsFillTheBuffer) {
  std::mt19937 random(8);
  const Glb glb = tests::read_glb(make_glb(motion::default_character(), random_motion(random, 5)));
  std::size_t end = 0;
  int bounded = 0;
  for (std::size_t a = 0; a < glb.document["accessors"].size(); ++a) {
    const auto& accessor = glb.document["accessors"][a];
    const std::vector<double> numbers = tests::numbers_of(glb, a);  // checks the position of each
    const auto& view = glb.document["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
    EXPECT_GE(view["byteOffset"].get<std::size_t>(), end);
    EXPECT_LT(view["byteOffset"].get<std::size_t>(), end + 4);
    end = view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>();
    if (!accessor.contains("min")) continue;
    ++bounded;
    const std::size_t width = accessor["min"].size();
    for (std::size_t c = 0; c < width; ++c) {
      double min = std::numeric_limits<double>::infinity();
      double max = -min;
      for (std::size_t i = c; i < numbers.size(); i += width) {
        min = std::min(min, numbers[i]);
        max = std::max(max, numbers[i]);
      }
      EXPECT_EQ(accessor["min"][c].get<double>(), min);
      EXPECT_EQ(accessor["max"][c].get<double>(), max);
    }
  }
  EXPECT_EQ(bounded, 2);  // the mesh's positions, the times
  EXPECT_EQ(glb.document["buffers"][0]["byteLength"].get<std::size_t>(), end);
  EXPECT_EQ((end + 3) / 4 * 4, glb.binary.size());
}

TEST(GltfWriter, KeysAreAtTheMotionsRate) {
  std::mt19937 random(9);
  motion::Motion motion = random_motion(random, 400);
  motion.rate_hz = 59.94F;
  const Glb glb = tests::read_glb(make_glb(motion::default_character(), motion));
  const auto& sampler = glb.document["animations"][0]["samplers"][0];
  const std::vector<double> times = tests::numbers_of(glb, sampler["input"]);
  ASSERT_EQ(times.size(), 400U);
  for (std::size_t k = 0; k < times.size(); ++k) {
    EXPECT_NEAR(times[k], static_cast<double>(k) / 59.94, 1e-6);
  }
}

TEST(GltfWriter, SameInputGivesTheSameBytesInMemoryAndInTheFile) {
  const ClipLibrary library = scenes::synthetic_library();
  const motion::Motion& motion = library.clips[1].motion;
  const BallTrack ball{
      0.1F, std::vector<std::optional<Vector3f>>(motion.poses.size(), Vector3f(1, 2, 3))};
  const std::vector<std::byte> bytes = make_glb(library.character, motion, ball);
  EXPECT_EQ(bytes, make_glb(library.character, motion, ball));
  const tests::TemporaryFolder folder;
  write_glb(folder / "motion.glb", library.character, motion, ball);
  const std::string file = read_file(folder / "motion.glb");
  ASSERT_EQ(file.size(), bytes.size());
  EXPECT_EQ(std::memcmp(file.data(), bytes.data(), bytes.size()), 0);
}

TEST(GltfWriter, RefusesWhatItCannotWriteAndLeavesNoFile) {
  const motion::Physique character = motion::default_character();
  std::mt19937 random(10);
  const motion::Motion motion = random_motion(random, 3);
  const tests::TemporaryFolder folder;
  const auto refusal = [&](const motion::Physique& who, const motion::Motion& what,
                           const std::optional<BallTrack>& ball = std::nullopt) {
    return error_of([&] { write_glb(folder / "refused.glb", who, what, ball); });
  };
  EXPECT_EQ(refusal(character, motion), "");
  std::filesystem::remove(folder / "refused.glb");

  motion::Motion broken = motion;
  broken.poses.clear();
  EXPECT_THAT(refusal(character, broken), HasSubstr("no poses"));
  broken = motion;
  broken.poses[1].root_position.y() = kNan;
  EXPECT_THAT(refusal(character, broken), HasSubstr("pose 1 of the motion"));
  broken = motion;
  broken.poses[2].rotation[Role::head].coeffs() *= 1.1F;
  EXPECT_THAT(refusal(character, broken), HasSubstr("pose 2 of the motion"));
  for (const float rate : {0.0F, -60.0F, kNan, tests::kInfinity}) {
    broken = motion;
    broken.rate_hz = rate;
    EXPECT_THAT(refusal(character, broken), HasSubstr("rate"));
  }
  motion::Physique nobody = character;
  nobody.skeleton.offset[Role::left_shin].z() = kNan;
  EXPECT_THAT(refusal(nobody, motion), HasSubstr("skeleton"));
  nobody = character;
  nobody.skeleton.offset[Role::left_shin].z() = -3e38F;
  nobody.skeleton.offset[Role::left_foot].z() = -3e38F;
  EXPECT_THAT(refusal(nobody, motion), HasSubstr("longer than 5 m"));

  BallTrack ball{0.1F, std::vector<std::optional<Vector3f>>(2)};
  EXPECT_THAT(refusal(character, motion, ball), HasSubstr("2 positions, the motion 3 poses"));
  ball.positions.emplace_back(Vector3f(0, kNan, 0));
  EXPECT_THAT(refusal(character, motion, ball), HasSubstr("position 2 of the ball"));
  ball.positions[2].reset();
  ball.radius = 0;
  EXPECT_THAT(refusal(character, motion, ball), HasSubstr("radius"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace flinch::database

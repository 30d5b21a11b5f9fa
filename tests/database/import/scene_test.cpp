// SPDX-License-Identifier: MIT
#include "database/import/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "database/import/import.h"
#include "database/import/source_file.h"
#include "motion/default_character.h"
#include "motion/rotation.h"
#include "tests/database/import/fbx_text.h"
#include "tests/database/import/gltf_files.h"
#include "tests/database/import/synthetic_figure.h"
#include "tests/scenes/allow_leaks.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::database {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using motion::Role;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using tests::AllowLeaks;
using tests::error_of;
using tests::fbx_text;
using tests::FbxSettings;
using tests::GltfSettings;
using tests::TemporaryFolder;
using tests::write_gltf;

// Two seconds at 60 Hz of a figure that waves and walks off, in centimetres.
Bvh waving(const Quaterniond& axes = tests::SyntheticRig().axes) {
  std::vector<motion::Pose> poses;
  for (int k = 0; k < 120; ++k) {
    const float t = static_cast<float>(k) / 60;
    motion::Pose pose = motion::rest_pose(motion::default_character().skeleton);
    pose.root_position.x() += 0.3F * t;
    pose.rotation[Role::pelvis] = motion::rotation_about(Eigen::Vector3f::UnitZ(), 0.4F * t);
    pose.rotation[Role::left_upper_arm] =
        motion::rotation_about(Eigen::Vector3f::UnitX(), 1.2F * std::sin(3 * t));
    pose.rotation[Role::left_forearm] =
        motion::rotation_about(Eigen::Vector3f::UnitZ(), std::sin(4 * t));
    pose.rotation[Role::right_thigh] =
        motion::rotation_about(Eigen::Vector3f::UnitY(), -0.5F * std::sin(2 * t));
    poses.push_back(pose);
  }
  tests::SyntheticRig rig;
  rig.axes = axes;
  return tests::synthetic_bvh(motion::default_character().skeleton, rig, poses, 1.0 / 60);
}

std::size_t joint_named(const Bvh& bvh, const std::string& name) {
  for (std::size_t i = 0; i < bvh.joints.size(); ++i) {
    if (bvh.joints[i].name == name) return i;
  }
  throw std::out_of_range(name);
}

// The same places of all joints in all frames, after `turn` and `scale`, m.
void expect_same_places(const Bvh& found, const Bvh& expected, double scale,
                        const Quaterniond& turn = Quaterniond::Identity()) {
  ASSERT_EQ(found.joints.size(), expected.joints.size());
  ASSERT_EQ(found.frame_count, expected.frame_count);
  EXPECT_NEAR(found.frame_time_s, expected.frame_time_s, 1e-6);
  double worst_m = 0;
  for (int frame = 0; frame < expected.frame_count; ++frame) {
    const BvhFrame places = forward_kinematics(found, frame);
    const BvhFrame wanted = forward_kinematics(expected, frame);
    for (std::size_t i = 0; i < expected.joints.size(); ++i) {
      const std::size_t at = joint_named(found, expected.joints[i].name);
      worst_m =
          std::max(worst_m, (places.position[at] - turn * (scale * wanted.position[i])).norm());
    }
  }
  EXPECT_LT(worst_m, 1e-5);
}

Bvh read_fbx(const Bvh& bvh, const FbxSettings& settings) {
  const TemporaryFolder folder;
  return read_source_file(folder.write("a.fbx", fbx_text(bvh, settings)));
}

TEST(Scene, AnFbxFileHoldsTheSameMotionAsABvhFile) {
  const Bvh bvh = waving();
  const Bvh found = read_fbx(bvh, {});
  expect_same_places(found, bvh, 0.01);
  EXPECT_EQ(found.channel_count, bvh.channel_count);  // bones stay bones
  EXPECT_TRUE(found.is_metres_y_up);
  EXPECT_THAT(found.warnings, testing::IsEmpty());
}

TEST(Scene, AnFbxFilesUnitAndUpAxisAreAllowedFor) {
  const std::pair<int, int> axes[] = {{0, 1}, {1, 1}, {2, 1}, {0, -1}, {1, -1}, {2, -1}};
  for (const auto& [axis, sign] : axes) {
    const Vector3d up = sign * Vector3d::Unit(axis);
    const Quaterniond to_file = Quaterniond::FromTwoVectors(Vector3d::UnitY(), up);
    const Bvh turned = waving(to_file * tests::SyntheticRig().axes);
    const Bvh found =
        read_fbx(turned, {.up_axis = axis, .up_axis_sign = sign, .unit_centimetres = 2.54});
    expect_same_places(found, turned, 0.0254, Quaterniond::FromTwoVectors(up, Vector3d::UnitY()));
  }
}

// FBX: a joint's rotation is pre * rotation * post^-1.
TEST(Scene, PreAndPostRotationsOfFbxAreAllowedFor) {
  const auto turn = [](const Vector3d& degrees) -> Quaterniond {
    return AngleAxisd(motion::radians(degrees.z()), Vector3d::UnitZ()) *
           AngleAxisd(motion::radians(degrees.y()), Vector3d::UnitY()) *
           AngleAxisd(motion::radians(degrees.x()), Vector3d::UnitX());
  };
  const Vector3d none = Vector3d::Zero();
  const std::pair<Vector3d, Vector3d> cases[] = {
      {{10, -20, 80}, none}, {none, {-30, 40, 70}}, {{90, 0, 0}, {0, 0, 90}}};
  for (const auto& [pre, post] : cases) {
    const Bvh bvh = waving();
    const Bvh found = read_fbx(bvh, {.pre_rotation = pre, .post_rotation = post});
    for (int frame = 0; frame < bvh.frame_count; frame += 7) {
      const BvhFrame places = forward_kinematics(found, frame);
      const BvhFrame plain = forward_kinematics(bvh, frame);
      std::vector<Vector3d> position;
      std::vector<Quaterniond> orientation;
      for (std::size_t i = 0; i < bvh.joints.size(); ++i) {
        const int above = bvh.joints[i].parent;
        const auto parent = static_cast<std::size_t>(std::max(above, 0));
        const Quaterniond own = above < 0
                                    ? plain.orientation[i]
                                    : plain.orientation[parent].conjugate() * plain.orientation[i];
        const Quaterniond local = turn(pre) * own * turn(post).conjugate();
        orientation.push_back(above < 0 ? local : orientation[parent] * local);
        position.push_back(above < 0
                               ? plain.position[i]
                               : position[parent] + orientation[parent] * bvh.joints[i].offset);
        const std::size_t at = joint_named(found, bvh.joints[i].name);
        EXPECT_LT((places.position[at] - 0.01 * position[i]).norm(), 1e-5)
            << bvh.joints[i].name << " in frame " << frame;
      }
    }
  }
}

// As of bones of 3ds Max, whose boxes lie elsewhere than their joints.
TEST(Scene, TransformsOfFbxMeshesMoveNoJoint) {
  const Bvh bvh = waving();
  expect_same_places(
      read_fbx(bvh, {.geometric_translation = {10, 20, 30}, .geometric_rotation = {40, 50, 60}}),
      bvh, 0.01);
}

TEST(Scene, AnimationLayersOfFbxAreNoted) {
  EXPECT_THAT(read_fbx(waving(), {.layer_count = 2}).warnings,
              ElementsAre(HasSubstr("animation layers, which are not added")));
}

TEST(Scene, FbxRotationsThatAreNotOfEulerAnglesAreRefused) {
  const TemporaryFolder folder;
  for (const int order : {6, 7, -1}) {
    const std::string path =
        folder.write("a.fbx", fbx_text(waving(), {.last_rotation_order = order}));
    EXPECT_THAT(error_of([&] { read_source_file(path); }),
                testing::AllOf(StartsWith(path + ": `right_toes` has a rotation order"),
                               HasSubstr("set it to Euler XYZ and bake")))
        << order;
  }
}

TEST(Scene, FbxRotationsThatAreSwitchedOffAreNoted) {
  EXPECT_THAT(read_fbx(waving(), {.is_rotation_active = false}).warnings,
              ElementsAre(HasSubstr("`right_toes` has a rotation order or a pre- or "
                                    "post-rotation that is switched off")));
  EXPECT_THAT(read_fbx(waving(), {.last_rotation_order = 0, .is_rotation_active = false}).warnings,
              IsEmpty());
}

Bvh read_gltf(const Bvh& bvh, const GltfSettings& settings) {
  const TemporaryFolder folder;
  return read_source_file(write_gltf(folder, bvh, settings));
}

TEST(Scene, AGltfFileHoldsTheSameMotionAsABvhFile) {
  const Bvh bvh = waving();
  const Bvh found = read_gltf(bvh, {});
  expect_same_places(found, bvh, 0.01);
  EXPECT_EQ(found.channel_count, bvh.channel_count);
  EXPECT_THAT(found.warnings, IsEmpty());
}

TEST(Scene, ArmaturesOfGltfThatAreScaledAndSeveralSkinsAreAllowedFor) {
  const Bvh bvh = waving();
  for (const double scale : {0.01, 1.0, 100.0}) {
    for (const int skins : {0, 1, 3}) {
      const Bvh found = read_gltf(bvh, {.armature_scale = scale, .skin_count = skins});
      expect_same_places(found, bvh, 0.01);
      EXPECT_THAT(found.warnings, IsEmpty());
    }
  }
}

TEST(Scene, DenseKeysAreReadWhateverTheirCurvesAndSparseOnesAreNoted) {
  const Bvh bvh = waving();
  for (const char* curve : {"LINEAR", "STEP", "CUBICSPLINE"}) {
    const Bvh dense = read_gltf(bvh, {.interpolation = curve});
    expect_same_places(dense, bvh, 0.01);
    EXPECT_THAT(dense.warnings, IsEmpty()) << curve;
    const Bvh sparse = read_gltf(bvh, {.interpolation = curve, .key_step = 30});
    EXPECT_THAT(sparse.warnings, ElementsAre(HasSubstr("keys are up to 0.50 s apart"))) << curve;
    const BvhFrame places = forward_kinematics(sparse, sparse.frame_count - 1);  // at a key
    const BvhFrame wanted = forward_kinematics(bvh, bvh.frame_count - 1);
    for (std::size_t i = 0; i < wanted.position.size(); ++i) {
      EXPECT_LT((places.position[i] - 0.01 * wanted.position[i]).norm(), 1e-5);
    }
  }
}

// Also where none of them is above all that move.
TEST(Scene, JointsWithoutKeysBelongToTheFigure) {
  std::vector<motion::Pose> poses;
  for (int k = 0; k < 60; ++k) {
    motion::Pose pose = motion::rest_pose(motion::default_character().skeleton);
    pose.rotation[Role::left_upper_arm] =
        motion::rotation_about(Eigen::Vector3f::UnitX(), 0.02F * static_cast<float>(k));
    pose.rotation[Role::right_thigh] =
        motion::rotation_about(Eigen::Vector3f::UnitY(), -0.01F * static_cast<float>(k));
    poses.push_back(pose);
  }
  Bvh bvh = tests::synthetic_bvh(motion::default_character().skeleton, tests::SyntheticRig(), poses,
                                 1.0 / 60);
  GltfSettings settings;
  for (const BvhJoint& joint : bvh.joints) settings.still.insert(joint.name);
  settings.still.erase("left_upper_arm");
  settings.still.erase("right_thigh");
  bvh.joints[0].offset = forward_kinematics(bvh, 0).position[0];
  for (const bool has_ball : {false, true}) {
    settings.has_ball = has_ball;
    expect_same_places(read_gltf(bvh, settings), bvh, 0.01);
  }
}

TEST(Scene, WhatMovesBesideTheFigureDoesNotMakeItsTakeLonger) {
  const Bvh bvh = waving();
  expect_same_places(read_gltf(bvh, {.has_ball = true}), bvh, 0.01);
}

TEST(Scene, OfAnAnimationWithoutLengthAndAnotherTheOtherIsTaken) {
  const Bvh bvh = waving();
  const Bvh found = read_gltf(bvh, {.has_bind_pose = true});
  expect_same_places(found, bvh, 0.01);
  EXPECT_THAT(found.warnings, ElementsAre(HasSubstr("of its 2 animations")));
}

TEST(Scene, NodesThatMoveAndShareANameAreRefused) {
  const auto read = [](const std::string& name) {
    return error_of([&] {
      read_gltf(waving(), {.renamed = {{"left_foot", name}, {"right_foot", name}}});
    });
  };
  EXPECT_THAT(read("foot"), HasSubstr("has several nodes named `foot`"));
  EXPECT_THAT(error_of([] {
                read_gltf(waving(), {.renamed = {{"head", "Armature"}}});
              }),
              HasSubstr("`Armature`"));
}

TEST(Scene, AnFbxFileGoesThroughTheSameImportAsABvhFile) {
  const TemporaryFolder folder;
  const std::string path = folder.write("wave.fbx", fbx_text(waving()));
  const SourceReport report = inspect_source(path);
  EXPECT_EQ(report.unit, LengthUnit::metre);
  EXPECT_EQ(report.up, UpAxis::y);
  EXPECT_EQ(report.joint_name[Role::left_forearm], "left_forearm");
  const ClipLibrary library = import_library({folder.path()}, std::nullopt).library;
  ASSERT_EQ(library.clips.size(), 1U);
  EXPECT_EQ(library.clips[0].motion.poses.size(), 120U);
}

TEST(Scene, FilesThatAreCutOrWrongAreRefusedInOneLine) {
  const TemporaryFolder folder;
  const auto refusal_of = [&](const std::string& name, const std::string& bytes) {
    const std::string path = folder.write(name, bytes);
    const AllowLeaks allow_leaks;  // Assimp 5.2.5 keeps what it has parsed of a cut FBX file
    const std::string error = error_of([&] { read_source_file(path); });
    EXPECT_THAT(error, StartsWith(path + ": ")) << name;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    return error;
  };
  const std::string whole = fbx_text(waving());
  refusal_of("cut.fbx", whole.substr(0, whole.size() / 2));
  refusal_of("head.fbx", "; FBX 7.4.0 project file\n");
  refusal_of("binary.fbx", std::string("Kaydara FBX Binary  \0\x1a\0\xff\xff\xff\xff", 27));
  refusal_of("cut.glb", std::string("glTF\2\0\0\0\xff\0\0\0", 12));
  refusal_of("text.gltf", R"({"asset": {"version": "2.0"}, "nodes": [{"children": [7]}]})");
  const std::string still = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
      "nodes": [{"name": "a"}]})";
  EXPECT_THAT(refusal_of("still.gltf", still), HasSubstr("no animation"));
  EXPECT_THAT(error_of([&] { read_source_file(folder / "none.glb"); }), HasSubstr("No such file"));
}

TEST(Scene, RotationsThatGltfKeepsAsIntegersAreRefused) {
  const TemporaryFolder folder;
  // Two times as floats, 0 and 1 s, and a rotation by 0 for each, as 16-bit integers.
  const std::string zero(4, '\0');
  const std::string identity = std::string(6, '\0') + "\xff\x7f";
  folder.write("numbers.bin", zero + std::string("\0\0\x80\x3f", 4) + identity + identity);
  const std::string path = folder.write("packed.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
      "scenes": [{"nodes": [0]}], "nodes": [{"name": "hips"}],
      "buffers": [{"byteLength": 24, "uri": "numbers.bin"}],
      "bufferViews": [{"buffer": 0, "byteLength": 24}],
      "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR"},
        {"bufferView": 0, "byteOffset": 8, "componentType": 5122, "normalized": true, "count": 2,
         "type": "VEC4"}],
      "animations": [{"samplers": [{"input": 0, "output": 1}],
        "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}}]}]})");
  EXPECT_THAT(error_of([&] { read_source_file(path); }),
              testing::AllOf(StartsWith(path + ": `hips`"), HasSubstr("save it with floats")));
}

TEST(Scene, AGltfFileCannotMakeFlinchReadAFileOutsideItsFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "in");
  const std::string times(16, '\0');
  const std::string rotation = std::string(12, '\0') + std::string("\0\0\x80\x3f", 4);  // by 0
  for (const char* file : {"secret.bin", "in/own.bin"}) {
    folder.write(file, times + rotation + rotation + std::string(16, '\0'));
  }
  const auto error_with = [&](const std::string& uri) {
    const std::string path = folder.write("in/a.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
      "scenes": [{"nodes": [0]}], "nodes": [{"name": "a"}],
      "buffers": [{"byteLength": 64, "uri": ")" + uri + R"("}],
      "bufferViews": [{"buffer": 0, "byteLength": 64}],
      "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR"},
        {"bufferView": 0, "byteOffset": 16, "componentType": 5126, "count": 2, "type": "VEC4"}],
      "animations": [{"samplers": [{"input": 0, "output": 1}],
        "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}}]}]})");
    return error_of([&] { read_source_file(path); });
  };
  EXPECT_THAT(error_with("own.bin"), HasSubstr("no animated figure"));
  for (const std::string uri : {"../secret.bin", "/dev/zero"}) {
    EXPECT_THAT(error_with(uri), testing::Not(HasSubstr("no animated figure"))) << uri;
    EXPECT_NE(error_with(uri), "") << uri;
  }
}

}  // namespace
}  // namespace flinch::database

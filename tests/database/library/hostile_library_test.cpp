// SPDX-License-Identifier: MIT
// Library files as an attacker would make them: the schema's verification and the content hash
// pass.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "database/files/library_writer.h"
#include "database/library/library_bounds.h"
#include "database/library/library_file.h"
#include "database/library/library_layout.h"
#include "library_generated.h"
#include "tests/database/library/random_library.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/file_damage.h"
#include "tests/scenes/not_finite.h"
#include "tests/scenes/read_cost.h"

namespace flinch::database {
namespace {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;
using motion::Role;
using tests::kNan;

std::string sealed(const FlatBufferBuilder& builder) {
  return tests::with_header(
      kLibraryFormat,
      std::string(reinterpret_cast<const char*>(builder.GetBufferPointer()), builder.GetSize()));
}

/// A library whose clips all refer to one, of `pose_count` poses, and whose texts all refer to one
/// of `text_size` bytes.
std::string with_shared_parts(std::size_t clip_count, std::size_t pose_count,
                              std::size_t text_size) {
  FlatBufferBuilder builder;
  const auto name = builder.CreateString("name");
  const auto text = builder.CreateString(std::string(text_size, 'a'));
  std::vector<float> identity(kFloatsPerPose, 0);
  for (std::size_t i = 3; i < identity.size(); i += 4) identity[i] = 1;
  std::vector<float> floats;
  for (std::size_t i = 0; i < pose_count; ++i) {
    floats.insert(floats.end(), identity.begin(), identity.end());
  }
  const auto poses = builder.CreateVector(floats);
  const auto clip = schema::CreateClip(builder, text, 0, text, text, text, {}, poses);
  const auto clips = builder.CreateVector(std::vector<Offset<schema::Clip>>(clip_count, clip));
  const auto bones = builder.CreateVector(std::vector<float>(kFloatsPerSkeletonVector, 0.1F));
  const auto character = schema::CreateCharacter(builder, bones, bones, 70, 1);
  schema::FinishLibraryBuffer(builder,
                              schema::CreateLibrary(builder, name, character, 60, 0, clips));
  return sealed(builder);
}

void expect_refused_cheaply(const std::string& file) {
  ClipLibrary library;
  const tests::ReadCost cost;
  EXPECT_EQ(read_library(bytes_of(file), library), LoadStatus::damaged);
  cost.expect_below(tests::ReadCost::allowance(file.size()));
}

TEST(HostileLibrary, ThatUnfoldsToGigabytesIsRefusedBeforeItIsCopied) {
  expect_refused_cheaply(with_shared_parts(9'000, 2'200, 4));    // 7 GB of poses from 0.8 MB
  expect_refused_cheaply(with_shared_parts(9'000, 1, 760'000));  // 27 GB of texts
  expect_refused_cheaply(with_shared_parts(190'000, 1, 4));      // 100 MB of clips
  expect_refused_cheaply(with_shared_parts(900'000, 0, 0));
}

struct Bound {
  const char* words;
  std::function<void(ClipLibrary&)> break_it;
};

void expect_bounds(const std::vector<Bound>& bounds) {
  for (const Bound& bound : bounds) {
    ClipLibrary library = tests::random_library(6, 3);
    ASSERT_FALSE(fault_of(library));
    bound.break_it(library);
    const std::optional<LibraryFault> fault = fault_of(library);
    ASSERT_TRUE(fault) << bound.words;
    EXPECT_THAT(fault->what, testing::HasSubstr(bound.words));
  }
}

TEST(LibraryBounds, HoldForNumbers) {
  expect_bounds({
      {"mass", [](ClipLibrary& l) { l.character.mass_kg = 0.9F; }},
      {"mass", [](ClipLibrary& l) { l.character.mass_kg = 1001; }},
      {"mass", [](ClipLibrary& l) { l.character.mass_kg = kNan; }},
      {"rate", [](ClipLibrary& l) { l.rate_hz = 0.9F; }},
      {"rate", [](ClipLibrary& l) { l.rate_hz = 1001; }},
      {"rate", [](ClipLibrary& l) { l.rate_hz = kNan; }},
      {"1 km", [](ClipLibrary& l) { l.clips[3].motion.poses[1].root_position.x() = 1001; }},
      {"1 km", [](ClipLibrary& l) { l.clips[3].motion.poses[1].root_position.z() = -3.4e38F; }},
      {"1 ms", [](ClipLibrary& l) { l.clips[0].annotation->peak_s = 0.9e-3F; }},
      {"10,000", [](ClipLibrary& l) { l.clips.resize(10'001, l.clips[2]); }},
      {"million",
       [](ClipLibrary& l) {
         l.clips[3].motion.poses.assign(1'000'001, l.clips[3].motion.poses[0]);
       }},
  });
}

TEST(LibraryBounds, HoldForSkeletons) {
  const auto offset = [](Role role, const Eigen::Vector3f& to) {
    return [role, to](ClipLibrary& l) { l.character.skeleton.offset[role] = to; };
  };
  expect_bounds({
      {"5 m", offset(Role::left_shin, {0, 0, -5.1F})},
      {"5 m", offset(Role::chest, {0, kNan, 0})},
      {"5 m", [](ClipLibrary& l) { l.character.skeleton.tip[Role::right_toes].x() = 1e30F; }},
      {"shorter", offset(Role::right_hand, {0, 0.009F, 0})},
      {"shorter", offset(Role::left_foot, {0, 0, 0})},
      {"left of the right",
       [](ClipLibrary& l) {
         std::swap(l.character.skeleton.offset[Role::left_thigh],
                   l.character.skeleton.offset[Role::right_thigh]);
       }},
      {"left of the right", offset(Role::left_clavicle, {0, -1, 0})},
      {"tall", [](ClipLibrary& l) { l.character.skeleton.tip[Role::head].z() = -4; }},
      {"tall", offset(Role::pelvis, {0, 0, 19.9F})},
      {"5 m", offset(Role::pelvis, {0, 0, 1e38F})},
  });
}

TEST(LibraryBounds, HoldForTexts) {
  const std::string long_text(256, 'a');
  expect_bounds({
      {"name", [](ClipLibrary& l) { l.name = "a\nb"; }},
      {"name", [](ClipLibrary& l) { l.name = "\xFF"; }},
      {"name", [&](ClipLibrary& l) { l.name = long_text; }},
      {"name", [](ClipLibrary& l) { l.clips[2].name = "\x1B[2J"; }},
      {"name", [](ClipLibrary& l) { l.clips[2].name = "\xC3("; }},
      {"name", [&](ClipLibrary& l) { l.clips[2].name = long_text; }},
      {"kind", [](ClipLibrary& l) { l.clips[2].kind = std::string("a\0b", 3); }},
      {"kind", [](ClipLibrary& l) { l.clips[2].source = "a\rb"; }},
      {"kind", [](ClipLibrary& l) { l.clips[2].source = std::string(4097, 'a'); }},
      {"kind", [](ClipLibrary& l) { l.clips[2].mirrored_from = "\x7F"; }},
  });
}

TEST(LibraryBounds, LeaveRoomForEveryCharacter) {
  for (const float scale : {0.15F, 0.5F, 2.5F, 9.0F}) {
    ClipLibrary library = tests::random_library(7, 3);
    for (Eigen::Vector3f& offset : library.character.skeleton.offset) offset *= scale;
    for (Eigen::Vector3f& tip : library.character.skeleton.tip) tip *= scale;
    EXPECT_FALSE(fault_of(library)) << scale;
  }
}

TEST(LibraryBounds, AMessageShowsNoControlCharacter) {
  ClipLibrary library = tests::random_library(6, 3);
  library.clips[2].name = "\x1B[2J\n";
  EXPECT_THAT(tests::error_of([&] { library_bytes(library); }),
              testing::HasSubstr("clip 2 (?[2J?)"));
}

}  // namespace
}  // namespace flinch::database

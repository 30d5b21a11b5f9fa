// SPDX-License-Identifier: MIT
// Library files of format 4: packed poses and mirror images, as written and as an attacker would
// make them.
#include <gtest/gtest.h>

#include <bit>

#include "database/files/library_writer.h"
#include "database/files/pose_packer.h"
#include "database/library/library_file.h"
#include "library_generated.h"
#include "tests/database/library/packable_library.h"
#include "tests/scenes/file_damage.h"
#include "tests/scenes/read_cost.h"

namespace flinch::database {
namespace {

using tests::kPackedFormat;
using tests::packable;

std::vector<std::uint32_t> pose_bits(const ClipLibrary& library) {
  std::vector<std::uint32_t> bits;
  const auto add = [&](float x) { bits.push_back(std::bit_cast<std::uint32_t>(x)); };
  for (const motion::Clip& clip : library.clips) {
    for (const motion::Pose& pose : clip.motion.poses) {
      for (const float x : pose.root_position) add(x);
      for (const Eigen::Quaternionf& rotation : pose.rotation)
        for (const float x : rotation.coeffs()) add(x);
    }
  }
  return bits;
}

TEST(PackedLibrary, GivesBackEveryBitAndTheSameFile) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const ClipLibrary library = packable(seed, 40);
    const std::string file = library_bytes(library);
    EXPECT_EQ(file[7], kPackedVersion);
    ClipLibrary read;
    ASSERT_EQ(read_library(bytes_of(file), read), LoadStatus::ok);
    EXPECT_EQ(pose_bits(read), pose_bits(library));
    EXPECT_EQ(library_bytes(read), file);
    for (std::size_t i = 0; i < library.clips.size(); ++i) {
      EXPECT_EQ(read.clips[i].name, library.clips[i].name);
      EXPECT_EQ(read.clips[i].mirrored_from, library.clips[i].mirrored_from);
      EXPECT_EQ(read.clips[i].annotation.has_value(), library.clips[i].annotation.has_value());
    }
  }
}

TEST(PackedLibrary, HasMirrorImagesOnce) {
  ClipLibrary library = packable(1, 200);
  const std::size_t with_mirror = library_bytes(library).size();
  library.clips[4].motion.poses[50].root_position.x() += 1 / 32768.0F;
  const std::size_t with_another = library_bytes(library).size();
  library.clips.pop_back();
  const std::size_t without = library_bytes(library).size();
  EXPECT_LT(with_mirror, without + 400);
  EXPECT_GT(with_another, without + 20'000);
}

TEST(PackedLibrary, WithOnePoseOffTheGridIsWrittenAsFloats) {
  ClipLibrary library = packable(2, 20);
  library.clips[4].motion.poses[9].root_position.x() += 1e-5F;
  const std::string file = library_bytes(library);
  EXPECT_EQ(file[7], kLibraryFormat.version);
  ClipLibrary read;
  ASSERT_EQ(read_library(bytes_of(file), read), LoadStatus::ok);
  EXPECT_EQ(pose_bits(read), pose_bits(library));
  EXPECT_EQ(library_bytes(read), file);
}

TEST(PackedLibrary, OfHalfAnHourWithoutMotionCanBeRead) {
  ClipLibrary library = packable(3, 20);
  motion::Motion& motion = library.clips[3].motion;
  motion.poses.assign(100'000, motion.poses[0]);
  library.clips[3].push.reset();
  ClipLibrary read;
  ASSERT_EQ(read_library(bytes_of(library_bytes(library)), read), LoadStatus::ok);
  EXPECT_EQ(read.clips[3].motion.poses.size(), 100'000U);
}

TEST(PackedLibrary, IsPackedWithProvenanceIfItIsWithout) {
  ClipLibrary library = packable(3, 20);
  library.clips[3].push.reset();
  std::vector<motion::Pose>& poses = library.clips[3].motion.poses;
  poses.resize(1);
  const std::size_t content_size = library_bytes(library).size() - kFileHeaderSize;
  // Readers bound the poses of a packed file by its size: these are 10 too many for the file as it
  // is, but not for the file that grows by the provenance.
  const std::size_t more = max_unpacked_size(content_size) / sizeof(motion::Pose) + 10;
  poses.assign(more, poses[0]);
  const std::string bare = library_bytes(library);
  EXPECT_NE(bare[7], kPackedVersion);
  library.provenance = std::string(2000, 'p');
  ClipLibrary read;
  ASSERT_EQ(read_library(bytes_of(library_bytes(library)), read), LoadStatus::ok);
  EXPECT_EQ(bare_library_bytes(read), bare);
}

TEST(PackedLibrary, ItsHashWithoutProvenanceIsComputedAgain) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    ClipLibrary library = packable(seed, 20);
    library.provenance = std::string(1 + seed % 5, 'p');
    ClipLibrary read;
    ASSERT_EQ(read_library(bytes_of(library_bytes(library)), read), LoadStatus::ok) << seed;
    EXPECT_EQ(library_bytes(read), library_bytes(library));
  }
}

/// The poses of a forged clip.
struct Forged {
  std::optional<std::vector<std::uint8_t>> packed = {};
  std::optional<std::uint32_t> mirror_of = {};
  bool has_floats = false;
};

/// A library file with these clips, all but the poses in order.
std::string forged(const std::vector<Forged>& clips, const FileFormat& format = kPackedFormat) {
  flatbuffers::FlatBufferBuilder builder;
  const std::vector<float> floats = [] {
    std::vector<float> one(3 + 4 * motion::kRoleCount, 0);
    for (std::size_t i = 3; i < one.size(); i += 4) one[i] = 1;
    return one;
  }();
  std::vector<flatbuffers::Offset<schema::Clip>> stored;
  for (const Forged& clip : clips) {
    const auto name = builder.CreateString("clip" + std::to_string(stored.size()));
    const auto text = builder.CreateString("text");
    flatbuffers::Offset<flatbuffers::Vector<std::uint8_t>> packed;
    flatbuffers::Offset<flatbuffers::Vector<float>> poses;
    if (clip.packed) packed = builder.CreateVector(*clip.packed);
    if (clip.has_floats) poses = builder.CreateVector(floats);
    flatbuffers::Optional<std::uint32_t> mirror_of;
    if (clip.mirror_of) mirror_of = *clip.mirror_of;
    stored.push_back(
        schema::CreateClip(builder, name, 0, text, text, text, {}, poses, {}, packed, mirror_of));
  }
  const motion::Skeleton skeleton = motion::default_character().skeleton;
  const auto vectors = [&](const motion::PerRole<Eigen::Vector3f>& of_role) {
    std::vector<float> numbers;
    for (const Eigen::Vector3f& vector : of_role)
      numbers.insert(numbers.end(), vector.begin(), vector.end());
    return builder.CreateVector(numbers);
  };
  const auto all = builder.CreateVector(stored);
  const auto offsets = vectors(skeleton.offset);
  const auto tips = vectors(skeleton.tip);
  const auto character = schema::CreateCharacter(builder, offsets, tips, 70, 1);
  const auto name = builder.CreateString("forged");
  schema::FinishLibraryBuffer(builder, schema::CreateLibrary(builder, name, character, 60, 0, all));
  return tests::with_header(
      format,
      std::string(reinterpret_cast<const char*>(builder.GetBufferPointer()), builder.GetSize()));
}

std::vector<std::uint8_t> packed_poses(std::size_t count) {
  return *pack_poses(std::vector<motion::Pose>(count));
}

bool is_read(const std::string& file) {
  ClipLibrary library;
  return read_library(bytes_of(file), library) == LoadStatus::ok;
}

TEST(HostilePackedLibrary, HasPosesInOneWayOrIsRefused) {
  const Forged packed{.packed = packed_poses(3)};
  ASSERT_TRUE(is_read(forged({packed})));
  ASSERT_TRUE(is_read(forged({{.mirror_of = 1}, packed}))) << "a mirror image may come first";
  ASSERT_TRUE(is_read(forged({{.has_floats = true}}, kLibraryFormat)));
  EXPECT_FALSE(is_read(forged({{}})));
  EXPECT_FALSE(is_read(forged({{}}, kLibraryFormat)));
  EXPECT_FALSE(is_read(forged({{.has_floats = true}})));
  EXPECT_FALSE(is_read(forged({packed}, kLibraryFormat)));
  EXPECT_FALSE(is_read(forged({{.packed = packed_poses(3), .has_floats = true}})));
  EXPECT_FALSE(is_read(forged({{.packed = packed_poses(3), .has_floats = true}}, kLibraryFormat)));
  EXPECT_FALSE(is_read(forged({packed, {.packed = packed_poses(3), .mirror_of = 0}})));
  EXPECT_FALSE(is_read(forged({{.mirror_of = 0, .has_floats = true}}, kLibraryFormat)));
}

TEST(HostilePackedLibrary, MirrorsOnlyAPackedClip) {
  const Forged packed{.packed = packed_poses(3)};
  EXPECT_FALSE(is_read(forged({packed, {.mirror_of = 1}}))) << "itself";
  EXPECT_FALSE(is_read(forged({packed, {.mirror_of = 0}, {.mirror_of = 1}}))) << "a mirror image";
  EXPECT_FALSE(is_read(forged({packed, {.mirror_of = 2}}))) << "no clip";
  EXPECT_FALSE(is_read(forged({packed, {.mirror_of = 4'294'967'295U}})));
}

void expect_refused_before_it_is_unpacked(const std::string& file) {
  ClipLibrary library;
  const tests::ReadCost cost;
  EXPECT_EQ(read_library(bytes_of(file), library), LoadStatus::damaged);
  cost.expect_below(tests::ReadCost::allowance(file.size()));
}

TEST(HostilePackedLibrary, ThatUnpacksToGigabytesIsRefusedBeforeItIsUnpacked) {
  expect_refused_before_it_is_unpacked(
      forged({{.packed = packed_poses(300'000)}}));  // 106 MB from 1 kB
  std::vector<Forged> images(3000, Forged{.mirror_of = 0});
  images[0] = {.packed = packed_poses(10'000)};
  expect_refused_before_it_is_unpacked(forged(images));  // 10 GB from 0.3 MB
  std::vector<std::uint8_t> many = packed_poses(3);
  for (std::size_t i = 0; i < 4; ++i) many[i] = 0xFF;
  expect_refused_before_it_is_unpacked(forged({{.packed = many}}));
  expect_refused_before_it_is_unpacked(forged({{.packed = std::vector<std::uint8_t>(5)}}));
}

TEST(HostilePackedLibrary, WithARotationOrRootOutOfBoundsIsRefused) {
  std::vector<std::uint8_t> packed = packed_poses(3);
  const auto with = [&](std::size_t place, std::uint8_t byte) {
    std::vector<std::uint8_t> changed = packed;
    changed[place] = byte;
    return is_read(forged({{.packed = changed}}));
  };
  EXPECT_TRUE(with(2, 0));
  EXPECT_TRUE(with(4 + 3, 0x01)) << "a root 512 m away";
  EXPECT_FALSE(with(4 + 3, 0x02)) << "a root 1024 m away";
  constexpr std::size_t kPelvis = 4 + 3 * 5;
  EXPECT_TRUE(with(kPelvis + 1 + 1, 0xFF)) << "a component just below 1";
  EXPECT_FALSE(with(kPelvis + 1 + 2, 0x02)) << "a component of 2";
  motion::Motion moving{.rate_hz = 60, .poses = std::vector<motion::Pose>(3)};
  moving.poses[1].rotation[motion::Role::pelvis] =
      Eigen::Quaternionf(Eigen::AngleAxisf(0.1F, Eigen::Vector3f::UnitX()));
  moving.poses[1].root_position.x() = 1;
  snap(moving);
  packed = *pack_poses(moving.poses);
  EXPECT_TRUE(with(2, 0));
  EXPECT_FALSE(with(4 + 3, 0x02)) << "a root that moves 1024 m away";
  EXPECT_FALSE(with(kPelvis + 1 + 2, 0x02)) << "a component about 2";
}

}  // namespace
}  // namespace flinch::database

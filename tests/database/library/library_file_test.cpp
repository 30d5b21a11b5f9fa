// SPDX-License-Identifier: MIT
#include "database/library/library_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "database/files/file_io.h"
#include "database/files/library_writer.h"
#include "database/library/library_bounds.h"
#include "library_generated.h"
#include "tests/database/library/random_library.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/file_damage.h"
#include "tests/scenes/not_finite.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::database {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using tests::kNan;
using tests::random_library;
using tests::with_header;

LoadStatus read(const std::string& bytes, ClipLibrary& library) {
  return read_library(bytes_of(bytes), library);
}

void expect_same(const motion::PerRole<Eigen::Vector3f>& one,
                 const motion::PerRole<Eigen::Vector3f>& other) {
  EXPECT_TRUE(std::equal(one.begin(), one.end(), other.begin()));
}

void expect_same(const std::vector<motion::Pose>& one, const std::vector<motion::Pose>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].root_position, other[i].root_position);
    for (motion::Role role : motion::kRoles) {
      EXPECT_EQ(one[i].rotation[role].coeffs(), other[i].rotation[role].coeffs());
    }
  }
}

void expect_same(const motion::Clip& one, const motion::Clip& other) {
  EXPECT_EQ(one.name, other.name);
  EXPECT_EQ(one.purpose, other.purpose);
  EXPECT_EQ(one.kind, other.kind);
  EXPECT_EQ(one.source, other.source);
  EXPECT_EQ(one.mirrored_from, other.mirrored_from);
  EXPECT_EQ(one.motion.rate_hz, other.motion.rate_hz);
  expect_same(one.motion.poses, other.motion.poses);
  ASSERT_EQ(one.push.has_value(), other.push.has_value());
  if (one.push) {
    EXPECT_EQ(one.push->contact_s, other.push->contact_s);
    EXPECT_EQ(one.push->peak_s, other.push->peak_s);
    EXPECT_EQ(one.push->place, other.push->place);
    EXPECT_EQ(one.push->direction, other.push->direction);
    EXPECT_EQ(one.push->velocity, other.push->velocity);
  }
  ASSERT_EQ(one.annotation.has_value(), other.annotation.has_value());
  if (!one.annotation) return;
  EXPECT_EQ(one.annotation->target, other.annotation->target);
  EXPECT_EQ(one.annotation->direction, other.annotation->direction);
  EXPECT_EQ(one.annotation->degree, other.annotation->degree);
  EXPECT_EQ(one.annotation->onset_s, other.annotation->onset_s);
  EXPECT_EQ(one.annotation->peak_s, other.annotation->peak_s);
  EXPECT_EQ(one.annotation->end_s, other.annotation->end_s);
}

void expect_same(const ClipLibrary& one, const ClipLibrary& other) {
  EXPECT_EQ(one.name, other.name);
  expect_same(one.character.skeleton.offset, other.character.skeleton.offset);
  expect_same(one.character.skeleton.tip, other.character.skeleton.tip);
  EXPECT_EQ(one.character.mass_kg, other.character.mass_kg);
  EXPECT_EQ(one.character.sex, other.character.sex);
  EXPECT_EQ(one.rate_hz, other.rate_hz);
  EXPECT_EQ(one.idle, other.idle);
  ASSERT_EQ(one.clips.size(), other.clips.size());
  for (std::size_t i = 0; i < one.clips.size(); ++i) expect_same(one.clips[i], other.clips[i]);
}

TEST(LibraryFile, RoundTripsBitForBit) {
  const tests::TemporaryFolder folder;
  for (unsigned seed = 0; seed < 5; ++seed) {
    const ClipLibrary library = random_library(seed, 40);
    const std::uint64_t hash = write_library(library, folder / "a.flinchlib");
    ClipLibrary read;
    ASSERT_EQ(read_library(folder / "a.flinchlib", read), LoadStatus::ok);
    expect_same(read, library);
    EXPECT_EQ(read.hash, hash);
    expect_same(load_library(folder / "a.flinchlib"), library);
  }
}

TEST(LibraryFile, HashDependsOnTheContentOnly) {
  ClipLibrary library = random_library(1, 3);
  const std::string bytes = library_bytes(library);
  library.hash = 17;
  EXPECT_EQ(library_bytes(library), bytes);
  ClipLibrary read;
  ASSERT_EQ(database::read_library(bytes_of(bytes), read), LoadStatus::ok);
  EXPECT_EQ(library_bytes(read), bytes);
  const std::uint64_t hash = read.hash;
  EXPECT_NE(hash, 0U);
  library.clips[2].motion.poses[1].root_position.x() += 1e-6F;
  ASSERT_EQ(database::read_library(bytes_of(library_bytes(library)), read), LoadStatus::ok);
  EXPECT_NE(read.hash, hash);
}

TEST(LibraryFile, ProvenanceChangesTheFileAndNotTheHash) {
  const tests::TemporaryFolder folder;
  ClipLibrary library = random_library(1, 3);
  const std::string bare = library_bytes(library);
  const std::uint64_t hash = write_library(library, folder / "a.flinchlib");
  library.provenance = R"({"command":"author"})";
  EXPECT_EQ(write_library(library, folder / "b.flinchlib"), hash);
  EXPECT_EQ(bare_library_bytes(library), bare);
  const std::string bytes = library_bytes(library);
  EXPECT_NE(bytes, bare);
  ClipLibrary read_back;
  ASSERT_EQ(read(bytes, read_back), LoadStatus::ok);
  EXPECT_EQ(read_back.hash, hash);
  EXPECT_EQ(read_back.provenance, library.provenance);
  EXPECT_EQ(library_bytes(read_back), bytes);
}

TEST(LibraryFile, ItsHashWithoutProvenanceIsComputedAgain) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    ClipLibrary library = random_library(seed, 3);
    library.name += std::string(seed, 'x');
    if (seed % 2 == 0) library.idle = 0;
    library.provenance = std::string(1 + seed % 5, 'p');
    ClipLibrary read_back;
    ASSERT_EQ(read(library_bytes(library), read_back), LoadStatus::ok) << seed;
    EXPECT_EQ(library_bytes(read_back), library_bytes(library));
  }
}

TEST(LibraryFile, ThatNamesTheHashOfOtherClipsIsRefused) {
  const tests::TemporaryFolder folder;
  ClipLibrary library = random_library(1, 3);
  library.provenance = R"({"command":"author"})";
  const std::string whole = tests::content_of(library_bytes(library));
  std::string other_hash = whole;
  ASSERT_TRUE(flatbuffers::GetMutableRoot<flatbuffers::Table>(other_hash.data())
                  ->SetField<std::uint64_t>(schema::Library::VT_BARE_HASH, 17, 0));
  // A float of the last clip's push.
  std::string other_clips = whole;
  const float contact_s = 0.005F;
  const std::size_t found =
      whole.find(std::string(reinterpret_cast<const char*>(&contact_s), sizeof contact_s));
  ASSERT_NE(found, std::string::npos);
  ++other_clips[found];
  for (const std::string& forged : {other_hash, other_clips}) {
    const std::string file = with_header(kLibraryFormat, forged);
    ClipLibrary read_back;
    EXPECT_EQ(read(file, read_back), LoadStatus::other_content);
    EXPECT_TRUE(read_back.clips.empty());
    write_file_atomically(folder / "a.flinchlib", file);
    EXPECT_THAT(tests::error_of([&] { load_library(folder / "a.flinchlib"); }),
                testing::EndsWith("a.flinchlib: the library names a hash that its clips do not "
                                  "have; make it again"));
  }
}

TEST(LibraryFile, ProvenanceHasItsBounds) {
  ClipLibrary library = random_library(1, 3);
  library.provenance = std::string(kMaxProvenanceSize, 'x');
  EXPECT_NO_THROW(library_bytes(library));
  library.provenance += 'x';
  EXPECT_THAT(tests::error_of([&] { library_bytes(library); }), HasSubstr("the provenance is"));
  library.provenance = "\x1b[2J";
  EXPECT_THAT(tests::error_of([&] { library_bytes(library); }), HasSubstr("the provenance is"));
}

/// A stance that goes 1 m along in a second.
ClipLibrary library_with_stance() {
  ClipLibrary library = random_library(6, 61);
  motion::Clip& stance = library.clips[3];
  stance.purpose = motion::Purpose::stance;
  for (std::size_t k = 0; k < stance.motion.poses.size(); ++k) {
    motion::Pose& pose = stance.motion.poses[k];
    pose = motion::Pose();
    pose.root_position = {static_cast<float>(k) / 60, 0, 1};
  }
  return library;
}

TEST(LibraryFile, OfFloatsIsOfFormat3OnlyWithStances) {
  const std::string without = library_bytes(random_library(6, 3));
  const std::string with = library_bytes(library_with_stance());
  EXPECT_EQ(without[7], 2);
  EXPECT_EQ(with[7], 3);
  ClipLibrary library;
  ASSERT_EQ(read(with, library), LoadStatus::ok);
  expect_same(library, library_with_stance());
  EXPECT_EQ(stance_clips(library), (std::vector<int>{1, 3}));
  for (std::string wrong : {without, with}) {
    wrong[7] = static_cast<char>(5 - wrong[7]);
    EXPECT_EQ(read(wrong, library), LoadStatus::damaged);
  }
}

TEST(LibraryFile, StancesThatDoNotLoopAreRefused) {
  const auto message_for = [](const auto& change) {
    ClipLibrary library = library_with_stance();
    change(library.clips[3]);
    return tests::error_of([&] { library_bytes(library); });
  };
  EXPECT_EQ(message_for([](motion::Clip&) {}), "");
  EXPECT_THAT(
      message_for([](motion::Clip& clip) { clip.motion.poses.back().root_position.z() += 0.01F; }),
      HasSubstr("clip 3 (walk) is a stance whose last pose does not continue as its first"));
  EXPECT_THAT(message_for([](motion::Clip& clip) { clip.motion.poses.resize(1); }),
              HasSubstr("is a stance of a single pose"));
}

TEST(LibraryFile, ReadsUnalignedBytes) {
  const std::string bytes = library_bytes(random_library(2, 3));
  for (std::size_t shift = 0; shift < 16; ++shift) {
    const std::string moved = std::string(shift, 'x') + bytes;
    ClipLibrary library;
    EXPECT_EQ(read_library(bytes_of(moved).subspan(shift), library), LoadStatus::ok);
  }
}

TEST(LibraryFile, DetectsAnyFlippedBit) {
  const std::string bytes = library_bytes(random_library(3, 2));
  ClipLibrary library;
  tests::expect_flips_are_refused(
      bytes, tests::every_bit(bytes.size()),
      [&](const std::string& flipped) { return read(flipped, library) != LoadStatus::ok; });
  EXPECT_TRUE(library.clips.empty()) << "a refused file must leave the library as it was";
  EXPECT_EQ(read(bytes, library), LoadStatus::ok);
}

TEST(LibraryFile, DetectsTruncationAndTrailingBytes) {
  const std::string bytes = library_bytes(random_library(3, 2));
  ClipLibrary library;
  tests::expect_wrong_sizes_are_refused(
      bytes, tests::places(bytes.size()),
      [&](const std::string& wrong) { return read(wrong, library) != LoadStatus::ok; });
  EXPECT_EQ(read(bytes + '\0', library), LoadStatus::damaged);
}

TEST(LibraryFile, StatusNamesTheProblem) {
  const std::string bytes = library_bytes(random_library(3, 2));
  ClipLibrary library;
  EXPECT_EQ(read_library("no/such/file", library), LoadStatus::cannot_open);
  EXPECT_EQ(read_library(FLINCH_SOURCE_DIR, library), LoadStatus::not_a_file);
  EXPECT_EQ(read("", library), LoadStatus::not_a_library);
  EXPECT_EQ(read("HIERARCHY\nROOT Hips", library), LoadStatus::not_a_library);
  std::string other = bytes;
  other[7] = static_cast<char>(kLibraryFormat.newest_read + 1);
  EXPECT_EQ(read(other, library), LoadStatus::other_version);
  EXPECT_EQ(read(bytes.substr(0, 100), library), LoadStatus::damaged);
}

TEST(LibraryFile, CorruptContentWithAValidHeaderLoadsOnlyIfItKeepsTheInvariants) {
  const std::string file = library_bytes(random_library(4, 2));
  const auto damage = [](std::string& content, std::mt19937_64& random) {
    for (std::uint64_t edits = 1 + random() % 3; edits > 0; --edits) {
      content[random() % content.size()] = static_cast<char>(random() % 256);
    }
    if (random() % 10 == 0) content.resize(random() % content.size());
  };
  const auto reads = [](const std::string& damaged) {
    ClipLibrary library;
    if (read(damaged, library) != LoadStatus::ok) return false;
    EXPECT_FALSE(fault_of(library));
    return true;
  };
  const tests::ReadCounts counts =
      tests::try_damaged_content(kLibraryFormat, file, 20000, 4, damage, reads);
  EXPECT_GT(counts.refused, 1000);
}

/// Returns the content with the bytes of one float, which must occur once, replaced by another's.
std::string with_float(const std::string& content, float what, float with) {
  std::string bytes = content;
  const auto pattern = std::as_bytes(std::span(&what, 1));
  const auto same = [](char a, std::byte b) { return static_cast<std::byte>(a) == b; };
  const auto found = std::search(bytes.begin(), bytes.end(), pattern.begin(), pattern.end(), same);
  EXPECT_NE(found, bytes.end());
  std::transform(std::as_bytes(std::span(&with, 1)).begin(),
                 std::as_bytes(std::span(&with, 1)).end(), found,
                 [](std::byte byte) { return static_cast<char>(byte); });
  return bytes;
}

TEST(LibraryFile, RefusesBrokenInvariantsDespiteAValidHeader) {
  ClipLibrary library = random_library(5, 3);
  library.clips[3].motion.poses[2].root_position.z() = 123.456F;
  const std::string content = tests::content_of(library_bytes(library));
  const float mass = library.character.mass_kg;
  const float component = library.clips[0].motion.poses[1].rotation[motion::Role::head].w();
  const float peak = library.clips[0].annotation->peak_s;
  ClipLibrary read_back;
  EXPECT_EQ(read(with_header(kLibraryFormat, with_float(content, mass, 62)), read_back),
            LoadStatus::ok);
  EXPECT_EQ(read_back.character.mass_kg, 62);
  for (const std::string& wrong :
       {with_float(content, mass, kNan), with_float(content, mass, 0),
        with_float(content, 123.456F, kNan), with_float(content, component, component + 0.5F),
        with_float(content, component, kNan), with_float(content, peak, 9),
        with_float(content, peak, kNan)}) {
    EXPECT_EQ(read(with_header(kLibraryFormat, wrong), read_back), LoadStatus::damaged);
  }
}

struct Breakage {
  const char* words;
  std::function<void(ClipLibrary&)> apply;
};

TEST(LibraryFile, RefusesToWriteAnInvalidLibrary) {
  const Breakage breakages[] = {
      {"no name", [](ClipLibrary& l) { l.name.clear(); }},
      {"clip 2 () has no name", [](ClipLibrary& l) { l.clips[2].name.clear(); }},
      {"clip 3 (idle) shares its name", [](ClipLibrary& l) { l.clips[3].name = "idle"; }},
      {"rate", [](ClipLibrary& l) { l.rate_hz = 0; }},
      {"push at a joint", [](ClipLibrary& l) { l.clips[3].push->place = motion::Role::left_foot; }},
      {"push at a joint", [](ClipLibrary& l) { l.clips[3].push->place = motion::Role{99}; }},
      {"push from a direction", [](ClipLibrary& l) { l.clips[3].push->direction = kNan; }},
      {"20 m/s", [](ClipLibrary& l) { l.clips[3].push->velocity.x() = kNan; }},
      {"contact < peak", [](ClipLibrary& l) { l.clips[3].push->contact_s = 0.0249F; }},
      {"contact < peak", [](ClipLibrary& l) { l.clips[3].push->peak_s = 9; }},
      {"another rate", [](ClipLibrary& l) { l.clips[0].motion.rate_hz = 30; }},
      {"mass", [](ClipLibrary& l) { l.character.mass_kg = -1; }},
      {"skeleton", [](ClipLibrary& l) { l.character.skeleton.tip[motion::Role::head].x() = kNan; }},
      {"no idle", [](ClipLibrary& l) { l.idle = -1; }},
      {"no idle", [](ClipLibrary& l) { l.idle = 4; }},
      {"no idle", [](ClipLibrary& l) { l.clips.clear(); }},
      {"no poses", [](ClipLibrary& l) { l.clips[3].motion.poses.clear(); }},
      {"not finite", [](ClipLibrary& l) { l.clips[3].motion.poses[1].root_position.y() = kNan; }},
      {"unit",
       [](ClipLibrary& l) { l.clips[3].motion.poses[1].rotation[motion::Role::neck].w() += 2; }},
      {"target", [](ClipLibrary& l) { l.clips[0].annotation->target = motion::Target{4}; }},
      {"degree", [](ClipLibrary& l) { l.clips[0].annotation->degree = motion::Degree{2}; }},
      {"purpose", [](ClipLibrary& l) { l.clips[0].purpose = motion::Purpose{4}; }},
      {"sex", [](ClipLibrary& l) { l.character.sex = motion::Sex{2}; }},
      {"eight", [](ClipLibrary& l) { l.clips[0].annotation->direction = 0.1F; }},
      {"eight",
       [](ClipLibrary& l) { l.clips[0].annotation->direction = -std::numbers::pi_v<float>; }},
      {"eight", [](ClipLibrary& l) { l.clips[0].annotation->direction = kNan; }},
      {"onset", [](ClipLibrary& l) { l.clips[0].annotation->onset_s = -0.1F; }},
      {"onset", [](ClipLibrary& l) { l.clips[0].annotation->peak_s = 0; }},
      {"onset", [](ClipLibrary& l) { l.clips[0].annotation->end_s = 0.01F; }},
      {"onset", [](ClipLibrary& l) { l.clips[0].annotation->end_s += 0.01F; }},
  };
  const tests::TemporaryFolder folder;
  for (const Breakage& breakage : breakages) {
    ClipLibrary library = random_library(6, 3);
    EXPECT_FALSE(fault_of(library));
    breakage.apply(library);
    EXPECT_THAT(tests::error_of([&] { write_library(library, folder / "a.flinchlib"); }),
                HasSubstr(breakage.words));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(LoadLibrary, NamesTheActualFileKind) {
  const tests::TemporaryFolder folder;
  const auto message_for = [&](const std::string& bytes) {
    const std::string path = folder.write("file", bytes);
    return tests::error_of([&] { load_library(path); });
  };
  EXPECT_THAT(message_for(""), StartsWith(folder / "file: is an empty file, not a library"));
  EXPECT_THAT(message_for("HIERARCHY\n"), HasSubstr("is a BVH file,"));
  EXPECT_THAT(message_for(std::string("SQLite format 3\0\x10", 17)), HasSubstr("is a store"));
  EXPECT_THAT(message_for("FLINCHS\x01"), HasSubstr("is a selector,"));
  EXPECT_THAT(message_for("PK\x03\x04"), HasSubstr("is an archive,"));
  EXPECT_THAT(message_for("some text\n"), HasSubstr("is a text file,"));
  EXPECT_THAT(message_for("\x01\x02"), HasSubstr("no file that Flinch knows,"));
  EXPECT_THAT(message_for("FLINCHL\x02 cut"), HasSubstr("damaged"));
  EXPECT_THAT(message_for("FLINCHL\x09 and something"),
              HasSubstr("this program reads format 2 to 4"));
  EXPECT_THAT(tests::error_of([&] { load_library(folder / "none"); }), HasSubstr("No such file"));
}

TEST(HashText, IsSixteenHexadecimalDigits) {
  EXPECT_EQ(hash_text(0), "0000000000000000");
  EXPECT_EQ(hash_text(0x0123456789ABCDEF), "0123456789abcdef");
}

}  // namespace
}  // namespace flinch::database

// SPDX-License-Identifier: MIT
#include "runtime/library.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <random>

#include "database/files/file_io.h"
#include "database/library/library_file.h"
#include "motion/error.h"
#include "runtime/character.h"
#include "runtime/response/prepared_library.h"
#include "runtime/selection.h"
#include "runtime/selector_file.h"
#include "selector_generated.h"
#include "tests/motion/random_motion.h"
#include "tests/runtime/made_up_selector.h"
#include "tests/scenes/file_damage.h"
#include "tests/scenes/not_finite.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::runtime {
namespace {

using database::bytes_of;
using database::LoadStatus;
using motion::Target;
using tests::MadeUpSelector;
using tests::ModelKind;

const MadeUpSelector& made_up() {
  static const MadeUpSelector kMadeUp =
      tests::made_up_selector(tests::made_up_library(12, 61), 60, ModelKind::svm);
  return kMadeUp;
}

const std::string& whole_file() {
  static const std::string kFile = made_up().file();
  return kFile;
}

/// Expects that a library is the one in whole_file().
void expect_whole(const Library& library) {
  ASSERT_TRUE(library.is_loaded());
  EXPECT_EQ(database::library_bytes(library.clip_library()), made_up().library_file);
  EXPECT_EQ(library.clip_library().hash, made_up().selector.library_hash);
  EXPECT_EQ(train::selector_bytes(library.selector(), made_up().library_bytes()), whole_file());
  EXPECT_EQ(library.prepared().library, &library.clip_library());
  EXPECT_EQ(library.prepared().footwork.size(), library.clip_library().clips.size());
  EXPECT_EQ(library.selection_bytes(), selection_bytes(made_up().selector));
}

TEST(Library, LoadsEverythingInTheFile) {
  Library library;
  EXPECT_FALSE(library.is_loaded());
  ASSERT_EQ(library.load(bytes_of(whole_file())), LoadStatus::ok);
  expect_whole(library);
  const tests::TemporaryFolder folder;
  database::write_file_atomically(folder / "a.flinch", whole_file());
  Library from_file;
  ASSERT_EQ(from_file.load(folder / "a.flinch"), LoadStatus::ok);
  expect_whole(from_file);
}

TEST(Library, TakesFootworkFromTheFileAsItWouldComputeIt) {
  Library library;
  ASSERT_EQ(library.load(bytes_of(whole_file())), LoadStatus::ok);
  SelectorFile file;
  ASSERT_EQ(read_selector_file(bytes_of(whole_file()), file), LoadStatus::ok);
  const PreparedLibrary computed = prepare(library.clip_library());
  ASSERT_EQ(file.footwork.size(), computed.footwork.size());
  std::size_t swings = 0;
  for (std::size_t clip = 0; clip < computed.footwork.size(); ++clip) {
    EXPECT_EQ(file.footwork[clip].support, computed.footwork[clip].support);
    for (const motion::Side side : motion::kSides) {
      const auto& stored = library.prepared().footwork[clip].swings[side];
      const auto& expected = computed.footwork[clip].swings[side];
      swings += expected.size();
      EXPECT_TRUE(std::ranges::equal(stored, expected, [](const Swing& a, const Swing& b) {
        return a.begin_s == b.begin_s && a.end_s == b.end_s;
      }));
    }
  }
  EXPECT_GT(swings, 0U) << "no clip lifts a foot";
}

TEST(Library, RefusesFootworkThatIsNoneOfItsClips) {
  SelectorFile file;
  ASSERT_EQ(read_selector_file(bytes_of(whole_file()), file), LoadStatus::ok);
  const auto is_sound_with = [&](auto change) {
    std::vector<Footwork> footwork = file.footwork;
    footwork[1].swings[motion::Side::left] = {{0.1F, 0.2F}, {0.3F, 0.4F}};
    change(footwork, footwork[1].swings[motion::Side::left]);
    return is_sound(footwork, *file.library);
  };
  using Swings = std::vector<Swing>;
  using All = std::vector<Footwork>;
  EXPECT_TRUE(is_sound_with([](All&, Swings&) {}));
  EXPECT_FALSE(is_sound_with([](All& all, Swings&) { all.pop_back(); }));
  EXPECT_FALSE(is_sound_with([](All& all, Swings&) { all[0].support = motion::Side{2}; }));
  EXPECT_FALSE(is_sound_with([](All&, Swings& swings) { swings[0].begin_s = -0.1F; }));
  EXPECT_FALSE(is_sound_with([](All&, Swings& swings) { swings[0].end_s = 0.1F; }));
  EXPECT_FALSE(is_sound_with([](All&, Swings& swings) { swings[0].end_s = 0.14F; })) << "noise";
  EXPECT_FALSE(is_sound_with([](All&, Swings& swings) { swings[0].end_s = 0.26F; })) << "noise";
  EXPECT_FALSE(is_sound_with([](All&, Swings& swings) { swings[1].begin_s = 0.15F; }));
  EXPECT_FALSE(is_sound_with([](All&, Swings& swings) { swings[1].end_s = 1000; }));
  EXPECT_FALSE(is_sound_with([](All&, Swings& swings) { swings[1].end_s = tests::kNan; }));
}

/// whole_file() with other footwork of as many swings, which the clips contradict.
std::string with_made_up_footwork(std::mt19937& random, const database::ClipLibrary& clips) {
  std::string content = tests::content_of(whole_file());
  const schema::Footwork& stored = *schema::GetSelector(content.data())->footwork();
  std::size_t next = 0;
  const auto write = [&](const auto& numbers, std::size_t place, auto number) {
    std::memcpy(content.data() +
                    (numbers.Data() - reinterpret_cast<const std::uint8_t*>(content.data())) +
                    place * sizeof number,
                &number, sizeof number);
  };
  for (std::size_t i = 0; i < stored.counts()->size(); ++i) {
    const motion::Clip& clip = clips.clips[i / 2];
    const auto count = stored.counts()->Get(static_cast<flatbuffers::uoffset_t>(i));
    const float onset_s = clip.annotation ? clip.annotation->onset_s : 0;
    const float share_s = (clip.motion.duration_s() - onset_s) / static_cast<float>(count);
    for (std::uint32_t k = 0; k < count; ++k) {
      const float begin_s =
          onset_s + share_s * (static_cast<float>(k) + tests::uniform(random, 0, 0.2F));
      const float end_s = begin_s + share_s * tests::uniform(random, 0.3F, 0.6F);
      write(*stored.swings(), next++, begin_s);
      write(*stored.swings(), next++, end_s);
    }
    write(*stored.support(), i / 2, static_cast<std::uint8_t>(random() % 2));
  }
  return tests::with_header(database::kSelectorFormat, content);
}

TEST(Library, PlaysSoundPosesWhateverItsFootworkClaims) {
  Library honest;
  ASSERT_EQ(honest.load(bytes_of(whole_file())), LoadStatus::ok);
  std::mt19937 random(1);
  int different = 0;
  for (int sample = 0; sample < 20; ++sample) {
    Library library;
    ASSERT_EQ(library.load(bytes_of(with_made_up_footwork(random, honest.clip_library()))),
              LoadStatus::ok);
    for (int clip = 1; clip < static_cast<int>(library.clip_library().clips.size()); ++clip) {
      Character told(library);
      Character expected(honest);
      told.respond(clip, 0.6F);
      expected.respond(clip, 0.6F);
      for (int frame = 0; frame < 40; ++frame) {
        told.update(0.03F);
        expected.update(0.03F);
        ASSERT_TRUE(motion::is_sound(told.pose()));
        if ((told.pose().root_position - expected.pose().root_position).norm() > 1e-4F) ++different;
      }
    }
  }
  EXPECT_GT(different, 0) << "the file's footwork is not used";
}

/// A selector's file without clips, and a library of its clips alone.
std::string bare_file() {
  return train::selector_bytes(made_up().selector);
}

Library clips_alone() {
  database::ClipLibrary clips;
  EXPECT_EQ(database::read_library(made_up().library_bytes(), clips), LoadStatus::ok);
  Library owner;
  EXPECT_EQ(owner.take(std::move(clips)), LoadStatus::ok);
  return owner;
}

TEST(Library, SelectorsWithoutClipsShareThoseOfAnOwner) {
  Library owner = clips_alone();
  const database::ClipLibrary* const shared = &owner.clip_library();
  Library first;
  Library second;
  EXPECT_EQ(first.load(bytes_of(bare_file())), LoadStatus::without_clips);
  ASSERT_EQ(first.load(bytes_of(bare_file()), owner), LoadStatus::ok);
  ASSERT_EQ(second.load(bytes_of(whole_file()), first), LoadStatus::ok) << "an owner with selector";
  owner = Library();
  for (const Library* library : {&first, &second}) {
    expect_whole(*library);
    EXPECT_EQ(&library->clip_library(), shared);
  }
  const tests::TemporaryFolder folder;
  database::write_file_atomically(folder / "a.flinchlib", made_up().library_file);
  database::write_file_atomically(folder / "a.flinch", bare_file());
  ASSERT_EQ(owner.take(folder / "a.flinchlib"), LoadStatus::ok);
  ASSERT_EQ(second.load(folder / "a.flinch", owner), LoadStatus::ok);
  expect_whole(second);
  EXPECT_EQ(&second.clip_library(), &owner.clip_library());
}

TEST(Library, RefusesTheClipsOfAnotherLibrary) {
  Library other;
  ASSERT_EQ(other.take(tests::made_up_library(12, 60)), LoadStatus::ok);
  Library library;
  ASSERT_EQ(library.load(bytes_of(whole_file())), LoadStatus::ok);
  EXPECT_EQ(library.load(bytes_of(bare_file()), other), LoadStatus::other_library);
  expect_whole(library);
  database::ClipLibrary forged;  // of the right hash and too few clips
  ASSERT_EQ(database::read_library(made_up().library_bytes(), forged), LoadStatus::ok);
  forged.clips.pop_back();
  ASSERT_EQ(other.take(std::move(forged)), LoadStatus::ok);
  EXPECT_EQ(library.load(bytes_of(bare_file()), other), LoadStatus::damaged);
  EXPECT_EQ(library.load(bytes_of(bare_file().substr(0, 900)), clips_alone()), LoadStatus::damaged);
  expect_whole(library);
}

TEST(Library, RefusesASelectorWithTheClipsOfAnotherHash) {
  constexpr std::uint64_t kOtherHash = 17;
  const auto forged = [&](bool in_selector, bool in_library) {
    std::string content = tests::content_of(whole_file());
    auto* table = flatbuffers::GetMutableRoot<flatbuffers::Table>(content.data());
    if (in_selector) {
      EXPECT_TRUE(table->SetField<std::uint64_t>(schema::Selector::VT_LIBRARY_HASH, kOtherHash, 0));
    }
    const auto* clips = schema::GetSelector(content.data())->library();
    const auto hash_at = clips->data() + 8 - reinterpret_cast<const std::uint8_t*>(content.data());
    if (in_library) std::memcpy(content.data() + hash_at, &kOtherHash, sizeof kOtherHash);
    return tests::with_header(database::kSelectorFormat, content);
  };
  Library library;
  ASSERT_EQ(library.load(bytes_of(forged(false, false))), LoadStatus::ok);
  for (const auto& [in_selector, in_library] :
       {std::pair(true, false), std::pair(false, true), std::pair(true, true)}) {
    const std::string file = forged(in_selector, in_library);
    EXPECT_EQ(library.load(bytes_of(file)), LoadStatus::other_content);
    EXPECT_EQ(library.load(bytes_of(file), clips_alone()), LoadStatus::other_content);
  }
  expect_whole(library);
}

TEST(Library, LoadsFromUnalignedBytes) {
  for (std::size_t shift = 0; shift < 16; ++shift) {
    const std::string moved = std::string(shift, 'x') + whole_file();
    Library library;
    ASSERT_EQ(library.load(bytes_of(moved).subspan(shift)), LoadStatus::ok) << shift;
    EXPECT_EQ(database::library_bytes(library.clip_library()), made_up().library_file);
  }
}

TEST(Library, ContentsKeepTheirAddressAfterAMove) {
  Library library;
  ASSERT_EQ(library.load(bytes_of(whole_file())), LoadStatus::ok);
  const database::ClipLibrary* clips = &library.clip_library();
  const Library moved = std::move(library);
  EXPECT_EQ(&moved.clip_library(), clips);
  expect_whole(moved);
}

TEST(Library, FailedLoadLeavesItUnchanged) {
  Library library;
  ASSERT_EQ(library.load(bytes_of(whole_file())), LoadStatus::ok);
  EXPECT_EQ(library.load("no such file"), LoadStatus::cannot_open);
  EXPECT_EQ(library.load("/"), LoadStatus::not_a_file);
  EXPECT_EQ(library.load(bytes_of("HIERARCHY")), LoadStatus::not_a_library);
  EXPECT_EQ(library.load(made_up().library_bytes()), LoadStatus::not_a_library);
  EXPECT_EQ(library.load(bytes_of(train::selector_bytes(made_up().selector))),
            LoadStatus::without_clips);
  EXPECT_EQ(library.load(bytes_of(whole_file()).first(1000)), LoadStatus::damaged);
  expect_whole(library);
}

TEST(SelectorFile, SelectsWithoutClips) {
  SelectorFile file;
  ASSERT_EQ(read_selector_file(bytes_of(train::selector_bytes(made_up().selector)), file),
            LoadStatus::ok);
  EXPECT_FALSE(file.library.has_value());
  for (int target = 0; target < motion::kTargetCount; ++target) {
    EXPECT_EQ(models::select(file.selector, {}, static_cast<Target>(target)),
              models::select(made_up().selector, {}, static_cast<Target>(target)));
  }
}

TEST(Library, RejectsATruncatedFile) {
  const std::vector<std::size_t> sizes = tests::places(whole_file().size(), 1000);
  tests::expect_wrong_sizes_are_refused(whole_file(), sizes, [](const std::string& wrong) {
    Library library;
    return library.load(bytes_of(wrong)) != LoadStatus::ok && !library.is_loaded();
  });
  EXPECT_GT(sizes.size(), 200U);
}

TEST(Library, RejectsAChangedByte) {
  std::mt19937_64 random(1);
  // Each byte of the seal and of the tables, which come first, is changed in turn.
  std::vector<std::size_t> bytes = tests::places(200);
  while (bytes.size() < 2000) bytes.push_back(random() % whole_file().size());
  Library library;
  tests::expect_flips_are_refused(whole_file(), tests::random_flips(bytes, random),
                                  [&](const std::string& flipped) {
                                    return library.load(bytes_of(flipped)) != LoadStatus::ok;
                                  });
  EXPECT_FALSE(library.is_loaded());
  EXPECT_EQ(library.load(bytes_of(whole_file())), LoadStatus::ok);
}

// Damage that the seal does not show, because the file was sealed after it. The clips' own seal is
// not verified against accidents, so the checks of the content alone must reject it.
TEST(Library, CorruptContentWithAValidSealIsRejectedOrSafe) {
  const std::size_t clips = whole_file().find("FLINCHL");
  ASSERT_NE(clips, std::string::npos);
  EXPECT_EQ(clips % 16, 0U) << "the clips are read in place";
  const std::size_t clips_in_content = clips - database::kFileHeaderSize;
  const auto damage = [&](std::string& content, std::mt19937_64& random) {
    const std::size_t places[] = {random() % content.size(), random() % 400,
                                  clips_in_content + random() % 400,
                                  clips_in_content + random() % made_up().library_file.size(),
                                  content.size() - 1 - random() % 4000};
    content[places[random() % 5]] = static_cast<char>(random());
  };
  Workspace workspace;
  const auto reads = [&](const std::string& damaged) {
    Library library;
    if (library.load(bytes_of(damaged)) != LoadStatus::ok) return false;
    EXPECT_EQ(workspace.reserve_memory(library.selection_bytes()), LoadStatus::ok);
    const Selection selection = select(workspace, library.selector(), {}, Target::trunk, {});
    EXPECT_EQ(selection.status, SelectStatus::ok);
    EXPECT_LT(static_cast<std::size_t>(selection.clip), library.clip_library().clips.size());
    return true;
  };
  const tests::ReadCounts counts =
      tests::try_damaged_content(database::kSelectorFormat, whole_file(), 1500, 2, damage, reads);
  EXPECT_GT(counts.refused, 100);
  EXPECT_GT(counts.read, 100);
}

TEST(SelectorFile, RefusesToWriteClipsOfAnotherLibrary) {
  const auto other_library = [](const std::function<void(database::ClipLibrary&)>& change) {
    database::ClipLibrary library = tests::made_up_library(12, 61);
    change(library);
    return database::library_bytes(library);
  };
  const auto fails = [](const models::Selector& selector, const std::string& library_file) {
    EXPECT_THROW(train::selector_bytes(selector, bytes_of(library_file)), Error);
  };
  models::Selector selector = made_up().selector;
  // Its hash changes.
  fails(selector, other_library([](auto& library) { library.name = "another"; }));
  fails(selector, "no library");
  fails(selector, made_up().library_file.substr(0, 5000));

  // The hash is right in these cases.
  const auto fails_by = [&](const std::function<void(database::ClipLibrary&)>& change) {
    const std::string library_file = other_library(change);
    models::Selector renamed = selector;
    renamed.library_hash = database::content_hash(bytes_of(library_file).subspan(16));
    fails(renamed, library_file);
  };
  fails_by([](auto& library) { library.clips.pop_back(); });
  fails_by([](auto& library) {
    library.clips.push_back(library.clips[3]);
    library.clips.back().name = "one more";
  });
  fails_by([](auto& library) { library.clips[3].name = "other"; });
  fails_by([](auto& library) { library.idle = 1; });
  fails_by([](auto& library) { library.clips[3].annotation.reset(); });
}

}  // namespace
}  // namespace flinch::runtime

// SPDX-License-Identifier: MIT
#include "train/realism/label_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "database/files/file_io.h"
#include "tests/runtime/push/push_scene.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::train {
namespace {

using testing::HasSubstr;
using tests::error_of;
using tests::TemporaryFolder;

std::vector<Label> labels(const tests::PushScene& scene, std::uint64_t seed, std::size_t count,
                          const std::string& judge) {
  std::vector<Label> all;
  for (std::size_t i = 0; i < count; ++i) {
    features::Random random(seed, features::RandomStream::realism, i);
    all.push_back({sample_example(scene.responses, random), static_cast<float>(random.uniform()),
                   judge, "monday"});
  }
  return all;
}

TEST(LabelFile, KeepsEveryLabelAsItWas) {
  const tests::PushScene scene;
  const TemporaryFolder folder;
  const std::string path = folder / "a.flinchlabels";
  const auto written = labels(scene, 1, 20, "\xC3\x89va");
  append_labels(path, scene.library, {written.begin(), written.begin() + 5});
  append_labels(path, scene.library, {written.begin() + 5, written.end()});
  const LabelSet read = read_labels(path, scene.library, scene.responses);
  ASSERT_EQ(read.labels.size(), written.size());
  for (std::size_t i = 0; i < written.size(); ++i) {
    const Label& a = read.labels[i];
    const Label& b = written[i];
    EXPECT_EQ(a.quality, b.quality);
    EXPECT_EQ(a.judge, b.judge);
    EXPECT_EQ(a.sitting, b.sitting);
    EXPECT_EQ(a.example.state_clip, b.example.state_clip);
    EXPECT_EQ(a.example.state_s, b.example.state_s);
    EXPECT_EQ(a.example.place, b.example.place);
    EXPECT_EQ(a.example.asked, b.example.asked);
    EXPECT_EQ(a.example.answer.response, b.example.answer.response);
    EXPECT_EQ(a.example.answer.deformation, b.example.answer.deformation);
    EXPECT_EQ(a.example.answer.taper, b.example.answer.taper);
    EXPECT_EQ(a.example.answer.turn, b.example.answer.turn);
  }
}

TEST(LabelFile, TwoJudgesWriteOneFileAndFilesAreJoined) {
  const tests::PushScene scene;
  const TemporaryFolder folder;
  const std::string path = folder / "a.flinchlabels";
  const auto one = labels(scene, 1, 1, "one");
  const auto other = labels(scene, 2, 1, "other");
  append_labels(path, scene.library, {});
  const auto write = [&](const std::vector<Label>& label) {
    for (int i = 0; i < 20; ++i) append_labels(path, scene.library, label);
  };
  std::thread second([&] { write(other); });
  write(one);
  second.join();
  const auto read = read_labels(path, scene.library, scene.responses).labels;
  EXPECT_EQ(read.size(), 40U);
  EXPECT_EQ(std::ranges::count(read, "one", &Label::judge), 20);
  const std::string text = database::read_file(path);
  folder.write("joined.flinchlabels", text + text);
  EXPECT_EQ(
      read_labels(folder / "joined.flinchlabels", scene.library, scene.responses).labels.size(),
      80U);
}

TEST(LabelFile, MergingTakesEachLabelOnce) {
  const tests::PushScene scene;
  const TemporaryFolder folder;
  const std::string path = folder / "a.flinchlabels";
  append_labels(path, scene.library, labels(scene, 1, 3, "one"));
  append_labels(folder / "b.flinchlabels", scene.library, labels(scene, 1, 3, "one"));
  append_labels(folder / "b.flinchlabels", scene.library, labels(scene, 2, 4, "other"));
  const std::vector<std::string> files(2, folder / "b.flinchlabels");
  const MergedLabels merged = merge_labels(path, scene.library, scene.responses, files);
  EXPECT_EQ(merged.added, 4U);
  EXPECT_EQ(merged.known, 3U + 7U);
  EXPECT_EQ(read_labels(path, scene.library, scene.responses).labels.size(), 7U);
}

TEST(LabelFile, RefusesInOneLineWhatIsNotWholeOrOfAnotherLibrary) {
  const tests::PushScene scene;
  const TemporaryFolder folder;
  const std::string path = folder / "a.flinchlabels";
  append_labels(path, scene.library, labels(scene, 1, 3, "one"));
  const std::string text = database::read_file(path);
  const auto message = [&](const std::string& changed, const database::ClipLibrary& library) {
    folder.write("b.flinchlabels", changed);
    return error_of([&] { read_labels(folder / "b.flinchlabels", library, scene.responses); });
  };
  EXPECT_EQ(message(text, scene.library), "");
  EXPECT_THAT(message(text.substr(0, text.size() - 9), scene.library),
              AllOf(HasSubstr("b.flinchlabels:4: is cut short"), HasSubstr("delete this line")));
  EXPECT_THAT(error_of([&] { append_labels(folder / "b.flinchlabels", scene.library, {}); }),
              HasSubstr("is cut short"));
  EXPECT_THAT(message("HIERARCHY\n", scene.library), HasSubstr("is not a label file"));
  database::ClipLibrary other = scene.library;
  other.hash = 5;
  EXPECT_THAT(message(text, other), AllOf(HasSubstr(":1: holds labels of another library"),
                                          HasSubstr("file of their own")));
  std::string wrong = text;
  wrong.replace(wrong.find("\"realism\":") + 10, 1, "7");
  EXPECT_THAT(message(wrong, scene.library), HasSubstr(":2: is no label of this library"));
  wrong = text;
  wrong.insert(wrong.find("\"taper\":") + 8, "-");
  EXPECT_THAT(message(wrong, scene.library), HasSubstr(":2: is no label of this library"));
  wrong = text;
  wrong.replace(wrong.rfind("\"response\":\"") + 12, 4, "nope");
  EXPECT_THAT(message(wrong, scene.library), HasSubstr(":4: is no label of this library"));
}

}  // namespace
}  // namespace flinch::train

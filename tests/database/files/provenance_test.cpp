// SPDX-License-Identifier: MIT
#include "database/files/provenance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "database/library/library_bounds.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::database {
namespace {

using testing::HasSubstr;

Provenance made() {
  Provenance provenance{.command = "simulate", .seed = 18446744073709551615U};
  add_option("threats", std::string("kinds"), std::string("default"), provenance);
  add_option("reference", false, false, provenance);
  add_option("brawn", std::optional<double>(0.1), provenance);
  add_option("k", std::optional<int>(), provenance);
  const std::string library = provenance_text({.command = "author"});
  provenance.inputs.push_back({"library", "", 0x0123456789abcdef, library});
  provenance.inputs.push_back({"threats", "b\xC3\xA4lle.toml", 7, ""});
  return provenance;
}

TEST(Provenance, ReadsBackWhatWasWritten) {
  const std::string text = provenance_text(made());
  const auto read = provenance_of(text);
  ASSERT_TRUE(read);
  EXPECT_EQ(provenance_text(*read), text);
  EXPECT_EQ(read->version, flinch_version());
  EXPECT_EQ(read->seed, 18446744073709551615U);
  ASSERT_EQ(read->options.size(), 2U);  // what has its default is left out
  EXPECT_EQ(read->options[1], (std::pair<std::string, std::string>("brawn", "0.1")));
  EXPECT_EQ(read->inputs[1].name, "b\xC3\xA4lle.toml");
  const auto library = provenance_of(read->inputs[0].provenance);
  ASSERT_TRUE(library);
  EXPECT_EQ(library->command, "author");
}

TEST(Provenance, WordsOfOtherTextsDiffer) {
  EXPECT_EQ(word_of("svm_rbf"), "svm_rbf");
  EXPECT_EQ(word_of("-0.5"), "-0.5");
  EXPECT_EQ(word_of("b\xC3\xA4lle.toml"), "b\xC3\xA4lle.toml");
  EXPECT_EQ(word_of(""), "''");
  EXPECT_EQ(word_of("ball, seed 7"), "'ball, seed 7'");
  EXPECT_EQ(word_of("'ball, seed 7'"), "''\\''ball, seed 7'\\'''");
}

TEST(Provenance, IsOneLineOfAscii) {
  for (const char c : provenance_text(made())) {
    EXPECT_GE(c, 0x20);
    EXPECT_LT(c, 0x7F);
  }
}

TEST(Provenance, RefusesOtherTexts) {
  const std::string text = provenance_text(made());
  const auto with = [&text](std::string_view old, std::string_view replaced) {
    std::string changed = text;
    changed.replace(changed.find(old), old.size(), replaced);
    return changed;
  };
  for (const std::string& wrong :
       {std::string(), std::string("7"), std::string("{}"), text.substr(1), text + "}",
        with("command", "commands"), with("\"kinds\"", "7"), with("kinds", "\\u001b"),
        with("0123456789abcdef", "0123456789abcdeg"), with("0123456789abcdef", "0123"),
        with("\"role\"", "\"rule\""), with("18446744073709551615", "-1"),
        with("\"author\"", "null"), std::string(100'000, '[')})
    EXPECT_FALSE(provenance_of(wrong)) << wrong.substr(0, 400);
  EXPECT_TRUE(provenance_of(text));
}

TEST(Provenance, TellsInputsOfInputsFourDeep) {
  std::string text = provenance_text({.command = "author"});
  for (int depth = 1; depth <= 6; ++depth) {
    text = provenance_text({.command = "evolve", .inputs = {{"library", "", 1, text}}});
    ASSERT_TRUE(provenance_of(text)) << depth;
    EXPECT_EQ(text.find("author") != std::string::npos, depth <= 4) << depth;
  }
}

TEST(Provenance, PassesOnNothingThatIsNone) {
  const std::string nested = std::string(500'000, '[') + std::string(500'000, ']');
  for (const std::string& foreign : {std::string("hello"), std::string("[]"), nested}) {
    const std::string text =
        provenance_text({.command = "simulate", .inputs = {{"library", "", 1, foreign}}});
    const auto read = provenance_of(text);
    ASSERT_TRUE(read) << foreign.substr(0, 10);
    EXPECT_EQ(read->inputs.at(0).provenance, "");
  }
}

TEST(Provenance, HasItsBound) {
  const Provenance long_one{.command = std::string(kMaxProvenanceSize, 'x')};
  EXPECT_THAT(tests::error_of([&] { provenance_text(long_one); }), HasSubstr("1048576 bytes"));
}

TEST(Provenance, ManyFilesBecomeOneInput) {
  const tests::TemporaryFolder folder;
  std::vector<std::string> files;
  for (int i = 0; i < 501; ++i) {
    files.push_back(folder / (std::to_string(i) + ".bvh"));
    std::ofstream(files.back()) << i;
  }
  Provenance few{.command = "import"};
  add_inputs("motion", {files.begin(), files.end() - 1}, few);
  EXPECT_EQ(few.inputs.size(), 500U);
  Provenance many{.command = "import"};
  add_inputs("motion", files, many);
  ASSERT_EQ(many.inputs.size(), 1U);
  EXPECT_EQ(many.inputs[0].name, "501 files");
  const std::uint64_t before = many.inputs[0].hash;
  std::ofstream(files[7]) << "another";
  many.inputs.clear();
  add_inputs("motion", files, many);
  EXPECT_NE(many.inputs[0].hash, before);
}

}  // namespace
}  // namespace flinch::database

// SPDX-License-Identifier: MIT
#include "train/report/export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <sstream>

#include "tests/train/evaluate/comparison.h"
#include "train/report/csv.h"

namespace flinch::train {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

TEST(Export, LibsvmTextRoundTripsTheTrainingSet) {
  for (const features::FeatureSet& features : features::feature_sets()) {
    Store store = made_up_store(50);
    derive_features(features.layout, store);
    const Labels labels = label(store.observations, default_cost(store.header));
    const features::Scaling scaling = scaling_of(store.header, store.observations);
    const models::TrainingSet set =
        make_training_set(store.header, store.observations, labels, scaling);
    EXPECT_EQ(set.feature_count, features.layout.size());
    std::istringstream lines(libsvm_text(store, labels, scaling));
    std::string line;
    int count = 0;
    for (; std::getline(lines, line); ++count) {
      std::istringstream fields(line);
      int label = -1;
      fields >> label;
      EXPECT_EQ(label, set.label[static_cast<std::size_t>(count)]);
      for (int k = 0; k < set.feature_count; ++k) {
        std::string field;
        fields >> field;
        const std::size_t colon = field.find(':');
        EXPECT_EQ(std::stoi(field.substr(0, colon)), k + 1);
        EXPECT_EQ(std::strtod(field.c_str() + colon + 1, nullptr),
                  set.point(count)[static_cast<std::size_t>(k)]);
      }
      EXPECT_TRUE((fields >> std::ws).eof());
    }
    EXPECT_EQ(count, 50);
  }
}

TEST(Export, NamesOfColumnsAreValidInRAndDiffer) {
  const std::vector<std::string> texts{"duck", "a-b",    "a b",    "a_b", "a.b",
                                       "über", "\"x\",", "duck_2", "duck"};
  const std::vector<std::string> names = column_names("cost_ns_", texts);
  EXPECT_THAT(names, testing::ElementsAre("cost_ns_duck", "cost_ns_a_b", "cost_ns_a_b_2",
                                          "cost_ns_a_b_3", "cost_ns_a.b", "cost_ns___ber",
                                          "cost_ns__x__", "cost_ns_duck_2", "cost_ns_duck_3"));
  for (const std::string& name : names)  // what R's make.names() leaves as it is
    EXPECT_THAT(name, testing::Each(testing::Truly([](char c) {
                  return (std::isalnum(static_cast<unsigned char>(c)) != 0) || c == '.' || c == '_';
                })));
}

TEST(Export, CsvHoldsTheCostOfEachTriedClipUnderItsName) {
  Store store = made_up_store(20);
  derive_features(features::feature_set_named("geometry")->layout, store);
  const Labels labels = label(store.observations, default_cost(store.header));
  std::istringstream lines(csv_text(store, labels));
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = cells_of(line);
  const std::size_t first = names.size() - store.header.clips.size();
  for (std::size_t clip = 0; clip < store.header.clips.size(); ++clip)
    EXPECT_EQ(names[first + clip], "cost_ns_" + store.header.clips[clip].name);
  EXPECT_EQ(names[2], "contact_x");
  for (std::size_t i = 0; std::getline(lines, line); ++i) {
    const std::vector<std::string> cells = cells_of(line);
    ASSERT_EQ(cells.size(), names.size());
    EXPECT_EQ(std::strtof(cells[2].c_str(), nullptr), store.observations[i].features[0]);
    std::size_t filled = 0;
    for (std::size_t t = 0; t < store.observations[i].trials.size(); ++t) {
      const auto clip = static_cast<std::size_t>(store.observations[i].trials[t].clip);
      EXPECT_EQ(std::strtod(cells[first + clip].c_str(), nullptr), labels.cost[i][t]);
    }
    for (std::size_t k = first; k < cells.size(); ++k) filled += cells[k].empty() ? 0U : 1U;
    EXPECT_EQ(filled, store.observations[i].trials.size());
  }
}

TEST(Csv, CellsWithCommasAndQuotesAreQuoted) {
  EXPECT_EQ(csv_cell("duck"), "duck");
  EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_cell("say \"hi\""), "\"say \"\"hi\"\"\"");
}

}  // namespace
}  // namespace flinch::train

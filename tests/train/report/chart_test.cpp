// SPDX-License-Identifier: MIT
#include "train/report/chart.h"

#include <gtest/gtest.h>

namespace flinch::train {
namespace {

LineChart logarithmic_chart(std::vector<double> first, std::vector<double> second) {
  LineChart chart;
  chart.logarithmic_x = true;
  chart.series = {{"a", std::move(first), {0.1, 0.2}}, {"b", std::move(second), {0.3, 0.4}}};
  return chart;
}

bool has_tick(const std::string& svg, const std::string& text) {
  return svg.find("'>" + text + "</text>") != std::string::npos;
}

TEST(LineChart, ALogarithmicAxisShowsTheValuesThatAllSeriesShare) {
  const std::string svg = svg_of(logarithmic_chart({30, 700}, {30, 700}));
  EXPECT_TRUE(has_tick(svg, "30"));
  EXPECT_TRUE(has_tick(svg, "700"));
  EXPECT_FALSE(has_tick(svg, "100"));
}

TEST(LineChart, ALogarithmicAxisOfSeriesThatShareNoneShowsPowersOfTen) {
  const std::string svg = svg_of(logarithmic_chart({6.5, 30}, {40, 2500}));
  for (const char* power : {"10", "100", "1000"}) EXPECT_TRUE(has_tick(svg, power)) << power;
  EXPECT_FALSE(has_tick(svg, "6.5"));
}

}  // namespace
}  // namespace flinch::train

// SPDX-License-Identifier: MIT
#include "train/report/chart.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

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

TEST(LineChart, ALogarithmicAxisOfSeriesThatShareNoneShowsRoundNumbers) {
  const std::string svg = svg_of(logarithmic_chart({6.5, 30}, {40, 2500}));
  for (const char* number : {"10", "20", "50", "100", "200", "500", "1000", "2000"})
    EXPECT_TRUE(has_tick(svg, number)) << number;
  for (const char* number : {"5", "6.5", "5000"}) EXPECT_FALSE(has_tick(svg, number)) << number;
}

/// A rectangle of the drawing, pixels.
struct Rectangle {
  double left, top, right, bottom;
  bool overlaps(const Rectangle& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

/// An element of the drawing: its tag's attributes, and the text that it holds.
struct Element {
  std::string tag, text;

  double number(const std::string& attribute) const {
    const std::string key = " " + attribute + "='";
    return std::stod(tag.substr(tag.find(key) + key.size()));
  }
};

/// The drawing's elements whose tag starts so.
std::vector<Element> elements(const std::string& svg, const std::string& start) {
  std::vector<Element> found;
  for (std::size_t at = svg.find(start); at != std::string::npos; at = svg.find(start, at + 1)) {
    const std::size_t tag_end = svg.find('>', at);
    const std::size_t text_end = svg.find('<', tag_end);
    found.push_back(
        {svg.substr(at, tag_end - at), svg.substr(tag_end + 1, text_end - tag_end - 1)});
  }
  return found;
}

/// What the names of a chart's lines cover, with letters of 6 by 11 pixels.
std::vector<Rectangle> names_in(const std::string& svg) {
  std::vector<Rectangle> found;
  for (const Element& name : elements(svg, "<text class='name")) {
    const double width = 6.0 * static_cast<double>(name.text.size());
    const double left =
        name.number("x") - (name.tag.find("name end") != std::string::npos ? width : 0);
    found.push_back({left, name.number("y") - 10, left + width, name.number("y") + 1});
  }
  return found;
}

std::vector<Rectangle> points_in(const std::string& svg) {
  std::vector<Rectangle> found;
  for (const Element& point : elements(svg, "<circle")) {
    const double x = point.number("cx");
    const double y = point.number("cy");
    found.push_back({x - 3, y - 3, x + 3, y + 3});
  }
  return found;
}

TEST(LineChart, NamesOfLinesThatEndApartCoverNoPointAndNoOtherName) {
  LineChart chart;
  chart.logarithmic_x = true;
  chart.series = {{"random", {400, 900}, {0.2, 0.6}},
                  {"nearest_annotation", {800}, {0.61}},
                  {"knn", {20, 820}, {0.7, 0.97}},
                  {"svm", {60, 900}, {0.8, 0.975}},
                  {"svm_rbf", {62}, {0.8}},
                  {"network", {12, 300, 600, 1000, 2400}, {0.78, 0.87, 0.92, 0.97, 0.99}},
                  {"pairwise_cost", {35, 950}, {0.8, 0.972}}};
  const std::string svg = svg_of(chart);
  const std::vector<Rectangle> names = names_in(svg);
  ASSERT_EQ(names.size(), chart.series.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_GT(names[i].left, 0);
    EXPECT_LT(names[i].right, 640);
    for (const Rectangle& point : points_in(svg)) EXPECT_FALSE(names[i].overlaps(point)) << i;
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(names[i].overlaps(names[j])) << i << ' ' << j;
  }
}

}  // namespace
}  // namespace flinch::train

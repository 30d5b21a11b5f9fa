// SPDX-License-Identifier: MIT
#include "train/report/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
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
    const auto is = [&name](const char* style) {
      return name.tag.find(style) != std::string::npos;
    };
    const double left = name.number("x") - (is("name end")      ? width
                                            : is("name middle") ? width / 2
                                                                : 0);
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

/// Squares of a line's width along all lines, a pixel apart.
std::vector<Rectangle> lines_in(const std::string& svg) {
  std::vector<Rectangle> found;
  for (const Element& line : elements(svg, "<polyline")) {
    const std::string key = " points='";
    std::istringstream points(line.tag.substr(line.tag.find(key) + key.size()));
    double from_x = 0, from_y = 0, x = 0, y = 0;
    char comma = 0;
    for (bool is_first = true; points >> x >> comma >> y; is_first = false) {
      const double length = is_first ? 0 : std::hypot(x - from_x, y - from_y);
      for (double at = 0; at < length; ++at) {
        const double on_x = from_x + at / length * (x - from_x);
        const double on_y = from_y + at / length * (y - from_y);
        found.push_back({on_x - 1, on_y - 1, on_x + 1, on_y + 1});
      }
      from_x = x;
      from_y = y;
    }
  }
  return found;
}

TEST(LineChart, NamesOfLinesThatEndApartCoverNoLineAndNoOtherName) {
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
  const std::vector<Rectangle> lines = lines_in(svg);
  ASSERT_EQ(names.size(), chart.series.size());
  ASSERT_GT(lines.size(), 300U);
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_GT(names[i].left, 0);
    EXPECT_LT(names[i].right, 640);
    for (const Rectangle& point : points_in(svg)) EXPECT_FALSE(names[i].overlaps(point)) << i;
    EXPECT_TRUE(std::ranges::none_of(lines, [&](const Rectangle& line) {
      return names[i].overlaps(line);
    })) << i;
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(names[i].overlaps(names[j])) << i << ' ' << j;
  }
}

/// Heights of the chart's points, pixels from its top.
std::vector<double> heights_of(const std::vector<double>& y) {
  LineChart chart;
  chart.towards_one_y = true;
  chart.series = {{"a", {1, 2, 3}, y}};
  std::vector<double> found;
  for (const Element& point : elements(svg_of(chart), "<circle"))
    found.push_back(point.number("cy"));
  return found;
}

TEST(LineChart, TowardsOneEqualSharesOfWhatIsLeftAreEqualSteps) {
  const std::vector<double> halved = heights_of({-1, 0, 0.5});
  EXPECT_NEAR(halved[0] - halved[1], halved[1] - halved[2], 0.2);
  EXPECT_GT(halved[0], halved[1] + 50);
  const std::vector<double> tenths = heights_of({0.9, 0.99, 0.999});
  EXPECT_NEAR(tenths[0] - tenths[1], tenths[1] - tenths[2], 0.2);
}

TEST(LineChart, WhereSomethingReachesOneTheScaleIsLinear) {
  const std::vector<double> even = heights_of({0, 0.5, 1});
  EXPECT_NEAR(even[0] - even[1], even[1] - even[2], 0.2);
}

/// The luminance of a colour "#rgb" or "#rrggbb", 0 to 1 (WCAG 2.1, relative luminance).
double luminance(std::string hex) {
  if (hex.size() == 4) hex = {'#', hex[1], hex[1], hex[2], hex[2], hex[3], hex[3]};
  const auto linear = [&hex](std::size_t at) {
    const double value = std::stoi(hex.substr(at, 2), nullptr, 16) / 255.0;
    return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(1) + 0.7152 * linear(3) + 0.0722 * linear(5);
}

/// The values that the style gives a variable: on light screens, then on dark ones.
std::vector<std::string> values_of(const std::string& style, const std::string& variable) {
  std::vector<std::string> found;
  const std::string key = "--" + variable + ":#";
  for (std::size_t at = style.find(key); at != std::string::npos; at = style.find(key, at + 1)) {
    const std::size_t begin = at + key.size() - 1;
    found.push_back(style.substr(begin, style.find_first_of(";}", begin) - begin));
  }
  return found;
}

TEST(ChartStyle, ColoursStandOutAsTextHasToOnLightAndDarkScreens) {
  const std::string style = chart_style();
  const std::vector<std::string> cards = values_of(style, "card");
  ASSERT_EQ(cards.size(), 2U);
  for (int number = 0; number < 8; ++number) {
    const std::vector<std::string> colours = values_of(style, "c" + std::to_string(number));
    ASSERT_EQ(colours.size(), 2U) << number;
    for (std::size_t screen = 0; screen < 2; ++screen) {
      const double colour = luminance(colours[screen]) + 0.05;
      const double card = luminance(cards[screen]) + 0.05;
      EXPECT_GE(std::max(colour, card) / std::min(colour, card), 4.5)  // WCAG 2.1, 1.4.3
          << number << ' ' << colours[screen];
    }
  }
}

}  // namespace
}  // namespace flinch::train

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "train/evaluate/bootstrap.h"

namespace flinch::train {

/// Named points, joined in their order.
struct Series {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
};

/// Lines over a common x axis. Points that are not a number are left out.
struct LineChart {
  std::string title;
  std::string x_title;
  std::string y_title;
  bool logarithmic_x = false;  ///< requires all x to be positive
  bool diagonal = false;       ///< with the line y = x
  std::vector<Series> series;
  /// With the distance of y from 1 on a logarithmic scale; linear unless all y are below 1.
  bool towards_one_y = false;
};

/// One value with its interval per name: dots with whiskers, one below the other.
struct DotChart {
  std::string title;
  std::string x_title;
  std::vector<std::string> names;
  std::vector<Estimate> estimates;
};

/// Returns a chart as one <figure> with inline SVG that uses the classes of chart_style(). The same
/// text for the same chart in every locale.
std::string svg_of(const LineChart& chart);
std::string svg_of(const DotChart& chart);

/// Returns the CSS of the figures, for light and dark screens.
std::string chart_style();

/// Returns the text with HTML's special characters escaped.
std::string html_escaped(const std::string& text);

}  // namespace flinch::train

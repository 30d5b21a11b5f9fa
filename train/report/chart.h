// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "train/evaluate/bootstrap.h"

namespace flinch::train {

/// Points of one name, joined in their order.
struct Series {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
};

/// Lines over one axis. Not-a-number points are left out.
struct LineChart {
  std::string title;
  std::string x_title;
  std::string y_title;
  bool logarithmic_x = false;  ///< all x positive
  bool diagonal = false;       ///< with the line y = x
  std::vector<Series> series;
};

/// A value with its interval a name: dots with whiskers, one below the other.
struct DotChart {
  std::string title;
  std::string x_title;
  std::vector<std::string> names;
  std::vector<Estimate> estimates;
};

/// Each as one <figure> with inline SVG that uses the classes of chart_style(). The same text for
/// the same chart, whatever the locale.
std::string svg_of(const LineChart& chart);
std::string svg_of(const DotChart& chart);

/// CSS for the figures, for light and dark screens.
std::string chart_style();

/// Text with what HTML would take for markup escaped.
std::string html_escaped(const std::string& text);

}  // namespace flinch::train

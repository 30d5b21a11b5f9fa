// SPDX-License-Identifier: MIT
#include "train/report/chart.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace flinch::train {
namespace {

// Size of the drawing and its margins, pixels.
constexpr double kChartWidth = 640;
constexpr double kChartHeight = 300;
constexpr double kLeftMargin = 60;
constexpr double kRightMargin = 130;
constexpr double kTopMargin = 12;
constexpr double kBottomMargin = 44;
constexpr double kRowHeight = 24;
constexpr double kNameWidth = 150;
constexpr double kTickCount = 5;
constexpr double kLabelHeight = 13;

std::string text_of(double value, int digits) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::general, digits)
                       .ptr;
  return {text.data(), end};
}

std::string px(double value) {
  return text_of(std::round(10 * value) / 10, 6);
}

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  void include(double value) {
    if (!std::isfinite(value)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

/// Maps values to pixels.
struct Scale {
  Range range;
  double from = 0;
  double to = 0;
  enum class Law { linear, logarithmic, towards_one } law = Law::linear;

  double position(double value) const {
    switch (law) {
      case Law::linear:
        return value;
      case Law::logarithmic:
        return std::log10(value);
      case Law::towards_one:
        return -std::log10(1 - value);
    }
    return value;
  }
  double operator()(double value) const {
    const double span = position(range.most) - position(range.least);
    return from + (to - from) * (position(value) - position(range.least)) / span;
  }
};

/// Returns round numbers from about the minimum to about the maximum, spaced by 1, 2 or 5 times a
/// power of ten.
std::vector<double> round_ticks(const Range& range) {
  const double rough = (range.most - range.least) / kTickCount;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  const double step = rough / power < 1.5 ? power : rough / power < 3.5 ? 2 * power : 5 * power;
  std::vector<double> ticks;
  const double first = std::floor(range.least / step + 1e-9);
  for (double k = first; k * step < range.most + step * (1 - 1e-9); ++k) ticks.push_back(k * step);
  return ticks;
}

/// Returns the numbers 1, 2 and 5 times a power of ten in a range of positive numbers.
std::vector<double> logarithmic_ticks(const Range& range) {
  std::vector<double> ticks;
  for (double power = std::floor(std::log10(range.least)); power <= std::log10(range.most);
       ++power) {
    for (const double digit : {1, 2, 5}) {
      const double tick = digit * std::pow(10, power);
      if (tick >= range.least && tick <= range.most) ticks.push_back(tick);
    }
  }
  return ticks;
}

/// Returns numbers at even distances where the distance from 1 is on a logarithmic scale: those in
/// a range, with the next below.
std::vector<double> ticks_towards_one(const Range& range) {
  std::vector<double> ticks;
  for (const double tick :
       {-9.0, -4.0, -1.0, 0.0, 0.5, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 0.998, 0.999}) {
    if (tick <= range.least) ticks.clear();
    if (tick <= range.most) ticks.push_back(tick);
  }
  return ticks;
}

Range widened(Range range) {
  if (!(range.least < range.most)) return {range.least - 0.5, range.least + 0.5};
  return range;
}

std::string line(double x1, double y1, double x2, double y2, const char* style) {
  return "<line class='" + std::string(style) + "' x1='" + px(x1) + "' y1='" + px(y1) + "' x2='" +
         px(x2) + "' y2='" + px(y2) + "'/>";
}

std::string label(double x, double y, const std::string& text, const std::string& style) {
  return "<text class='" + style + "' x='" + px(x) + "' y='" + px(y) + "'>" + html_escaped(text) +
         "</text>";
}

std::string figure(const std::string& title, double height, const std::string& drawing) {
  return "<figure><figcaption>" + html_escaped(title) +
         "</figcaption><svg role='img' aria-label='" + html_escaped(title) + "' viewBox='0 0 " +
         px(kChartWidth) + ' ' + px(height) + "'>" + drawing + "</svg></figure>\n";
}

std::string axis_x(const Scale& scale, const std::vector<double>& ticks, double top, double bottom,
                   const std::string& title) {
  std::string drawing;
  for (const double tick : ticks) {
    drawing += line(scale(tick), top, scale(tick), bottom, "grid") +
               label(scale(tick), bottom + 16, text_of(tick, 6), "tick middle");
  }
  return drawing + label((scale.from + scale.to) / 2, bottom + 36, title, "axis middle");
}

std::string axis_y(const Scale& scale, const std::vector<double>& ticks, double left, double right,
                   const std::string& title) {
  std::string drawing;
  for (const double tick : ticks) {
    drawing += line(left, scale(tick), right, scale(tick), "grid") +
               label(left - 8, scale(tick) + 4, text_of(tick, 6), "tick end");
  }
  return drawing + "<text class='axis middle' transform='translate(14 " +
         px((scale.from + scale.to) / 2) + ") rotate(-90)'>" + html_escaped(title) + "</text>";
}

Scale fitted_scale(const Range& found, double from, double to, std::vector<double>& ticks) {
  const Range range = widened(found);
  ticks = round_ticks(range);
  return {{ticks.front(), ticks.back()}, from, to};
}

std::string drawn(const Series& series, const Scale& x, const Scale& y, std::size_t number) {
  const std::string colour = " c" + std::to_string(number % 8);
  std::string points;
  std::string dots;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) continue;
    const std::string at_x = px(x(series.x[i]));
    const std::string at_y = px(y(series.y[i]));
    points += (points.empty() ? "" : " ") + at_x + ',' + at_y;
    dots += "<circle class='dot" + colour + "' r='3' cx='" + at_x + "' cy='" + at_y + "'/>";
  }
  return "<polyline class='line" + colour + "' points='" + points + "'/>" + dots;
}

/// The names at the lines' ends, shifted where they would overlap.
std::string end_labels(const std::vector<Series>& series, const Scale& y) {
  std::vector<std::pair<double, std::size_t>> places;
  for (std::size_t i = 0; i < series.size(); ++i)
    if (!series[i].y.empty() && std::isfinite(series[i].y.back()))
      places.emplace_back(y(series[i].y.back()), i);
  std::ranges::sort(places);
  std::string drawing;
  double least = kTopMargin;
  for (auto& [place, number] : places) {
    place = std::max(place, least);
    least = place + kLabelHeight;
  }
  double most = kChartHeight - kBottomMargin;
  for (auto at = places.rbegin(); at != places.rend(); ++at) {
    at->first = std::min(at->first, most);
    most = at->first - kLabelHeight;
  }
  for (const auto& [place, number] : places)
    drawing += label(kChartWidth - kRightMargin + 8, place + 4, series[number].name,
                     "name c" + std::to_string(number % 8));
  return drawing;
}

/// A rectangle of the drawing, pixels.
struct Box {
  double left, top, right, bottom;

  double overlap(const Box& other) const {
    const double width = std::min(right, other.right) - std::max(left, other.left);
    const double height = std::min(bottom, other.bottom) - std::max(top, other.top);
    return std::max(width, 0.0) * std::max(height, 0.0);
  }
};

/// A name beside a point.
struct NamePlace {
  double x, y;  ///< as of label()
  const char* anchor;
  Box box;
};

/// Where a name of so many letters may stand beside a point, the best place first.
std::vector<NamePlace> places_beside(double x, double y, std::size_t letters) {
  constexpr double kLetterWidth = 7;
  constexpr double kGap = 8;
  const double width = kLetterWidth * static_cast<double>(letters);
  std::vector<NamePlace> places;
  for (const double down : {0.0, -1.0, 1.0, -2.0, 2.0, -3.0, 3.0}) {
    const double middle = y + down * kLabelHeight;
    const double top = middle - kLabelHeight / 2;
    const Box right{x + kGap, top, x + kGap + width, top + kLabelHeight};
    places.push_back({right.left, middle + 4, "", right});
    const Box left{x - kGap - width, top, x - kGap, top + kLabelHeight};
    places.push_back({left.right, middle + 4, " end", left});
    if (down == 0) continue;
    const Box centred{x - width / 2, top, x + width / 2, top + kLabelHeight};
    places.push_back({x, middle + 4, " middle", centred});
  }
  return places;
}

/// Boxes over a line's points and, in small steps, over the line between them.
void cover(const Series& line, const Scale& x, const Scale& y, std::vector<Box>& boxes) {
  constexpr double kDot = 4;
  constexpr double kPen = 2;
  const auto add = [&boxes](double at_x, double at_y, double half) {
    boxes.push_back({at_x - half, at_y - half, at_x + half, at_y + half});
  };
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    if (!std::isfinite(line.x[i]) || !std::isfinite(line.y[i])) continue;
    const double to_x = x(line.x[i]);
    const double to_y = y(line.y[i]);
    add(to_x, to_y, kDot);
    if (last) {
      const double from_x = x(line.x[*last]);
      const double from_y = y(line.y[*last]);
      const double steps = std::ceil(std::hypot(to_x - from_x, to_y - from_y) / (2 * kPen));
      for (double step = 1; step < steps; ++step) {
        const double share = step / steps;
        add(from_x + share * (to_x - from_x), from_y + share * (to_y - from_y), kPen);
      }
    }
    last = i;
  }
}

/// The names beside the lines' last points, where they cover no line and no other name, or as
/// little as possible.
std::string names_beside_ends(const std::vector<Series>& series, const Scale& x, const Scale& y) {
  std::vector<Box> taken{{0, 0, kLeftMargin, kChartHeight},
                         {0, kChartHeight - kBottomMargin, kChartWidth, kChartHeight},
                         {0, -kChartHeight, kChartWidth, 0},
                         {kChartWidth, 0, 2 * kChartWidth, kChartHeight}};
  for (const Series& line : series) cover(line, x, y, taken);
  std::string drawing;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& line = series[i];
    if (line.y.empty() || !std::isfinite(line.y.back())) continue;
    const auto covered = [&taken](const NamePlace& place) {
      double area = 0;
      for (const Box& box : taken) area += place.box.overlap(box);
      return area;
    };
    const auto places = places_beside(x(line.x.back()), y(line.y.back()), line.name.size());
    const NamePlace best = std::ranges::min(places, {}, covered);
    taken.push_back(best.box);
    drawing += label(best.x, best.y, line.name,
                     "name" + std::string(best.anchor) + " c" + std::to_string(i % 8));
  }
  return drawing;
}

bool end_together(const std::vector<Series>& series) {
  return std::ranges::all_of(series, [&series](const Series& line) {
    return !line.x.empty() && line.x.back() == series.front().x.back();
  });
}

}  // namespace

std::string html_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string svg_of(const LineChart& chart) {
  Range found_x;
  Range found_y;
  for (const Series& series : chart.series) {
    for (const double x : series.x) found_x.include(x);
    for (const double y : series.y) found_y.include(y);
  }
  if (chart.diagonal) {
    found_y.include(found_x.least);
    found_y.include(found_x.most);
  }
  std::vector<double> ticks_x;
  std::vector<double> ticks_y;
  Scale y = fitted_scale(found_y, kChartHeight - kBottomMargin, kTopMargin, ticks_y);
  if (chart.towards_one_y && found_y.least < found_y.most && found_y.most < 1) {
    ticks_y = ticks_towards_one(found_y);
    y.range = {std::min(ticks_y.front(), found_y.least), found_y.most};
    y.law = Scale::Law::towards_one;
  }
  Scale x = fitted_scale(found_x, kLeftMargin, kChartWidth - kRightMargin, ticks_x);
  if (chart.logarithmic_x && found_x.least < found_x.most) {
    x.range = found_x;
    x.law = Scale::Law::logarithmic;
    const auto& first = chart.series.front().x;
    const bool is_shared = std::ranges::all_of(
        chart.series, [&first](const Series& series) { return series.x == first; });
    ticks_x = is_shared ? first : logarithmic_ticks(found_x);
  }
  std::string drawing = axis_y(y, ticks_y, kLeftMargin, kChartWidth - kRightMargin, chart.y_title) +
                        axis_x(x, ticks_x, kTopMargin, kChartHeight - kBottomMargin, chart.x_title);
  if (chart.diagonal) {
    drawing +=
        line(x(found_x.least), y(found_x.least), x(found_x.most), y(found_x.most), "diagonal");
  }
  for (std::size_t i = 0; i < chart.series.size(); ++i) drawing += drawn(chart.series[i], x, y, i);
  return figure(chart.title, kChartHeight,
                drawing + (end_together(chart.series) ? end_labels(chart.series, y)
                                                      : names_beside_ends(chart.series, x, y)));
}

std::string svg_of(const DotChart& chart) {
  Range found;
  found.include(0);
  for (const Estimate& estimate : chart.estimates) {
    found.include(estimate.interval.low);
    found.include(estimate.interval.high);
    found.include(estimate.value);
  }
  std::vector<double> ticks;
  const Scale x = fitted_scale(found, kNameWidth, kChartWidth - 60, ticks);
  const double bottom = kTopMargin + kRowHeight * static_cast<double>(chart.names.size());
  std::string drawing = axis_x(x, ticks, kTopMargin, bottom, chart.x_title);
  for (std::size_t i = 0; i < chart.names.size(); ++i) {
    const Estimate& estimate = chart.estimates[i];
    const double middle = kTopMargin + kRowHeight * (static_cast<double>(i) + 0.5);
    drawing += label(kNameWidth - 10, middle + 4, chart.names[i], "name end");
    if (!std::isfinite(estimate.value)) continue;
    drawing +=
        line(x(estimate.interval.low), middle, x(estimate.interval.high), middle, "whisker") +
        "<circle class='dot c0' r='4.5' cx='" + px(x(estimate.value)) + "' cy='" + px(middle) +
        "'/>" +
        label(x(estimate.interval.high) + 8, middle + 4, text_of(estimate.value, 3), "tick");
  }
  return figure(chart.title, bottom + kBottomMargin, drawing);
}

// Eight colours for each kind of screen, as strong as text has to be there and as far apart as
// eight can be for any colour vision; since that is not far, names stand beside what they name.
std::string chart_style() {
  return ":root{--ink:#1c2530;--quiet:#66727f;--grid:#e6eaee;--card:#fff;"
         "--c0:#0072b2;--c1:#c34a00;--c2:#007a56;--c3:#b8408a;--c4:#8a6100;--c5:#6b52c8;"
         "--c6:#7b4a36;--c7:#5f6b76}"
         "@media(prefers-color-scheme:dark){:root{--ink:#e6ebf0;--quiet:#93a0ad;--grid:#2b343e;"
         "--card:#1a2128;"
         "--c0:#56a8f5;--c1:#ff8b4d;--c2:#3fcf9f;--c3:#f29ccb;--c4:#f0c24a;--c5:#b3a1ff;"
         "--c6:#d0a58a;--c7:#aeb8c2}}"
         "figure{margin:0}figcaption{font-weight:600;margin:0 0 .5rem}"
         "svg{width:100%;height:auto;font:12px system-ui,sans-serif}"
         ".grid{stroke:var(--grid);stroke-width:1}.diagonal{stroke:var(--quiet);stroke-dasharray:4 "
         "4}"
         ".tick{fill:var(--quiet);font-size:11px}.axis{fill:var(--quiet)}.name{fill:var(--ink)}"
         ".middle{text-anchor:middle}.end{text-anchor:end}"
         ".line{fill:none;stroke-width:2;stroke-linejoin:round}"
         ".whisker{stroke:var(--quiet);stroke-width:2;stroke-linecap:round}"
         ".c0{--c:var(--c0)}.c1{--c:var(--c1)}.c2{--c:var(--c2)}.c3{--c:var(--c3)}"
         ".c4{--c:var(--c4)}.c5{--c:var(--c5)}.c6{--c:var(--c6)}.c7{--c:var(--c7)}"
         ".line[class*=c]{stroke:var(--c)}.dot[class*=c]{fill:var(--c)}"
         ".name[class*=' c']{fill:var(--c);paint-order:stroke;stroke:var(--card);stroke-width:3px}";
}

}  // namespace flinch::train

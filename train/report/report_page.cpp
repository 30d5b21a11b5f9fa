// SPDX-License-Identifier: MIT
#include "train/report/report_page.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "train/report/chart.h"

namespace flinch::train {
namespace {

constexpr const char* kStyle =
    ":root{color-scheme:light dark;--paper:#fbfcfd;--heat:0 114 178}"
    "@media(prefers-color-scheme:dark){:root{--paper:#12171c;--heat:86 180 233}}"
    "body{font:15px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--paper);"
    "max-width:1160px;margin:0 auto;padding:2.5rem 1.5rem}"
    "h1{font-size:1.7rem;margin:0}h2{font-size:1.15rem;margin:2.2rem 0 .8rem}"
    "p{color:var(--quiet);max-width:46rem;margin:.3rem 0 1rem}"
    ".cards{display:grid;grid-template-columns:repeat(auto-fit,minmax(460px,1fr));gap:1.2rem}"
    "figure,.card{background:var(--card);border:1px solid var(--grid);border-radius:10px;"
    "padding:1rem 1.1rem;overflow-x:auto}"
    "table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums;font-size:13.5px}"
    "th{font-weight:600;text-align:right;color:var(--quiet);border-bottom:1px solid var(--grid)}"
    "td{text-align:right}th,td{padding:.28rem .6rem;white-space:nowrap}"
    "th:first-child,td:first-child,.left{text-align:left}tbody tr:hover{background:var(--grid)}";

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "–";
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, decimals)
                       .ptr;
  return {text.data(), end};
}

std::string interval(const Interval& interval, int decimals) {
  return fixed(interval.low, decimals) + " to " + fixed(interval.high, decimals);
}

std::string row_of(const std::string& cell, const std::vector<std::string>& cells) {
  std::string text{"<tr>"};
  for (const std::string& content : cells)
    text.append("<").append(cell).append(">").append(content).append("</").append(cell).append(">");
  return text.append("</tr>\n");
}

std::string table(const std::vector<std::string>& titles,
                  const std::vector<std::vector<std::string>>& rows) {
  std::string text = "<div class='card'><table><thead>" + row_of("th", titles) + "</thead><tbody>";
  for (const auto& row : rows) text += row_of("td", row);
  return text + "</tbody></table></div>\n";
}

std::string rows_table(const Report& report) {
  std::vector<std::vector<std::string>> rows;
  for (const EvaluationRow& row : report.evaluation.rows) {
    rows.push_back({html_escaped(row.name), fixed(row.accuracy.value, 3),
                    fixed(row.top_three.value, 3), fixed(row.mean_cost_ns.value, 3),
                    fixed(row.mean_damage_ns.value, 3), fixed(row.regret_ns.value, 3),
                    interval(row.regret_ns.interval, 3), fixed(row.protection.value, 3),
                    interval(row.protection.interval, 3)});
  }
  return table({"selector", "accuracy", "top 3", "cost, N s", "damage, N s", "regret, N s", "95 %",
                "protection", "95 %"},
               rows);
}

std::string timing_table(const Report& report) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < report.methods.size(); ++i) {
    const RowTiming& timing = report.evaluation.timing[i];
    rows.push_back({html_escaped(timing.name), fixed(timing.median_us, 1), fixed(timing.p99_us, 1),
                    fixed(timing.fit_s, 1), fixed(static_cast<double>(timing.file_bytes) / 1024, 0),
                    html_escaped(report.methods[i].parameters)});
  }
  return table({"selector", "median, µs", "p99, µs", "fit, s", "file, KiB", "chosen"}, rows);
}

/// A number whose background is stronger the larger the number is.
std::string heat_cell(double value, double most) {
  const double share = most > 0 && std::isfinite(value) ? std::clamp(value / most, 0.0, 1.0) : 0;
  return "<div style='background:rgb(var(--heat)/" + fixed(0.55 * share, 2) +
         ");border-radius:4px;padding:0 .35rem;margin:0 -.35rem'>" + fixed(value, 3) + "</div>";
}

/// Regret in every group of all rows except random and oracle.
std::string groups_table(const Report& report) {
  std::vector<std::string> titles{"regret, N s", "", "scenarios"};
  std::vector<std::size_t> shown;
  const std::vector<EvaluationRow>& all = report.evaluation.rows;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    if (all[i].name == "random") continue;
    titles.push_back(html_escaped(all[i].name));
    shown.push_back(i);
  }
  double most = 0;
  for (const GroupRow& group : report.groups)
    if (group.name != "random") most = std::max(most, group.regret_ns.value);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t first = 0; first < report.groups.size(); first += all.size()) {
    const GroupRow& group = report.groups[first];
    std::vector<std::string> cells{group.group, group.value, std::to_string(group.scenarios)};
    for (const std::size_t i : shown)
      cells.push_back(heat_cell(report.groups[first + i].regret_ns.value, most));
    rows.push_back(std::move(cells));
  }
  return table(titles, rows);
}

std::string ablation_table(const Report& report) {
  std::vector<std::string> titles{"features", "count"};
  for (const MethodSummary& method : report.methods) titles.push_back(html_escaped(method.name));
  double most = 0;
  for (const AblationRow& row : report.ablation) most = std::max(most, row.regret_ns);
  std::vector<std::vector<std::string>> rows;
  for (const AblationRow& row : report.ablation) {
    if (rows.empty() || rows.back()[0] != html_escaped(row.features))
      rows.push_back({html_escaped(row.features), std::to_string(row.feature_count)});
    rows.back().push_back(heat_cell(row.regret_ns, most));
  }
  return table(titles, rows);
}

std::string look_ahead_table(const Report& report) {
  std::vector<std::vector<std::string>> rows;
  for (const LookAheadRow& ahead : report.evaluation.look_ahead) {
    const EvaluationRow& row = ahead.row;
    rows.push_back({html_escaped(row.name), fixed(row.accuracy.value, 3),
                    fixed(row.mean_cost_ns.value, 3), fixed(row.regret_ns.value, 3),
                    fixed(row.protection.value, 3), interval(row.protection.interval, 3),
                    fixed(ahead.encounters, 1), fixed(ahead.median_us, 0), fixed(ahead.p99_us, 0)});
  }
  return table({"selector + candidates", "accuracy", "cost, N s", "regret, N s", "protection",
                "95 %", "simulated", "median, µs", "p99, µs"},
               rows);
}

/// What a microsecond buys: each selector alone, if it has a time, and looking ahead.
LineChart frontier(const Report& report) {
  LineChart chart{
      "What a microsecond buys", "median time to choose, µs", "protection", true, false, {}, true};
  const auto series_named = [&](const std::string& name) -> Series& {
    const auto found = std::ranges::find(chart.series, name, &Series::name);
    return found != chart.series.end() ? *found : chart.series.emplace_back(Series{name, {}, {}});
  };
  const auto add = [&](const std::string& name, double us, const Estimate& protection) {
    if (!(us > 0)) return;
    series_named(name).x.push_back(us);
    series_named(name).y.push_back(protection.value);
  };
  for (const RowTiming& timing : report.evaluation.timing)
    if (const EvaluationRow* row = row_named(report.evaluation, timing.name))
      add(timing.name, timing.median_us, row->protection);
  for (const LookAheadRow& ahead : report.evaluation.look_ahead)
    add(ahead.row.name.substr(0, ahead.row.name.find('+')), ahead.median_us, ahead.row.protection);
  return chart;
}

template <class Estimated>
DotChart dots(const Report& report, const std::string& title, const std::string& x_title,
              const Estimated& estimated) {
  DotChart chart{title, x_title, {}, {}};
  for (const EvaluationRow& row : report.evaluation.rows) {
    if (row.name == "oracle") continue;
    chart.names.push_back(row.name);
    chart.estimates.push_back(estimated(row));
  }
  return chart;
}

/// One series per name, in the order in which the names first occur.
template <class Row, class X, class Y>
std::vector<Series> series_of(const std::vector<Row>& rows, const X& x, const Y& y) {
  std::vector<Series> series;
  for (const Row& row : rows) {
    auto found = std::ranges::find(series, row.name, &Series::name);
    if (found == series.end()) found = series.insert(series.end(), Series{row.name, {}, {}});
    found->x.push_back(x(row));
    found->y.push_back(y(row));
  }
  return series;
}

std::vector<ReliabilityBin> bins_that_say(const Report& report, const std::string& what) {
  std::vector<ReliabilityBin> bins = report.reliability;
  std::erase_if(bins, [&](const ReliabilityBin& bin) { return bin.said != what; });
  return bins;
}

std::string charts(const Report& report) {
  std::string text =
      svg_of(dots(report, "Regret: mean cost above that of the exhaustive choice, with 95 %", "N s",
                  [](const EvaluationRow& row) { return row.regret_ns; })) +
      svg_of(dots(report, "Protection: 0 for standing still, 1 for the exhaustive choice", "share",
                  [](const EvaluationRow& row) { return row.protection; }));
  if (!report.evaluation.look_ahead.empty()) text += svg_of(frontier(report));
  const auto protection = [](const auto& row) { return row.protection; };
  if (!report.curves.empty()) {
    text += svg_of(LineChart{
        "Learning curves", "training scenarios", "protection", true, false,
        series_of(
            report.curves,
            [](const LearningCurveRow& row) { return static_cast<double>(row.fitted_count); },
            protection)});
  }
  if (!report.noise.empty()) {
    text += svg_of(
        LineChart{"Noise on the features", "standard deviation, share of half the range",
                  "protection", false, false,
                  series_of(
                      report.noise, [](const NoiseRow& row) { return row.noise; }, protection)});
  }
  const auto said = [](const ReliabilityBin& bin) { return bin.mean_said; };
  if (const auto bins = bins_that_say(report, "vote"); !bins.empty()) {
    text += svg_of(LineChart{
        "Regret by share of votes", "share of votes for the choice", "regret, N s", false, false,
        series_of(bins, said, [](const ReliabilityBin& bin) { return bin.mean_regret_ns; })});
  }
  if (const auto bins = bins_that_say(report, "expected_cost_ns"); !bins.empty()) {
    text += svg_of(LineChart{
        "Actual cost by expected cost", "expected cost, N s", "mean cost, N s", false, true,
        series_of(bins, said, [](const ReliabilityBin& bin) { return bin.mean_cost_ns; })});
  }
  return text;
}

std::string summary(const Report& report) {
  return "Fitted to " + std::to_string(report.fitted_count) + " scenarios, tested on " +
         std::to_string(report.tested_count) +
         (report.has_test_store ? " of another store" : " held out") + ". Brawn " +
         fixed(report.evaluation.cost_model.brawn, 2) + ", " +
         std::to_string(report.features.size()) +
         " features. Intervals are 95 % bootstrap intervals over the test scenarios.";
}

}  // namespace

std::string report_page(const Report& report) {
  const std::string title = "Selectors of " + html_escaped(report.library) + ", compared";
  std::string page = "<!doctype html>\n<html lang='en'><head><meta charset='utf-8'><title>" +
                     title + "</title><meta name='viewport' content='width=device-width'><style>" +
                     kStyle + chart_style() + "</style></head><body>\n<h1>" + title + "</h1>\n<p>" +
                     summary(report) + "</p>\n" + rows_table(report) +
                     "<h2>Charts</h2>\n<div class='cards'>\n" + charts(report) +
                     "</div>\n<h2>Regret by group</h2>\n" + groups_table(report);
  if (!report.evaluation.look_ahead.empty())
    page += "<h2>Looking ahead</h2>\n" + look_ahead_table(report);
  if (!report.ablation.empty())
    page += "<h2>Regret with other features, N s</h2>\n" + ablation_table(report);
  return page + "<h2>Time and size</h2>\n" + timing_table(report) + "</body></html>\n";
}

}  // namespace flinch::train

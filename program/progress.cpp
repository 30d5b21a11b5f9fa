// SPDX-License-Identifier: MIT
#include "program/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "program/document.h"
#include "program/log.h"
#include "program/table.h"

namespace flinch::program {

namespace {

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

std::string bar(double share) {
  constexpr std::size_t kBarWidth = 24;
  const auto filled = static_cast<std::size_t>(share * static_cast<double>(kBarWidth));
  std::string text(1, '[');
  text.append(filled, '#').append(kBarWidth - filled, '.').append("] ");
  return text;
}

double hit_rate(const train::SimulationProgress& progress) {
  const auto simulations = static_cast<double>(progress.counts.simulations);
  return simulations > 0 ? static_cast<double>(progress.counts.hits) / simulations : 0;
}

/// Rounds to three decimals; more would be noise.
double rounded(double value) {
  return std::round(1000 * value) / 1000;
}

}  // namespace

ProgressDisplay::ProgressDisplay(bool json)
    : json_(json), terminal_(!json && isatty(STDERR_FILENO) == 1) {}

ProgressDisplay::~ProgressDisplay() {
  if (bar_shown_) std::cerr << std::endl;
}

void ProgressDisplay::show(const train::SimulationProgress& progress) {
  if (!started_) {
    begin(progress);
  } else if (is_due(progress)) {
    json_ ? show_json(progress) : show_text(progress);
  }
}

void ProgressDisplay::begin(const train::SimulationProgress& progress) {
  started_ = true;
  start_ = shown_ = std::chrono::steady_clock::now();
  scenarios_at_start_ = progress.scenarios;
  tenth_shown_ = 10 * progress.scenarios / progress.wanted;
  if (!json_ && progress.scenarios > 0 && progress.scenarios < progress.wanted)
    log(LogLevel::info, "continuing after " + std::to_string(progress.scenarios) + " scenarios");
}

/// A bar is always due. Lines are due at every tenth of the work, and after ten seconds without
/// one.
bool ProgressDisplay::is_due(const train::SimulationProgress& progress) {
  const auto now = std::chrono::steady_clock::now();
  const std::uint64_t tenth = 10 * progress.scenarios / progress.wanted;
  if (!terminal_ && tenth <= tenth_shown_ && now - shown_ < std::chrono::seconds(10)) return false;
  tenth_shown_ = tenth;
  shown_ = now;
  return true;
}

ProgressDisplay::Rates ProgressDisplay::rates(const train::SimulationProgress& progress) const {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  const double seconds = std::max(elapsed.count(), 1e-3);
  Rates rates;
  rates.scenarios_per_s = static_cast<double>(progress.scenarios - scenarios_at_start_) / seconds;
  rates.simulations_per_s = static_cast<double>(progress.counts.simulations) / seconds;
  if (rates.scenarios_per_s > 0)
    rates.left_s =
        static_cast<double>(progress.wanted - progress.scenarios) / rates.scenarios_per_s;
  return rates;
}

void ProgressDisplay::show_json(const train::SimulationProgress& progress) const {
  const Rates now = rates(progress);
  print_line({{"kind", "progress"},
              {"scenarios", progress.scenarios},
              {"of", progress.wanted},
              {"simulations", progress.counts.simulations},
              {"hit_rate", rounded(hit_rate(progress))},
              {"scenarios_per_s", rounded(now.scenarios_per_s)},
              {"simulations_per_s", rounded(now.simulations_per_s)},
              {"left_s", rounded(now.left_s)}});
}

void ProgressDisplay::show_text(const train::SimulationProgress& progress) {
  if (!is_logged(LogLevel::info)) return;
  const Rates now = rates(progress);
  const std::string text =
      std::to_string(progress.scenarios) + "/" + std::to_string(progress.wanted) + " scenarios, " +
      fixed(now.scenarios_per_s, 1) + " per second (" + fixed(now.simulations_per_s, 0) +
      " simulations), " + fixed(100 * hit_rate(progress), 0) + " % hit, " +
      duration_text(now.left_s) + " left";
  if (!terminal_) {
    log(LogLevel::info, text);
    return;
  }
  const double share =
      static_cast<double>(progress.scenarios) / static_cast<double>(progress.wanted);
  std::cerr << '\r' << bar(share) << text << "\033[K" << std::flush;
  bar_shown_ = true;
}

}  // namespace flinch::program

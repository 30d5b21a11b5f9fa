// SPDX-License-Identifier: MIT
#include "train/program/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "train/program/table.h"

namespace flinch::train::program {

namespace {

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

std::string bar(double share) {
  constexpr std::size_t kWidth = 24;
  const auto filled = static_cast<std::size_t>(share * static_cast<double>(kWidth));
  std::string text(1, '[');
  text.append(filled, '#').append(kWidth - filled, '.').append("] ");
  return text;
}

}  // namespace

ProgressDisplay::ProgressDisplay(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressDisplay::~ProgressDisplay() {
  if (bar_shown_) std::cerr << std::endl;
}

void ProgressDisplay::show(const SimulationProgress& progress) {
  if (quiet_) return;
  if (!started_) {
    started_ = true;
    start_ = std::chrono::steady_clock::now();
    scenarios_at_start_ = progress.scenarios;
    tenth_shown_ = progress.of == 0 ? 0 : 10 * progress.scenarios / progress.of;
    if (progress.scenarios > 0 && progress.scenarios < progress.of)
      std::cerr << "going on after " << progress.scenarios << " scenarios" << std::endl;
    return;
  }
  const std::uint64_t tenth = 10 * progress.scenarios / progress.of;
  if (!terminal_ && tenth <= tenth_shown_) return;
  tenth_shown_ = tenth;
  show_line(progress);
}

void ProgressDisplay::show_line(const SimulationProgress& progress) {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  const double seconds = std::max(elapsed.count(), 1e-3);
  const double rate = static_cast<double>(progress.scenarios - scenarios_at_start_) / seconds;
  const double left = rate > 0 ? static_cast<double>(progress.of - progress.scenarios) / rate : 0;
  const std::string text = std::to_string(progress.scenarios) + "/" + std::to_string(progress.of) +
                           " scenarios, " + fixed(rate, 1) + " a second (" +
                           fixed(static_cast<double>(progress.simulations) / seconds, 0) +
                           " simulations), " + duration_text(left) + " left";
  if (!terminal_) {
    std::cerr << text << std::endl;
    return;
  }
  const double share = static_cast<double>(progress.scenarios) / static_cast<double>(progress.of);
  std::cerr << '\r' << bar(share) << text << "\033[K" << std::flush;
  bar_shown_ = true;
}

}  // namespace flinch::train::program

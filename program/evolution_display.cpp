// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <iostream>

#include "program/evolve.h"
#include "program/log.h"
#include "program/table.h"

namespace flinch::program {

EvolutionDisplay::EvolutionDisplay(bool json)
    : shows_(!json), terminal_(!json && isatty(STDERR_FILENO) == 1) {}

EvolutionDisplay::~EvolutionDisplay() {
  if (terminal_ && shown_) std::cerr << std::endl;
}

void EvolutionDisplay::show(const std::string& what, const evolve::Evolution& evolution) {
  if (!shows_ || !is_logged(LogLevel::info)) return;
  const evolve::GenerationRecord& last = evolution.history.back();
  std::cerr << (terminal_ ? "\r" : "") << what << "generation " << evolution.history.size()
            << ": best " << fixed(last.best_fitness, 2) << ", mean " << fixed(last.mean_fitness, 2)
            << " N s" << (terminal_ ? "  " : "\n") << std::flush;
  shown_ = true;
}

}  // namespace flinch::program

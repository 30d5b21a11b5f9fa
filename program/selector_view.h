// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "program/document.h"
#include "runtime/selector_file.h"
#include "train/fit/selector_record.h"

namespace flinch::program {

/// A selector as it is read at run time, and how it was trained.
struct SelectorView {
  /// Reads the file. Throws Error.
  explicit SelectorView(const std::string& selector);

  std::string path;
  runtime::SelectorFile file;
  std::optional<train::SelectorRecord> record;
};

/// What `flinch info` shows of a selector.
Json selector_document(const SelectorView& view);
void print_selector(const SelectorView& view);

}  // namespace flinch::program

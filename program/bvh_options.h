// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/import/source_motion.h"
#include "program/document.h"
#include "program/options.h"

namespace flinch::program {

/// How to read BVH files; whatever is not given is detected.
struct BvhOptions {
  std::string unit;
  std::string up;
  std::string roles;  ///< path of a TOML file
  std::string rest;   ///< path of a BVH file in which the same skeleton stands
  std::optional<double> rate_hz;
  std::string frames;  ///< see frame_range_from
  bool skip_first = false;

  bool given() const {
    return !unit.empty() || !up.empty() || !roles.empty() || !rest.empty() || rate_hz ||
           !frames.empty() || skip_first;
  }
};
std::vector<Option> bvh_options(BvhOptions& options);

/// Returns the import options. Throws Error for a file of roles that cannot be used, UsageError for
/// a malformed range of frames.
database::SourceOptions source_options(const BvhOptions& options);

/// Describes what was detected in a BVH file: measures, and the joint of each role.
Json source_document(const database::SourceReport& source);
std::string source_text(const database::SourceReport& source);

}  // namespace flinch::program

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "database/import/source_motion.h"
#include "program/document.h"
#include "program/options.h"

namespace flinch::program {

/// How BVH files are to be understood where that is not left to be found out.
struct BvhOptions {
  std::string unit;
  std::string up;
  std::string roles;  ///< a TOML file

  bool given() const { return !unit.empty() || !up.empty() || !roles.empty(); }
};
std::vector<Option> bvh_options(BvhOptions& options);

/// Throws Error for a file of roles that cannot be used.
database::SourceOptions source_options(const BvhOptions& options);

/// What was found out about a BVH file: measures, and the joint of each role.
Json source_document(const database::SourceReport& source);
std::string source_text(const database::SourceReport& source);

}  // namespace flinch::program

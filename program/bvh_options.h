// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "database/import/source_motion.h"
#include "program/command.h"

namespace flinch::program {

/// How BVH files are to be understood where that is not left to be found out.
struct BvhOptions {
  std::string unit;
  std::string up;
  std::string roles;  ///< a TOML file

  bool given() const { return !unit.empty() || !up.empty() || !roles.empty(); }
};
void add_bvh_options(CLI::App& command, BvhOptions& options);

/// Throws Error for a file of roles that cannot be used.
database::SourceOptions source_options(const BvhOptions& options);

/// What was found out about a BVH file: measures, and the joint of each role.
Json source_document(const database::SourceReport& source);
std::string source_text(const database::SourceReport& source);

}  // namespace flinch::program

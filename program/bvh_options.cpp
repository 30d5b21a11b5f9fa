// SPDX-License-Identifier: MIT
#include "program/bvh_options.h"

#include <sstream>

#include "database/import/role_map.h"
#include "program/command_line.h"
#include "program/printable.h"
#include "program/table.h"

namespace flinch::program {

std::vector<Option> bvh_options(BvhOptions& options) {
  return {
      {"--unit", "unit of length in motion files (default: detected)", &options.unit,
       OneOf{{"m", "cm", "mm", "inch", "cmu"}}},
      {"--up", "axis that points up in motion files (default: detected)", &options.up,
       OneOf{{"x", "y", "z", "-x", "-y", "-z"}}},
      {"--roles", "TOML file with a table [roles] that has lines like head = \"Bip01 Head\"",
       &options.roles},
      {"--rest", "file of the same skeleton in which it stands, for files in which it never does",
       &options.rest},
      {"--rate-of-file", "frame rate that motion files really have, Hz (default: as they say)",
       &options.rate_hz, Range{database::kMinSourceRate_hz, database::kMaxSourceRate_hz}},
      {"--frames", "use only the frames FIRST:LAST of motion files, from 1, such as 2:90 or 2:",
       &options.frames},
      {"--skip-first", "leave out the first frame of motion files, where it is a T-pose",
       &options.skip_first}};
}

database::SourceOptions source_options(const BvhOptions& options) {
  database::SourceOptions source;
  source.unit = database::length_unit_named(options.unit);
  source.up = database::up_axis_named(options.up);
  if (!options.roles.empty()) source.roles = database::read_role_overrides(options.roles);
  if (!options.rest.empty()) source.rest = options.rest;
  source.frames.rate_hz = options.rate_hz;
  if (!options.frames.empty()) {
    source.frames.range = database::frame_range_from(options.frames);
    if (!source.frames.range) {
      throw UsageError("--frames needs FIRST:LAST, such as 2:90 or 2:, but is " + options.frames);
    }
  }
  if (options.skip_first) source.frames.skip_first = true;
  return source;
}

Json source_document(const database::SourceReport& source) {
  Json roles;
  for (const motion::Role role : motion::kRoles) {
    const std::string& joint = source.joint_name[role];
    roles[std::string(motion::name_of(role))] = {
        {"joint", joint.empty() ? Json() : Json(joint)},
        {"found_by", database::name_of(source.joint_source[role])}};
  }
  return {{"kind", database::word_of(source.kind)},
          {"file", source.path},
          {"joint_count", source.joint_count},
          {"first_frame", source.first_frame},
          {"frame_count", source.frame_count},
          {"frame_time_s", source.frame_time_s},
          {"duration_s", source.duration_s},
          {"unit", database::name_of(source.unit)},
          {"up", database::name_of(source.up)},
          {"head_height_m", source.head_height_m},
          {"roles", roles},
          {"warnings", source.warnings}};
}

namespace {

std::string from_frame(int first) {
  return first == 1 ? "" : " from frame " + std::to_string(first);
}

}  // namespace

std::string source_text(const database::SourceReport& source) {
  Table table({{"role"}, {"joint"}, {"found by"}});
  for (const motion::Role role : motion::kRoles) {
    const std::string& joint = source.joint_name[role];
    table.add({std::string(motion::name_of(role)), joint.empty() ? "-" : joint,
               std::string(database::name_of(source.joint_source[role]))});
  }
  std::ostringstream text;
  text << printable(source.path) << ": " << source.joint_count << " joints, " << source.frame_count
       << " frames" << from_frame(source.first_frame) << ", " << fixed(source.duration_s, 2)
       << " s; in " << database::name_of(source.unit) << (source.unit_given ? "" : " (found)")
       << ", up " << database::name_of(source.up) << (source.up_given ? "" : " (found)")
       << ", head at " << fixed(source.head_height_m, 2) << " m\n\n"
       << table.text();
  for (const std::string& warning : source.warnings) text << "note: " << printable(warning) << '\n';
  return text.str();
}

}  // namespace flinch::program

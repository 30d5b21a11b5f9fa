// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings/python/arrays.h"
#include "bindings/python/long_work.h"
#include "bindings/python/offline.h"
#include "database/author/authored_library.h"
#include "database/author/character_toml.h"
#include "database/files/library_writer.h"
#include "database/files/output_check.h"
#include "database/files/provenance.h"
#include "database/import/import.h"
#include "motion/default_character.h"

namespace flinch::python {

namespace py = pybind11;

namespace {

using database::ClipLibrary;

/// Poses of a clip: root positions (n, 3) and local rotations (n, 21, 4).
py::tuple poses_of(const ClipLibrary& library, int clip) {
  if (clip < 0 || static_cast<std::size_t>(clip) >= library.clips.size())
    throw py::index_error("there is no such clip");
  const std::vector<motion::Pose>& poses = library.clip(clip).motion.poses;
  Array<float> root = make_array<float>({poses.size(), 3});
  Array<float> rotation = make_array<float>({poses.size(), motion::kRoleCount, 4});
  float* to_root = root.mutable_data();
  float* to_rotation = rotation.mutable_data();
  for (const motion::Pose& pose : poses) {
    for (const float value : pose.root_position) *to_root++ = value;
    for (const Eigen::Quaternionf& q : pose.rotation)
      for (const float value : {q.w(), q.x(), q.y(), q.z()}) *to_rotation++ = value;
  }
  return py::make_tuple(root, rotation);
}

py::dict clip_of(const motion::Clip& clip) {
  py::dict made;
  made["name"] = clip.name;
  made["purpose"] = std::string(motion::name_of(clip.purpose));
  made["kind"] = clip.kind;
  made["source"] = clip.source;
  made["mirrored_from"] = clip.mirrored_from;
  made["duration_s"] = clip.motion.duration_s();
  if (clip.annotation) {
    made["target"] = std::string(motion::name_of(clip.annotation->target));
    made["direction"] = clip.annotation->direction;
    made["degree"] = std::string(motion::name_of(clip.annotation->degree));
    made["onset_s"] = clip.annotation->onset_s;
    made["peak_s"] = clip.annotation->peak_s;
    made["end_s"] = clip.annotation->end_s;
  }
  return made;
}

void save_library(ClipLibrary& library, const std::filesystem::path& path, bool force) {
  database::check_outputs({{path.string(), database::FileKind::library, ""}}, {},
                          force ? database::Overwrite::force : database::Overwrite::refuse);
  library.hash = database::write_library(library, path.string());
}

std::optional<std::string> text_of(const std::optional<std::filesystem::path>& path) {
  return path ? std::optional(path->string()) : std::nullopt;
}

ClipLibrary author(const std::optional<std::filesystem::path>& character, bool startle,
                   const py::object& progress) {
  ClipLibrary made;
  run_interruptibly(progress, [&](WorkMonitor& monitor) {
    monitor.tell({"authoring clips"});
    made = database::authored_library(
        character ? database::find_character(character->string()) : motion::default_character(),
        startle);
    made.provenance = database::authored_provenance(text_of(character), startle);
  });
  return made;
}

/// Returns what a name means. Throws ValueError for a name without meaning.
template <class Value>
std::optional<Value> named(const std::optional<std::string>& name, std::optional<Value> value,
                           const char* what) {
  if (name && !value) throw py::value_error("there is no " + std::string(what) + ' ' + *name);
  return value;
}

std::vector<std::string> notes_of(const database::ImportReport& report) {
  std::vector<std::string> notes;
  for (const database::SkippedFile& file : report.skipped)
    notes.push_back("skipped " + file.path + ": " + file.reason);
  for (const database::SourceReport& source : report.sources)
    for (const std::string& warning : source.warnings)
      notes.push_back(source.path + ": " + warning);
  for (const database::ClipReport& clip : report.clips)
    for (const std::string& warning : clip.warnings)
      notes.push_back(clip.source + ": clip " + clip.name + ": " + warning);
  notes.insert(notes.end(), report.warnings.begin(), report.warnings.end());
  return notes;
}

/// The library, and what the import noted.
py::tuple import_motion(
    const std::vector<std::filesystem::path>& paths,
    const std::optional<std::filesystem::path>& manifest, std::optional<float> rate_hz,
    const std::optional<std::filesystem::path>& skeleton, const std::optional<std::string>& unit,
    const std::optional<std::string>& up, const std::optional<std::filesystem::path>& roles,
    const std::optional<std::filesystem::path>& rest, const py::object& progress) {
  database::ImportOptions options;
  options.rate_hz = rate_hz;
  options.skeleton = text_of(skeleton);
  options.source.rest = text_of(rest);
  options.source.unit = named(unit, database::length_unit_named(unit.value_or("")), "unit");
  options.source.up = named(up, database::up_axis_named(up.value_or("")), "axis");
  if (roles) options.source.roles = database::read_role_overrides(roles->string());
  std::vector<std::string> names;
  for (const std::filesystem::path& path : paths) names.push_back(path.string());
  database::ImportResult result;
  run_interruptibly(progress, [&](WorkMonitor& monitor) {
    monitor.tell({"importing motion"});
    result = database::import_library(names, text_of(manifest), options);
  });
  const std::vector<std::string> notes = notes_of(result.report);
  return py::make_tuple(std::move(result.library), notes);
}

}  // namespace

py::object provenance_object(const std::string& text) {
  if (text.empty()) return py::none();
  if (!database::provenance_of(text)) throw Error("", "the provenance is damaged");
  return py::module_::import("json").attr("loads")(text);
}

void bind_clip_library(py::module_& module) {
  py::class_<ClipLibrary>(module, "ClipLibrary", "The clips of one character, with its skeleton.")
      .def(py::init([](const std::filesystem::path& path) {
             return database::load_library(path.string());
           }),
           py::arg("path"), "Reads a library file.")
      .def("save", &save_library, py::arg("path"), py::arg("force") = false,
           "Writes the file; force replaces a file of another kind.")
      .def("poses", &poses_of, py::arg("clip"),
           "Poses of a clip: root positions (n, 3) and local rotations (n, 21, 4).")
      .def_readonly("name", &ClipLibrary::name)
      .def_readonly("rate_hz", &ClipLibrary::rate_hz)
      .def_readonly("idle", &ClipLibrary::idle, "Index of the idle clip.")
      .def_property_readonly("hash",
                             [](const ClipLibrary& self) { return database::hash_text(self.hash); })
      .def_property_readonly(
          "provenance", [](const ClipLibrary& self) { return provenance_object(self.provenance); },
          "How it was made; None if that is not recorded.")
      .def_property_readonly("clips", [](const ClipLibrary& self) {
        py::list clips;
        for (const motion::Clip& clip : self.clips) clips.append(clip_of(clip));
        return clips;
      });
  module.def("author", &author, py::kw_only(), py::arg("character") = py::none(),
             py::arg("startle") = false, py::arg("progress") = py::none(),
             "Makes the default library by rule, as flinch author does.");
  module.def("import_motion", &import_motion, py::arg("paths"), py::kw_only(),
             py::arg("manifest") = py::none(), py::arg("rate_hz") = py::none(),
             py::arg("skeleton") = py::none(), py::arg("unit") = py::none(),
             py::arg("up") = py::none(), py::arg("roles") = py::none(),
             py::arg("rest") = py::none(), py::arg("progress") = py::none(),
             "Makes a library from motion capture, as flinch import does. Returns it and notes.");
}

}  // namespace flinch::python

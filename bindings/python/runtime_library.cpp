// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <string_view>
#include <vector>

#include "bindings/python/runtime.h"
#include "train/fit/selector_reader.h"

namespace flinch::python {

namespace py = pybind11;

Library::Library(flinch_library* loaded) : handle_(loaded, flinch_library_free) {
  flinch_workspace* workspace = nullptr;
  checked(flinch_workspace_create(loaded, &workspace));
  workspace_.reset(workspace, flinch_workspace_free);
}

std::shared_ptr<Library> Library::load(const std::filesystem::path& path) {
  flinch_library* loaded = nullptr;
  const flinch_status status = flinch_library_load(path.c_str(), &loaded);
  if (status < 0) {
    train::load_runtime_library(path.string());  // throws, and knows more about the file
    throw StatusError(status, path.string());
  }
  return std::shared_ptr<Library>(new Library(loaded));
}

std::shared_ptr<Library> Library::from_bytes(const py::bytes& bytes) {
  const std::string_view view = bytes;
  flinch_library* loaded = nullptr;
  checked(flinch_library_load_memory(view.data(), view.size(), &loaded));
  return std::shared_ptr<Library>(new Library(loaded));
}

std::shared_ptr<Library> Library::take(const py::bytes& bytes) {
  const std::string_view view = bytes;
  flinch_library* loaded = nullptr;
  checked(flinch_library_take(view.data(), view.size(), &loaded));
  return std::shared_ptr<Library>(new Library(loaded));
}

std::shared_ptr<Library> Library::load_beside(const py::bytes& bytes, const Library& owner) {
  const std::string_view view = bytes;
  flinch_library* loaded = nullptr;
  checked(flinch_library_load_beside(view.data(), view.size(), owner.get(), &loaded));
  return std::shared_ptr<Library>(new Library(loaded));
}

MotionGraph::MotionGraph(const Library& library) {
  flinch_motion_graph* made = nullptr;
  checked(flinch_motion_graph_create(library.get(), &made));
  handle.reset(made, flinch_motion_graph_free);
}

flinch_look_ahead* Library::look_ahead() {
  if (!look_ahead_) {
    flinch_look_ahead* made = nullptr;
    checked(flinch_look_ahead_create(get(), &made));
    look_ahead_.reset(made, flinch_look_ahead_free);
  }
  return look_ahead_.get();
}

flinch_library_info Library::info() const {
  auto info = sized<flinch_library_info>();
  checked(flinch_library_describe(get(), &info));
  return info;
}

namespace {

/// A clip; its times and what it protects are None unless it is annotated.
py::dict clip_of(const Library& library, std::int32_t index) {
  auto clip = sized<flinch_clip>();
  checked(flinch_library_clip(library.get(), index, &clip));
  py::dict made;
  made["name"] = clip.name;
  made["kind"] = clip.kind;
  made["duration_s"] = clip.duration_s;
  if (clip.is_annotated != 0) {
    made["target"] = flinch_target_name(clip.target);
    made["direction"] = clip.direction;
    made["degree"] = clip.degree == 0 ? "mild" : "exaggerated";
    made["onset_s"] = clip.onset_s;
    made["peak_s"] = clip.peak_s;
    made["end_s"] = clip.end_s;
  }
  return made;
}

py::dict kind_of(const Library& library, std::int32_t index) {
  constexpr const char* kShapes[] = {"ball", "blade", "fist", "rod"};
  auto kind = sized<flinch_kind>();
  checked(flinch_library_kind(library.get(), index, &kind));
  const auto range = [](const float(&ends)[2]) { return py::make_tuple(ends[0], ends[1]); };
  py::dict made;
  made["name"] = kind.name;
  made["shape"] = kShapes[kind.shape];
  made["radius_m"] = range(kind.radius);
  made["mass_kg"] = range(kind.mass_kg);
  made["speed_mps"] = range(kind.speed_mps);
  made["elevation"] = range(kind.elevation);
  made["time_to_impact_s"] = range(kind.time_to_impact_s);
  made["reach_m"] = range(kind.reach_m);
  made["length_m"] = range(kind.length_m);
  made["restitution"] = kind.restitution;
  made["friction"] = kind.friction;
  made["is_straight"] = kind.is_straight != 0;
  return made;
}

py::dict body_of(const Library& library, std::int32_t body) {
  auto outline = sized<flinch_outline>();
  checked(flinch_library_outline(library.get(), body, &outline));
  py::dict made;
  made["name"] = flinch_body_name(body);
  made["joint"] = flinch_joint_name(outline.joint);
  made["mass_kg"] = outline.mass_kg;
  made["centre_of_mass"] = array_of(outline.centre_of_mass, {3});
  made["shape"] = outline.is_box != 0 ? "box" : "capsule";
  made["centre"] = array_of(outline.centre, {3});
  made["orientation"] = array_of(outline.orientation, {4});
  if (outline.is_box != 0) {
    made["half_extents"] = array_of(outline.half_extents, {3});
  } else {
    made["radius"] = outline.radius;
    made["half_length"] = outline.half_length;
  }
  return made;
}

template <class Make>
py::list list_of(std::int32_t count, const Make& make) {
  py::list list;
  for (std::int32_t i = 0; i < count; ++i) list.append(make(i));
  return list;
}

py::tuple skeleton_of(const Library& library) {
  auto skeleton = sized<flinch_skeleton>();
  checked(flinch_library_skeleton(library.get(), &skeleton));
  return py::make_tuple(array_of(&skeleton.offset[0][0], {FLINCH_JOINT_COUNT, 3}),
                        array_of(&skeleton.tip[0][0], {FLINCH_JOINT_COUNT, 3}));
}

py::tuple joint_frames(const Library& library, const Pose& pose) {
  auto frames = sized<flinch_joint_frames>();
  checked(flinch_library_joint_frames(library.get(), &pose.value, &frames));
  return py::make_tuple(array_of(&frames.position[0][0], {FLINCH_JOINT_COUNT, 3}),
                        array_of(&frames.orientation[0][0], {FLINCH_JOINT_COUNT, 4}));
}

/// The stances' clips; the first is the idle clip.
py::list stances_of(const Library& library) {
  py::list clips;
  for (std::int32_t stance = 0;; ++stance) {
    const std::int32_t clip = flinch_library_stance(library.get(), stance);
    if (clip < 0) return clips;
    clips.append(clip);
  }
}

}  // namespace

void bind_library(py::module_& module) {
  py::class_<Library, std::shared_ptr<Library>>(
      module, "Library", "What `flinch train` writes: skeleton, clips and selector. Immutable.")
      .def(py::init(&Library::load), py::arg("path"), "Loads and verifies a selector file.")
      .def_static("from_bytes", &Library::from_bytes, py::arg("bytes"),
                  "The same from the file's bytes.")
      .def_static("take", &Library::take, py::arg("bytes"),
                  "Of the bytes of a library's file, whose characters answer by rule.")
      .def_static("load_beside", &Library::load_beside, py::arg("bytes"), py::arg("owner"),
                  "A selector's file for the clips of another library, which both share.")
      .def_property_readonly("idle_clip", [](const Library& self) { return self.info().idle_clip; })
      .def_property_readonly("rate_hz", [](const Library& self) { return self.info().rate_hz; })
      .def_property_readonly("mass_kg", [](const Library& self) { return self.info().mass_kg; })
      .def_property_readonly("clips",
                             [](const Library& self) {
                               return list_of(self.info().clip_count, [&](std::int32_t index) {
                                 return clip_of(self, index);
                               });
                             })
      .def_property_readonly("kinds",
                             [](const Library& self) {
                               return list_of(self.info().kind_count, [&](std::int32_t index) {
                                 return kind_of(self, index);
                               });
                             })
      .def_property_readonly("bodies",
                             [](const Library& self) {
                               return list_of(FLINCH_BODY_COUNT, [&](std::int32_t index) {
                                 return body_of(self, index);
                               });
                             })
      .def_property_readonly("stances", &stances_of, "Indices of the stances' clips.")
      .def_property_readonly("skeleton", &skeleton_of,
                             "Offsets from the parents and tips of the segments, (21, 3) each, m.")
      .def(
          "clip_pose",
          [](const Library& self, std::int32_t clip, float time_s) {
            Pose pose;
            checked(flinch_library_clip_pose(self.get(), clip, time_s, &pose.value));
            return pose;
          },
          py::arg("clip"), py::arg("time_s"),
          "The pose of a clip at a time of it, above the world's origin.")
      .def("joint_frames", &joint_frames, py::arg("pose"),
           "Positions (21, 3) and orientations (21, 4) of the joints of a pose, world.");
  py::class_<MotionGraph>(module, "MotionGraph",
                          "The moments of a library's everyday clips that can follow each other.")
      .def(py::init<const Library&>(), py::arg("library"));
  module.attr("JOINTS") = py::tuple(list_of(FLINCH_JOINT_COUNT, flinch_joint_name));
  module.attr("JOINT_PARENTS") = py::tuple(list_of(FLINCH_JOINT_COUNT, flinch_joint_parent));
  module.attr("BODIES") = py::tuple(list_of(FLINCH_BODY_COUNT, flinch_body_name));
  module.attr("TARGETS") = py::tuple(list_of(FLINCH_LEGS + 1, flinch_target_name));
}

}  // namespace flinch::python

// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <array>
#include <vector>

#include "bindings/python/runtime.h"

namespace flinch::python {

namespace py = pybind11;

std::string answer_of(flinch_status status) {
  constexpr std::array kAnswers{"ok", "misses", "unnoticed", "outside_training", "no_good_answer"};
  return kAnswers[static_cast<std::size_t>(checked(status))];
}

namespace {

template <class Name>
std::int32_t numbered(const std::string& wanted, const std::string& what, const Name& name) {
  std::string known;
  for (std::int32_t i = 0; name(i) != nullptr; ++i) {
    if (wanted == name(i)) return i;
    known += (known.empty() ? "" : ", ") + std::string(name(i));
  }
  throw py::value_error("there is no " + what + " " + wanted + "; it is one of " + known);
}

Threat make_threat(const Array<float>& position, const Array<float>& velocity, float radius,
                   float mass_kg, std::int32_t kind, float starts_in_s, float lasts_s,
                   const Array<float>& axis, const Array<float>& angular_velocity, float to_butt_m,
                   float to_tip_m) {
  Threat threat;
  copy_into(position, {3}, "position", threat.value.position);
  copy_into(velocity, {3}, "velocity", threat.value.velocity);
  threat.value.radius = radius;
  threat.value.mass_kg = mass_kg;
  threat.value.kind = kind;
  threat.value.starts_in_s = starts_in_s;
  threat.value.lasts_s = lasts_s;
  copy_into(axis, {3}, "axis", threat.value.axis);
  copy_into(angular_velocity, {3}, "angular_velocity", threat.value.angular_velocity);
  threat.value.to_butt_m = to_butt_m;
  threat.value.to_tip_m = to_tip_m;
  return threat;
}

Pose make_pose(const Array<float>& root_position, const Array<float>& rotation) {
  Pose pose;
  copy_into(root_position, {3}, "root_position", pose.value.root_position);
  copy_into(rotation, {FLINCH_JOINT_COUNT, 4}, "rotation", &pose.value.rotation[0][0]);
  return pose;
}

}  // namespace

std::int32_t target_numbered(const std::string& name) {
  return numbered(name, "target", flinch_target_name);
}

std::int32_t joint_numbered(const std::string& name) {
  return numbered(name, "joint", flinch_joint_name);
}

void bind_values(py::module_& module) {
  py::class_<Threat>(module, "Threat", "Something that approaches, as it is now; world, m, m/s.")
      .def(py::init(&make_threat), py::arg("position"), py::arg("velocity"),
           py::arg("radius") = 0.105F, py::arg("mass_kg") = 0.27F, py::arg("kind") = 0,
           py::arg("starts_in_s") = 0.0F, py::arg("lasts_s") = 0.0F,
           py::arg("axis") = std::vector<float>(3),
           py::arg("angular_velocity") = std::vector<float>(3), py::arg("to_butt_m") = 0.0F,
           py::arg("to_tip_m") = 0.0F)
      .def_property_readonly("position",
                             [](const Threat& self) { return array_of(self.value.position, {3}); })
      .def_property_readonly("velocity",
                             [](const Threat& self) { return array_of(self.value.velocity, {3}); })
      .def_property_readonly("radius", [](const Threat& self) { return self.value.radius; })
      .def_property_readonly("mass_kg", [](const Threat& self) { return self.value.mass_kg; })
      .def_property_readonly("kind", [](const Threat& self) { return self.value.kind; })
      .def_property_readonly("starts_in_s",
                             [](const Threat& self) { return self.value.starts_in_s; })
      .def_property_readonly("lasts_s", [](const Threat& self) { return self.value.lasts_s; })
      .def_property_readonly(
          "axis", [](const Threat& self) { return array_of(self.value.axis, {3}); },
          "Of a rod, from butt to tip, unit.")
      .def_property_readonly(
          "angular_velocity",
          [](const Threat& self) { return array_of(self.value.angular_velocity, {3}); },
          "Of a rod, rad/s.")
      .def_property_readonly(
          "to_butt_m", [](const Threat& self) { return self.value.to_butt_m; },
          "Of a rod, from its position.")
      .def_property_readonly(
          "to_tip_m", [](const Threat& self) { return self.value.to_tip_m; },
          "Of a rod, from its position.");
  py::class_<Pose>(module, "Pose", "All that moves: the pelvis' position and local rotations.")
      .def(py::init(&make_pose), py::arg("root_position"), py::arg("rotation"))
      .def_property_readonly(
          "root_position", [](const Pose& self) { return array_of(self.value.root_position, {3}); },
          "Of the pelvis joint, world, m: (3,).")
      .def_property_readonly(
          "rotation",
          [](const Pose& self) {
            return array_of(&self.value.rotation[0][0], {FLINCH_JOINT_COUNT, 4});
          },
          "Relative to the parent's frame, the pelvis' to the world; w, x, y, z: (21, 4).");
}

}  // namespace flinch::python

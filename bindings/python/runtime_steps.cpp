// SPDX-License-Identifier: MIT
// The steps of perceiving: for those who choose among the answers themselves.
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <vector>

#include "bindings/python/runtime.h"

namespace flinch::python {

namespace py = pybind11;

namespace {

Perception make_perception(const Threat& threat, const std::string& target, float time_to_impact_s,
                           float delay_s, const Array<float>& position, float facing,
                           float stance_time_s, std::int32_t stance) {
  Perception perception;
  perception.value.target = target_numbered(target);
  perception.value.time_to_impact_s = time_to_impact_s;
  perception.value.delay_s = delay_s;
  copy_into(position, {2}, "position", perception.value.position);
  perception.value.facing = facing;
  perception.value.stance_time_s = stance_time_s;
  perception.value.stance = stance;
  perception.value.threat = threat.value;
  return perception;
}

/// The answer, and what was noticed unless there is nothing to answer.
py::tuple notice(const Character& self, const Threat& threat) {
  Perception noticed;
  const flinch_status status =
      checked(flinch_character_notice(self.get(), &threat.value, &noticed.value));
  return py::make_tuple(answer_of(status),
                        status == FLINCH_OK ? py::cast(noticed) : py::object(py::none()));
}

/// The answer, and what was noticed, the most urgent one first.
py::tuple notice_all(const Character& self, const std::vector<Threat>& threats) {
  std::vector<flinch_threat> values;
  for (const Threat& threat : threats) values.push_back(threat.value);
  std::vector<flinch_perception> noticed(threats.size(), Perception().value);
  std::int32_t count = 0;
  const auto given = static_cast<std::int32_t>(values.size());
  const std::string answer = answer_of(
      flinch_character_notice_all(self.get(), values.data(), given, noticed.data(), given, &count));
  py::list perceptions;
  for (std::int32_t i = 0; i < count; ++i) {
    Perception one;
    one.value = noticed[static_cast<std::size_t>(i)];
    perceptions.append(one);
  }
  return py::make_tuple(answer, perceptions);
}

py::list rank(const Character& self, const Perception& perception) {
  std::array<flinch_candidate, FLINCH_MOST_CANDIDATES> found{};
  std::int32_t count = 0;
  checked(flinch_character_rank(self.get(), &perception.value, self.library->workspace(),
                                found.data(), FLINCH_MOST_CANDIDATES, &count));
  return candidate_list(found.data(), count);
}

/// None where the threat arrives before the character can act.
py::object plan(const Character& self, const Perception& perception, std::int32_t clip) {
  auto plan = sized<flinch_plan>();
  if (checked(flinch_character_plan(self.get(), &perception.value, clip, &plan)) != FLINCH_OK)
    return py::none();
  py::dict made;
  made["first_motion_s"] = plan.first_motion_s;
  made["begin_s"] = plan.begin_s;
  made["peak_s"] = plan.peak_s;
  made["end_s"] = plan.end_s;
  made["duration_s"] = plan.duration_s;
  made["playback_rate"] = plan.playback_rate;
  return made;
}

py::object planned_pose(const Character& self, const Perception& perception, std::int32_t clip,
                        float time_s) {
  Pose pose;
  const flinch_status status = checked(
      flinch_character_planned_pose(self.get(), &perception.value, clip, time_s, &pose.value));
  return status == FLINCH_OK ? py::cast(pose) : py::object(py::none());
}

std::string answer(const Character& self, const Perception& perception, std::int32_t clip,
                   const py::list& candidates) {
  std::vector<flinch_candidate> values;
  for (const py::handle one : candidates) {
    values.push_back({one["clip"].cast<std::int32_t>(), one["vote"].cast<float>(),
                      one["expected_cost_ns"].cast<float>()});
  }
  return answer_of(flinch_character_answer(self.get(), &perception.value, clip, values.data(),
                                           static_cast<std::int32_t>(values.size())));
}

}  // namespace

void bind_perception(py::module_& module) {
  py::class_<Perception>(module, "Perception",
                         "A threat that was noticed, and where the character was then.")
      .def(py::init(&make_perception), py::arg("threat"), py::arg("target"),
           py::arg("time_to_impact_s"), py::arg("delay_s") = 0.0F,
           py::arg("position") = std::vector<float>{0, 0}, py::arg("facing") = 0.0F,
           py::arg("stance_time_s") = 0.0F, py::arg("stance") = 0)
      .def_property_readonly("threat",
                             [](const Perception& self) { return Threat{self.value.threat}; })
      .def_property_readonly(
          "target", [](const Perception& self) { return flinch_target_name(self.value.target); })
      .def_property_readonly("time_to_impact_s",
                             [](const Perception& self) { return self.value.time_to_impact_s; })
      .def_property_readonly(
          "delay_s", [](const Perception& self) { return self.value.delay_s; },
          "Until the character can act.")
      .def_property_readonly(
          "position", [](const Perception& self) { return array_of(self.value.position, {2}); })
      .def_property_readonly("facing", [](const Perception& self) { return self.value.facing; })
      .def_property_readonly("stance_time_s",
                             [](const Perception& self) { return self.value.stance_time_s; })
      .def_property_readonly("stance", [](const Perception& self) { return self.value.stance; });
}

void bind_steps(CharacterClass& character) {
  character
      .def("notice", &notice, py::arg("threat"),
           "Predicts the impact as perceive does, and answers nothing: (answer, Perception or "
           "None).")
      .def("notice_all", &notice_all, py::arg("threats"),
           "The same for several threats: (answer, Perceptions, the most urgent first).")
      .def("rank", &rank, py::arg("perception"),
           "The clips that the selector considers for what was noticed, best first.")
      .def("plan", &plan, py::arg("perception"), py::arg("clip"),
           "When the response with this clip would do what, s after the reaction delay; None if "
           "the threat arrives before.")
      .def("planned_pose", &planned_pose, py::arg("perception"), py::arg("clip"), py::arg("time_s"),
           "The pose of that response at a time; None where there is none.")
      .def("answer", &answer, py::arg("perception"), py::arg("clip"),
           py::arg("candidates") = py::list(),
           "Starts that response; candidates, as of rank, are what .candidates gives then.");
}

}  // namespace flinch::python

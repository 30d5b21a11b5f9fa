// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <array>
#include <chrono>
#include <limits>
#include <optional>
#include <vector>

#include "bindings/python/runtime.h"

namespace flinch::python {

namespace py = pybind11;

Character::Character(std::shared_ptr<Library> of, bool reacting, const HitOptions& hits)
    : library(std::move(of)) {
  if (!reacting && (hits.simulation_only_s || hits.stiffness))
    throw py::value_error("simulation_only_s and stiffness are for reacting=True");
  flinch_character* made = nullptr;
  if (reacting) {
    auto options = sized<flinch_reaction_options>();
    checked(flinch_reaction_defaults(&options));
    options.simulation_only_s = hits.simulation_only_s.value_or(options.simulation_only_s);
    options.stiffness = hits.stiffness.value_or(options.stiffness);
    checked(flinch_character_create_reacting_as(library->get(), &options, &made));
  } else {
    checked(flinch_character_create(library->get(), &made));
  }
  handle.reset(made, flinch_character_free);
}

py::list candidate_list(const flinch_candidate* candidates, std::int32_t count) {
  py::list made;
  for (std::int32_t i = 0; i < count; ++i) {
    py::dict candidate;
    candidate["clip"] = candidates[i].clip;
    candidate["vote"] = candidates[i].vote;
    candidate["expected_cost_ns"] = candidates[i].expected_cost_ns;
    made.append(candidate);
  }
  return made;
}

namespace {

std::vector<flinch_threat> values_of(const std::vector<Threat>& threats) {
  std::vector<flinch_threat> values;
  for (const Threat& threat : threats) values.push_back(threat.value);
  return values;
}

std::string perceive(const Character& self, const Threat& threat) {
  return answer_of(flinch_character_perceive(self.get(), &threat.value, self.library->workspace()));
}

std::string perceive_all(const Character& self, const std::vector<Threat>& threats) {
  const std::vector<flinch_threat> values = values_of(threats);
  return answer_of(flinch_character_perceive_all(self.get(), values.data(),
                                                 static_cast<std::int32_t>(values.size()),
                                                 self.library->workspace()));
}

std::string perceive_known(const Character& self, const Threat& threat, const std::string& target,
                           float time_to_impact_s) {
  return answer_of(flinch_character_perceive_known(self.get(), &threat.value,
                                                   target_numbered(target), time_to_impact_s,
                                                   self.library->workspace()));
}

/// {"mass_kg": (value, (least, largest)), ...}
py::dict outside_training(const Character& self, const Threat& threat) {
  std::array<flinch_outside, FLINCH_MOST_OUTSIDE> outside{};
  std::int32_t count = 0;
  checked(flinch_character_outside_training(self.get(), &threat.value, outside.data(),
                                            FLINCH_MOST_OUTSIDE, &count));
  py::dict made;
  for (std::int32_t i = 0; i < count; ++i) {
    const flinch_outside& one = outside[static_cast<std::size_t>(i)];
    made[one.name] = py::make_tuple(one.value, py::make_tuple(one.trained[0], one.trained[1]));
  }
  return made;
}

double now_us(void*) {
  using Microseconds = std::chrono::duration<double, std::micro>;
  return Microseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

py::dict foreseen_document(const flinch_foreseen& one) {
  py::dict made;
  made["clip"] = one.clip;
  made["foreseen"] = flinch_foreseen_name(one.foreseen);
  made["work_j"] = one.work_j;
  made["damage_ns"] = one.damage_ns;
  made["cost_ns"] = one.cost_ns;
  made["contact_s"] = one.contact_s;
  return made;
}

py::dict look_ahead(const Character& self, const std::vector<Threat>& threats,
                    std::int32_t candidates, std::optional<float> budget_us) {
  const std::vector<flinch_threat> values = values_of(threats);
  auto options = sized<flinch_look_ahead_options>();
  options.candidates = candidates;
  if (budget_us) {
    options.budget_us = *budget_us;
    options.now_us = now_us;
  }
  auto found = sized<flinch_look_ahead_status>();
  py::dict made;
  made["answer"] = answer_of(flinch_character_look_ahead(
      self.get(), values.data(), static_cast<std::int32_t>(values.size()), &options,
      self.library->look_ahead(), &found));
  py::list tried;
  for (std::int32_t i = 0; i < found.candidate_count; ++i)
    tried.append(foreseen_document(found.candidate[i]));
  made["candidates"] = tried;
  made["chosen"] = found.chosen;
  made["tried"] = found.tried;
  made["encounters"] = found.encounters;
  made["threats"] = found.threats;
  made["ignored"] = found.ignored;
  made["is_complete"] = found.is_complete != 0;
  return made;
}

void limit_perception(const Character& self, std::uint64_t seed, float reaction_delay_s,
                      float bearing_noise, float distance_noise, float heading_noise,
                      float speed_noise, float chance_to_fail) {
  auto limits = sized<flinch_perception_limits>();
  limits.reaction_delay_s = reaction_delay_s;
  limits.bearing_noise = bearing_noise;
  limits.distance_noise = distance_noise;
  limits.heading_noise = heading_noise;
  limits.speed_noise = speed_noise;
  limits.chance_to_fail = chance_to_fail;
  checked(flinch_character_limit_perception(self.get(), &limits, seed));
}

py::dict human_limits(std::int32_t choices) {
  auto limits = sized<flinch_perception_limits>();
  checked(flinch_human_limits(choices, &limits));
  py::dict made;
  made["reaction_delay_s"] = limits.reaction_delay_s;
  made["bearing_noise"] = limits.bearing_noise;
  made["distance_noise"] = limits.distance_noise;
  made["heading_noise"] = limits.heading_noise;
  made["speed_noise"] = limits.speed_noise;
  made["chance_to_fail"] = limits.chance_to_fail;
  return made;
}

std::string push(const Character& self, const std::string& joint, const Array<float>& velocity) {
  std::array<float, 3> value{};
  copy_into(velocity, {3}, "velocity", value.data());
  return answer_of(flinch_character_push(self.get(), joint_numbered(joint), value.data(),
                                         self.library->workspace()));
}

py::list push_candidates(const Character& self) {
  std::array<flinch_push_candidate, FLINCH_MOST_CANDIDATES> found{};
  std::int32_t count = 0;
  checked(
      flinch_character_push_candidates(self.get(), found.data(), FLINCH_MOST_CANDIDATES, &count));
  py::list made;
  for (std::int32_t i = 0; i < count; ++i) {
    const flinch_push_candidate& one = found[static_cast<std::size_t>(i)];
    py::dict candidate;
    candidate["clip"] = one.clip;
    candidate["realism"] = one.realism;
    candidate["turn"] = one.turn;
    candidate["taper"] = one.taper;
    candidate["deformation"] = array_of(one.deformation, {3});
    made.append(candidate);
  }
  return made;
}

py::list candidates(const Character& self) {
  std::array<flinch_candidate, FLINCH_MOST_CANDIDATES> found{};
  std::int32_t count = 0;
  checked(flinch_character_candidates(self.get(), found.data(), FLINCH_MOST_CANDIDATES, &count));
  return candidate_list(found.data(), count);
}

Pose pose(const Character& self) {
  Pose pose;
  checked(flinch_character_pose(self.get(), &pose.value));
  return pose;
}

Pose pose_over(const Character& self, const Pose& game, const Array<float>& joint, float weight) {
  auto mask = sized<flinch_mask>();
  mask.weight = weight;
  copy_into(joint, {FLINCH_JOINT_COUNT}, "joint", mask.joint);
  Pose made;
  checked(flinch_character_pose_over(self.get(), &game.value, &mask, &made.value));
  return made;
}

flinch_character_state state_of(const Character& self) {
  auto state = sized<flinch_character_state>();
  checked(flinch_character_describe(self.get(), &state));
  return state;
}

py::dict reaction(const Character& self) {
  constexpr std::array kPhases{"none",    "awaits", "struck",      "recovers",
                               "returns", "over",   "knocked_over"};
  constexpr std::array kMovers{"character", "physics", "clip"};
  auto now = sized<flinch_reaction>();
  checked(flinch_character_reaction(self.get(), &now));
  py::dict made;
  made["phase"] = kPhases[static_cast<std::size_t>(now.phase)];
  made["moved_by"] = kMovers[static_cast<std::size_t>(now.moved_by)];
  made["clip"] = now.clip;
  made["contact_s"] = now.contact_s;
  made["ball_position"] = array_of(now.ball_position, {3});
  made["ball_velocity"] = array_of(now.ball_velocity, {3});
  made["ball_axis"] = array_of(now.ball_axis, {3});
  made["ball_momentum"] = array_of(now.ball_momentum, {3});
  made["impulse_ns"] = array_of(now.impulse_ns, {FLINCH_BODY_COUNT});
  return made;
}

void bind_motion(CharacterClass& character) {
  character
      .def(
          "place",
          [](const Character& self, float x, float y, float facing, float stance_time_s,
             std::int32_t stance) {
            checked(
                flinch_character_place_in_stance(self.get(), x, y, facing, stance_time_s, stance));
          },
          py::arg("x") = 0.0F, py::arg("y") = 0.0F, py::arg("facing") = 0.0F,
          py::arg("stance_time_s") = 0.0F, py::arg("stance") = 0,
          "Puts it on the ground, m and radians. Ends any response.")
      .def(
          "change_stance",
          [](const Character& self, std::int32_t stance) {
            checked(flinch_character_change_stance(self.get(), stance));
          },
          py::arg("stance"), "Changes to a stance smoothly.")
      .def(
          "set_pose",
          [](const Character& self, const Pose& before, const Pose& now, float dt_s) {
            checked(flinch_character_set_pose(self.get(), &before.value, &now.value, dt_s));
          },
          py::arg("before"), py::arg("now"), py::arg("dt_s"),
          "Reports the pose of a character that the game animates, and that of dt_s earlier.")
      .def(
          "settle", [](const Character& self) { checked(flinch_character_settle(self.get())); },
          "Stops the response and returns to its stance smoothly.")
      .def(
          "walk",
          [](const Character& self, const MotionGraph& graph, std::uint64_t seed, float x, float y,
             float radius) {
            checked(flinch_character_walk(self.get(), graph.handle.get(), seed, x, y, radius));
          },
          py::arg("graph"), py::arg("seed"), py::arg("x") = 0.0F, py::arg("y") = 0.0F,
          py::arg("radius") = std::numeric_limits<float>::infinity(),
          "From now on it moves about by the graph, within the circle about (x, y).")
      .def(
          "update",
          [](const Character& self, float dt_s) {
            checked(flinch_character_update(self.get(), dt_s));
          },
          py::arg("dt_s"), "Advances it, s.")
      .def(
          "copy_from",
          [](const Character& self, const Character& saved) {
            checked(flinch_character_copy(self.get(), saved.get()));
          },
          py::arg("saved"), "Puts it into the state of another one; neither takes hits.")
      .def(
          "stop_reaction",
          [](const Character& self) { checked(flinch_character_stop_reaction(self.get())); },
          "Ends physics at once: the body is where its own motion has it.")
      .def("pose", &pose, "The current pose, world.")
      .def("pose_over", &pose_over, py::arg("game"), py::arg("joint"), py::arg("weight") = 1.0F,
           "The game's pose with Flinch's laid over it; weights of the 21 joints, 0 to 1.");
}

void bind_answers(CharacterClass& character) {
  character
      .def("perceive", &perceive, py::arg("threat"),
           "Predicts whether the threat hits, chooses a clip and starts the response.")
      .def("perceive", &perceive_all, py::arg("threat"),
           "Answers several threats, the most urgent one first.")
      .def("perceive_known", &perceive_known, py::arg("threat"), py::arg("target"),
           py::arg("time_to_impact_s"), "Answers a threat that is known to hit.")
      .def("look_ahead", &look_ahead, py::arg("threats"), py::arg("candidates") = 8,
           py::arg("budget_us") = py::none(),
           "Simulates the selector's best clips and answers with the one that costs least.")
      .def(
          "brace",
          [](const Character& self, const Threat& threat, bool startles) {
            return answer_of(flinch_character_brace(self.get(), &threat.value, startles ? 1 : 0));
          },
          py::arg("threat"), py::arg("startles") = false, "Answers by the pose rules.")
      .def(
          "respond",
          [](const Character& self, std::int32_t clip, float time_to_impact_s) {
            checked(flinch_character_respond(self.get(), clip, time_to_impact_s));
          },
          py::arg("clip"), py::arg("time_to_impact_s"), "Answers with this clip.")
      .def("push", &push, py::arg("joint"), py::arg("velocity"),
           "Pushes it: the joint shall move with this velocity, world, m/s.")
      .def("limit_perception", &limit_perception, py::arg("seed") = 1, py::kw_only(),
           py::arg("reaction_delay_s") = 0.0F, py::arg("bearing_noise") = 0.0F,
           py::arg("distance_noise") = 0.0F, py::arg("heading_noise") = 0.0F,
           py::arg("speed_noise") = 0.0F, py::arg("chance_to_fail") = 0.0F,
           "Makes its perception imperfect; without arguments, perfect.")
      .def("outside_training", &outside_training, py::arg("threat"),
           "The threat's numbers outside of what the library was trained for, with their range.")
      .def(
          "react_to",
          [](const Character& self, const Threat& ball) {
            checked(flinch_character_react_to(self.get(), &ball.value));
          },
          py::arg("ball"), "Hands the body to physics, because the ball is about to hit.");
}

void bind_state(CharacterClass& character) {
  character.def_property_readonly("candidates", &candidates, "What the selector considered.")
      .def_property_readonly("push_candidates", &push_candidates,
                             "The responses that the last push could have had.")
      .def_property_readonly("reaction", &reaction, "Its last reaction to a hit.")
      .def_property_readonly(
          "phase", [](const Character& self) { return flinch_phase_name(state_of(self).phase); },
          "\"idle\", \"reacting\", \"waiting\", \"shifting\", \"blending\", \"protecting\", "
          "\"returning\", \"pushed\" or \"walking\".")
      .def_property_readonly(
          "clip", [](const Character& self) { return state_of(self).clip; },
          "Index of the clip that answers, or of the idle clip; -1: by rule.")
      .def_property_readonly(
          "target", [](const Character& self) { return flinch_target_name(state_of(self).target); },
          "Of the last threat.")
      .def_property_readonly(
          "time_to_impact_s", [](const Character& self) { return state_of(self).time_to_impact_s; },
          "Negative after the impact; infinite without a threat.")
      .def_property_readonly(
          "position", [](const Character& self) { return array_of(state_of(self).position, {2}); },
          "Where it stands, or began its response, world, m: (2,).")
      .def_property_readonly(
          "facing", [](const Character& self) { return state_of(self).facing; }, "Radians.")
      .def_property_readonly("library", [](const Character& self) { return self.library; });
}

}  // namespace

void bind_character(py::module_& module) {
  CharacterClass character(module, "Character",
                           "Perceives, answers, can be hit, and returns to idle.");
  character.def(
      py::init([](std::shared_ptr<Library> library, bool reacting,
                  std::optional<float> simulation_only_s, std::optional<float> stiffness) {
        return std::make_shared<Character>(std::move(library), reacting,
                                           HitOptions{simulation_only_s, stiffness});
      }),
      py::arg("library"), py::kw_only(), py::arg("reacting") = false,
      py::arg("simulation_only_s") = py::none(), py::arg("stiffness") = py::none());
  bind_motion(character);
  bind_answers(character);
  bind_steps(character);
  bind_state(character);
  module.def("human_limits", &human_limits, py::arg("choices"),
             "The limits of a person who chooses among so many answers.");
}

}  // namespace flinch::python

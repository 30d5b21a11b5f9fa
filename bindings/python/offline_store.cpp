// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <limits>
#include <string>
#include <vector>

#include "bindings/python/arrays.h"
#include "bindings/python/offline.h"
#include "features/feature_layout.h"
#include "train/fit/feature_derivation.h"
#include "train/fit/labels.h"

namespace flinch::python {

namespace py = pybind11;

namespace {

constexpr auto kBodies = static_cast<std::size_t>(motion::kBodyCount);

/// An array with a row for each observation, of what `write(observation, row)` writes.
template <class Number, class Write>
py::array rows(const train::Store& store, const std::vector<std::size_t>& columns, Number otherwise,
               const Write& write) {
  std::vector<std::size_t> shape{store.observations.size()};
  shape.insert(shape.end(), columns.begin(), columns.end());
  Array<Number> array = make_array<Number>(shape);
  std::fill_n(array.mutable_data(), array.size(), otherwise);
  const std::size_t step = store.observations.empty()
                               ? 0
                               : static_cast<std::size_t>(array.size()) / store.observations.size();
  Number* row = array.mutable_data();
  for (const train::Observation& observation : store.observations) {
    write(observation, row);
    row += step;
  }
  py::setattr(array.attr("flags"), "writeable", py::bool_(false));
  return array;
}

void add_scenarios(const train::Store& store, py::dict& arrays) {
  using train::Observation;
  arrays["number"] = rows<std::uint64_t>(
      store, {}, 0, [](const Observation& one, std::uint64_t* to) { *to = one.number; });
  arrays["target"] = rows<std::int32_t>(store, {}, 0, [](const Observation& one, std::int32_t* to) {
    *to = static_cast<std::int32_t>(one.scenario.target);
  });
  arrays["kind"] = rows<std::int32_t>(store, {}, 0, [](const Observation& one, std::int32_t* to) {
    *to = one.scenario.threat.kind;
  });
  arrays["time_to_impact_s"] = rows<float>(
      store, {}, 0, [](const Observation& one, float* to) { *to = one.scenario.time_to_impact_s; });
  arrays["position"] = rows<float>(store, {3}, 0, [](const Observation& one, float* to) {
    std::copy_n(one.scenario.threat.position.data(), 3, to);
  });
  arrays["velocity"] = rows<float>(store, {3}, 0, [](const Observation& one, float* to) {
    std::copy_n(one.scenario.threat.velocity.data(), 3, to);
  });
  const auto features = static_cast<std::size_t>(store.header.layout.size());
  arrays["features"] =
      rows<float>(store, {features}, 0, [features](const Observation& one, float* to) {
        std::copy_n(one.features.data(), features, to);
      });
}

void add_trials(const train::Store& store, py::dict& arrays) {
  using train::Observation;
  constexpr float kNotTried = std::numeric_limits<float>::quiet_NaN();
  const std::size_t clips = store.header.clips.size();
  arrays["work_j"] = rows<float>(store, {clips}, kNotTried, [](const Observation& one, float* to) {
    for (const train::Trial& trial : one.trials) to[trial.clip] = trial.work_j;
  });
  arrays["impulse_ns"] =
      rows<float>(store, {clips, kBodies}, kNotTried, [](const Observation& one, float* to) {
        for (const train::Trial& trial : one.trials)
          std::copy_n(trial.impulse.begin(), kBodies,
                      to + static_cast<std::size_t>(trial.clip) * kBodies);
      });
}

/// The best clips (n,), and the costs of all clips (n, clips), not a number where not tried.
py::tuple label(const Scenarios& scenarios, double brawn, const std::string& vulnerability) {
  const train::Store& store = scenarios.store;
  const train::Labels labels =
      train::label(store.observations, cost_model_of(scenarios, brawn, vulnerability));
  std::size_t i = 0;
  py::array costs =
      rows<double>(store, {store.header.clips.size()}, std::numeric_limits<double>::quiet_NaN(),
                   [&](const train::Observation& one, double* to) {
                     for (std::size_t k = 0; k < one.trials.size(); ++k)
                       to[one.trials[k].clip] = labels.cost[i][k];
                     ++i;
                   });
  return py::make_tuple(array_of(labels.clip.data(), {labels.clip.size()}), costs);
}

}  // namespace

Scenarios::Scenarios(const std::filesystem::path& path, const std::string& features)
    : feature_set(features), store(train::read_store(path.string())) {
  if (features::feature_set_named(features) == nullptr)
    throw py::value_error("there is no set of features " + features);
  derive_features(train::layout_for(features, store.header), store);
  add_scenarios(store, arrays);
  add_trials(store, arrays);
}

train::CostModel cost_model_of(const Scenarios& scenarios, double brawn,
                               const std::string& vulnerability) {
  if (!(brawn >= 0 && brawn <= 1)) throw py::value_error("brawn must be from 0 to 1");
  return train::make_cost_model(scenarios.store.header, train::find_vulnerability(vulnerability),
                                brawn);
}

void bind_store(py::module_& module) {
  const train::CostModel usual;
  py::class_<Scenarios, std::shared_ptr<Scenarios>> store(
      module, "Store", "The observations of a store, as arrays with one row per scenario.");
  store
      .def(py::init<const std::filesystem::path&, const std::string&>(), py::arg("path"),
           py::arg("features") = std::string(features::feature_sets().front().name),
           "Reads a store; `features` names the set that selectors shall see.")
      .def("__len__", [](const Scenarios& self) { return self.store.observations.size(); })
      .def("label", &label, py::arg("brawn") = usual.brawn,
           py::arg("vulnerability") = usual.vulnerability_name,
           "The best clips (n,), and the costs of all clips (n, clips), N s, nan if not tried.")
      .def_property_readonly("feature_names",
                             [](const Scenarios& self) { return self.store.header.layout.names(); })
      .def_property_readonly("clips",
                             [](const Scenarios& self) {
                               std::vector<std::string> names;
                               for (const models::ClipSummary& clip : self.store.header.clips)
                                 names.push_back(clip.name);
                               return names;
                             })
      .def_property_readonly("idle", [](const Scenarios& self) { return self.store.header.idle; })
      .def_property_readonly("seed", [](const Scenarios& self) { return self.store.header.seed; })
      .def_property_readonly("library",
                             [](const Scenarios& self) { return self.store.header.library_name; })
      .def_property_readonly(
          "provenance",
          [](const Scenarios& self) { return provenance_object(self.store.header.provenance); },
          "How it was made; None if that is not recorded.");
  for (const char* name : {"number", "target", "kind", "time_to_impact_s", "position", "velocity",
                           "features", "work_j", "impulse_ns"})
    store.def_property_readonly(
        name, [name](const Scenarios& self) { return self.arrays[name].cast<py::array>(); });
}

}  // namespace flinch::python

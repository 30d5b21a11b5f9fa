// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings/python/arrays.h"
#include "bindings/python/long_work.h"
#include "bindings/python/offline.h"
#include "train/fit/selector_writer.h"
#include "train/fit/training.h"
#include "train/report/comparison.h"
#include "train/report/selector_record.h"

namespace flinch::python {

namespace py = pybind11;

namespace {

/// A selector that was fitted, with the store that it belongs to.
struct FittedSelector {
  train::SelectorChoice choice;
  train::Training training;
  std::shared_ptr<const Scenarios> scenarios;
};

train::Method method_of(const std::string& name) {
  if (const std::optional<train::Method> method = train::method_named(name)) return *method;
  std::string known;
  for (const train::Method method : train::methods())
    known += (known.empty() ? "" : ", ") + std::string(train::name_of(method));
  throw py::value_error("there is no model " + name + "; it is one of " + known);
}

FittedSelector fit(std::shared_ptr<const Scenarios> scenarios, const std::string& model,
                   double brawn, const std::string& vulnerability,
                   std::optional<std::uint64_t> seed, const train::FixedParameters& fixed,
                   const py::object& progress) {
  const train::Method method = method_of(model);
  const train::CostModel cost_model = cost_model_of(*scenarios, brawn, vulnerability);
  const train::Store& store = scenarios->store;
  FittedSelector fitted{{.method = method,
                         .feature_set = scenarios->feature_set,
                         .brawn = brawn,
                         .vulnerability = vulnerability,
                         .seed = seed,
                         .fixed = fixed},
                        {},
                        scenarios};
  run_interruptibly(progress, [&](WorkMonitor& monitor) {
    monitor.tell({"fitting " + model});
    fitted.training = train::train_selector(store.header, store.observations, cost_model, method,
                                            seed.value_or(store.header.seed), fixed);
  });
  return fitted;
}

train::SelectorRecord record_of(const FittedSelector& self) {
  return train::make_selector_record(self.choice, self.scenarios->store, self.training);
}

void save_selector(const FittedSelector& self, const std::filesystem::path& path, bool force) {
  database::check_outputs({{path.string(), database::FileKind::selector, ""}}, {},
                          force ? database::Overwrite::force : database::Overwrite::refuse);
  const train::SelectorRecord record = record_of(self);
  train::write_selector(self.training.selector, self.scenarios->store.header.library_file, &record,
                        path.string());
}

py::dict parameters_of(const FittedSelector& self) {
  py::dict parameters;
  for (const train::NamedValue& parameter : self.training.parameter_values)
    parameters[py::str(parameter.name)] = py::cast(parameter.value);
  return parameters;
}

/// The clip for each row of features and its target.
Array<std::int32_t> choose(const FittedSelector& self, const Array<float>& features,
                           const py::object& targets) {
  const models::Selector& selector = self.training.selector;
  const Array<std::int64_t> target = whole_numbers(targets, "target");
  const auto count = static_cast<std::size_t>(target.size());
  const auto width = static_cast<std::size_t>(selector.layout.size());
  require_shape(target, {count}, "target");
  require_shape(features, {count, width}, "features");
  if (std::any_of(target.data(), target.data() + count,
                  [](std::int64_t one) { return one < 0 || one >= motion::kTargetCount; }))
    throw py::value_error("target must hold indices of TARGETS");
  Array<std::int32_t> clips = make_array<std::int32_t>({count});
  features::FeatureVector x{};
  for (std::size_t i = 0; i < count; ++i) {
    std::copy_n(features.data() + i * width, width, x.begin());
    clips.mutable_data()[i] =
        models::select(selector, x, static_cast<motion::Target>(target.data()[i]));
  }
  return clips;
}

double now_s() {
  using Seconds = std::chrono::duration<double>;
  return Seconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

py::object compare(const std::filesystem::path& store,
                   const std::optional<std::filesystem::path>& test,
                   const std::vector<std::string>& models, const std::string& features,
                   double brawn, const std::string& vulnerability, bool curves, bool transfer,
                   bool ablation, const py::object& progress) {
  if (features::feature_set_named(features) == nullptr)
    throw py::value_error("there is no set of features " + features);
  train::ComparisonPlan plan;
  plan.feature_set = features;
  for (const std::string& model : models) method_of(model);
  for (const train::Method method : train::methods())  // in the order of flinch compare's rows
    if (models.empty() || std::ranges::find(models, train::name_of(method)) != models.end())
      plan.methods.push_back(method);
  plan.brawn = brawn;
  plan.vulnerability = train::find_vulnerability(vulnerability);
  plan.vulnerability_choice = vulnerability;
  plan.curves = curves;
  plan.transfer = transfer;
  plan.ablation = ablation;
  plan.clock = now_s;
  std::string text;
  run_interruptibly(progress, [&](WorkMonitor& monitor) {
    plan.progress = [&](const std::string& what) { monitor.tell({"fitting " + what}); };
    const train::Comparison comparison =
        train::compare_methods(store.string(), test ? test->string() : "", plan);
    nlohmann::ordered_json document = train::report_document(comparison.report);
    document["timing"] = train::timing_document(comparison.report.evaluation);
    text = document.dump();
  });
  return py::module_::import("json").attr("loads")(text);
}

}  // namespace

void bind_training(py::module_& module) {
  const train::CostModel usual;
  py::class_<FittedSelector>(module, "Selector", "A selector that was fitted to a store.")
      .def("save", &save_selector, py::arg("path"), py::arg("force") = false,
           "Writes the file that Library loads; force replaces a file of another kind.")
      .def("choose", &choose, py::arg("features"), py::arg("target"),
           "The clip (n,) for each row of features (n, features) and target (n,).")
      .def_property_readonly("parameters", &parameters_of)
      .def_property_readonly(
          "provenance",
          [](const FittedSelector& self) { return provenance_object(record_of(self).provenance); },
          "How it was made, as its file tells.")
      .def_property_readonly("cross_validated_regret_ns", [](const FittedSelector& self) {
        return self.training.cross_validated_regret_ns;
      });
  module.def(
      "fit",
      [](std::shared_ptr<Scenarios> store, const std::string& model, double brawn,
         const std::string& vulnerability, std::optional<std::uint64_t> seed, std::optional<int> k,
         std::optional<double> c, std::optional<double> gamma, std::optional<int> degree,
         std::optional<double> coef0, bool libsvm_defaults, const py::object& progress) {
        return fit(std::move(store), model, brawn, vulnerability, seed,
                   {k, c, gamma, degree, coef0, libsvm_defaults}, progress);
      },
      py::arg("store"), py::arg("model") = std::string(train::name_of(train::kDefaultMethod)),
      py::kw_only(), py::arg("brawn") = usual.brawn,
      py::arg("vulnerability") = usual.vulnerability_name, py::arg("seed") = py::none(),
      py::arg("k") = py::none(), py::arg("c") = py::none(), py::arg("gamma") = py::none(),
      py::arg("degree") = py::none(), py::arg("coef0") = py::none(),
      py::arg("libsvm_defaults") = false, py::arg("progress") = py::none(),
      "Fits a selector, as flinch train does; cross-validation chooses what is not given.");
  module.def("compare", &compare, py::arg("store"), py::arg("test") = py::none(), py::kw_only(),
             py::arg("models") = std::vector<std::string>{},
             py::arg("features") = std::string(features::feature_sets().front().name),
             py::arg("brawn") = usual.brawn, py::arg("vulnerability") = usual.vulnerability_name,
             py::arg("curves") = false, py::arg("transfer") = false, py::arg("ablation") = false,
             py::arg("progress") = py::none(),
             "Compares selectors on the same scenarios: the document of flinch compare --json.");
  py::list names;
  for (const train::Method method : train::methods())
    names.append(std::string(train::name_of(method)));
  module.attr("MODELS") = py::tuple(names);
}

}  // namespace flinch::python

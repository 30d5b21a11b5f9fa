// SPDX-License-Identifier: MIT
#include <omp.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <string>

#include "bindings/python/long_work.h"
#include "bindings/python/offline.h"
#include "database/files/file_kind.h"
#include "database/files/library_writer.h"
#include "train/scenario/threat_file.h"
#include "train/simulate/simulate.h"

namespace flinch::python {

namespace py = pybind11;

namespace {

struct Request {
  std::string library;
  std::string store;
  std::uint64_t first = 0;
  std::uint64_t scenarios = 0;
  std::string threats;
  std::uint64_t seed = 1;
  std::optional<int> threads;
  std::uint64_t memory_bytes = 0;
  database::Overwrite overwrite = database::Overwrite::refuse;
};

train::SimulationProgress run_request(const Request& request, WorkMonitor& monitor) {
  train::SimulationPlan plan;
  plan.distribution = train::find_threats(request.threats);
  plan.threats = request.threats;
  plan.seed = request.seed;
  const database::ClipLibrary library = database::load_library(request.library);
  const train::SimulationSetup setup(library, plan);
  train::SimulationRun run;
  run.wanted = {request.first, request.scenarios};
  run.batch.threads = request.threads.value_or(omp_get_num_procs());
  run.batch.stop = &monitor.stop();
  run.memory = train::plan_memory(setup, request.memory_bytes, run.batch.threads);
  run.overwrite = request.overwrite;
  train::SimulationProgress last;
  run.report = [&](const train::SimulationProgress& progress) {
    last = progress;
    if (!monitor.stop())  // the run itself ends in good order
      monitor.tell({"simulating scenarios", progress.scenarios, progress.wanted});
  };
  train::simulate_store(setup, request.store, run);
  return last;
}

py::dict simulate(const std::filesystem::path& library, const std::filesystem::path& store,
                  std::uint64_t scenarios, const std::string& threats, std::uint64_t seed,
                  std::uint64_t first, std::optional<int> threads, std::uint64_t memory_bytes,
                  bool force, const py::object& progress) {
  const Request request{library.string(),
                        store.string(),
                        first,
                        scenarios,
                        threats,
                        seed,
                        threads,
                        memory_bytes,
                        force ? database::Overwrite::force : database::Overwrite::refuse};
  const std::string threat_file = database::names_toml_file(threats) ? threats : "";
  database::check_outputs({train::store_output(request.store)}, {request.library, threat_file},
                          request.overwrite);
  train::SimulationProgress last;
  run_interruptibly(progress, [&](WorkMonitor& monitor) { last = run_request(request, monitor); });
  py::dict counts;
  counts["scenarios"] = last.scenarios;
  counts["simulations"] = last.counts.simulations;
  counts["skipped"] = last.counts.skipped;
  counts["hits"] = last.counts.hits;
  counts["steps"] = last.counts.steps;
  return counts;
}

}  // namespace

void bind_simulation(py::module_& module) {
  module.def(
      "simulate", &simulate, py::arg("library"), py::arg("store"), py::arg("scenarios"),
      py::kw_only(), py::arg("threats") = std::string(train::threat_files().front().name),
      py::arg("seed") = 1, py::arg("first") = 0, py::arg("threads") = py::none(),
      py::arg("memory_bytes") = train::MemoryPlan{}.max_bytes, py::arg("force") = false,
      py::arg("progress") = py::none(),
      "Tries every allowed clip of a library file on random scenarios, as flinch simulate does, "
      "byte for byte. Ctrl-C keeps what is finished; the same call continues.");
}

}  // namespace flinch::python

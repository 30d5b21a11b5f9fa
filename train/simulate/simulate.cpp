// SPDX-License-Identifier: MIT
#include "train/simulate/simulate.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <span>

#include "database/files/file_kind.h"
#include "database/files/library_writer.h"
#include "database/files/provenance.h"
#include "database/library/content_hash.h"
#include "database/library/file_header.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "sim/contact/next_step.h"
#include "train/simulate/scenario_scheduler.h"
#include "train/simulate/worker_pool.h"
#include "train/store/file_opening.h"
#include "train/store/store_places.h"
#include "train/store/store_trials.h"

namespace flinch::train {

namespace {

/// Scenarios per thread that are simulated before a commit: about a quarter of a second of work.
constexpr std::uint64_t kBatchSize = 128;
/// The same if responses must be rehearsed again for every batch. A batch that ends is in the
/// store, so the largest is of some twenty seconds of work.
constexpr std::uint64_t kMinUncachedBatchSize = 1024;
constexpr std::uint64_t kMaxUncachedBatchSize = 8192;
/// Then the second batch is already as large as it may be. The first, a small one, soon tells the
/// rate.
constexpr std::uint64_t kUncachedGrowth = 8192;

RangeSizes range_sizes(const MemoryPlan& memory) {
  return {memory.batch_size, memory.keeps_all() ? 1 : kUncachedGrowth};
}

using Json = nlohmann::ordered_json;

/// A number where a range is one.
Json document_of(const ValueRange& range) {
  if (range.min == range.max) return range.min;
  return {range.min, range.max};
}

Json degrees_of(const ValueRange& radians) {
  return {motion::degrees(radians.min), motion::degrees(radians.max)};
}

void add_rod(const ThreatKind& kind, Json& document) {
  const features::RodRanges& rod = kind.rod;
  document["length_m"] = document_of(rod.length_m);
  document["strikes_at"] = document_of(rod.strikes_at);
  document["tilt_degrees"] = degrees_of(rod.tilt);
  document["balance"] = rod.balance;
  if (kind.is_driven()) {
    document["grip_share"] = document_of(rod.grip_share);
    document["grip_mass_kg"] = rod.grip_mass_kg;
  } else {
    document["spin_per_s"] = document_of(
        ValueRange{rod.spin.min / (2 * std::numbers::pi), rod.spin.max / (2 * std::numbers::pi)});
  }
}

Json document_of(const ThreatKind& kind) {
  Json azimuth = Json::array();
  for (const ValueRange& sector : kind.azimuth) azimuth.push_back(degrees_of(sector));
  Json targets;
  for (const motion::Target target : motion::kTargets)
    targets[std::string(motion::name_of(target))] = kind.target_weight[target];
  Json document{{"name", kind.name},
                {"weight", kind.weight},
                {"radius_m", document_of(kind.radius_m)},
                {"mass_kg", document_of(kind.mass_kg)},
                {"speed_mps", document_of(kind.speed_mps)},
                {"azimuth_degrees", azimuth},
                {"elevation_degrees", degrees_of(kind.elevation)},
                {"time_to_impact_s", document_of(kind.time_to_impact_s)},
                {"targets", targets},
                {"aim_radius_m", kind.aim_radius_m},
                {"restitution", kind.bounce.restitution},
                {"friction", kind.bounce.friction},
                {"flight", kind.falls ? "falling" : "straight"}};
  if (kind.shape != features::ThreatShape::ball) document["shape"] = name_of(kind.shape);
  if (kind.is_driven()) document["reach_m"] = document_of(kind.reach_m);
  if (kind.shape == features::ThreatShape::rod) add_rod(kind, document);
  return document;
}

/// Says how long the steps of resting contacts are where there may be any: all other threats have
/// the results of the laws before these.
std::string describe(const SimulationPlan& plan) {
  Json document{{"law_version", sim::kLawVersion},
                {"free_step_s", plan.options.free_step_s},
                {"contact_step_s", plan.options.contact_step_s},
                {"gravity_mps2", plan.options.gravity_mps2},
                {"tail_s", plan.tail_s},
                {"unabridged", plan.unabridged}};
  const bool may_rest = std::ranges::any_of(plan.distribution.kinds, [](const ThreatKind& kind) {
    return kind.bounce.restitution <= sim::kMaxRestingBounce;
  });
  if (may_rest) document["resting_step_s"] = plan.options.resting_step_s;
  if (plan.options.figure == sim::FigureKind::waist_up) document["figure"] = "waist_up";
  return document.dump();
}

/// Returns about how much memory all rehearsed responses take. Each second of a response takes as
/// much as a second of idling.
std::uint64_t bytes_of_all_responses(const SimulationSetup& setup) {
  const RehearsedResponse idle = rehearse(setup, setup.responses.key_of(setup.library.idle, {}));
  double seconds = 0;
  for (int time = 0; time < time_to_impact_count(setup.plan.distribution); ++time) {
    const double performed_s =
        double{time_to_impact_s(setup.plan.distribution, time)} + setup.plan.tail_s;
    seconds += static_cast<double>(setup.responses.count_at(time)) * performed_s;
  }
  return static_cast<std::uint64_t>(seconds / idle.rehearsal.duration_s() *
                                    static_cast<double>(idle.byte_count()));
}

/// Returns about how much memory a scenario of a batch takes: the mean of the first few.
std::uint64_t scenario_bytes(const SimulationSetup& setup) {
  constexpr std::uint64_t kCount = 64;
  std::size_t trials = 0;
  for (std::uint64_t number = 0; number < kCount; ++number)
    trials += make_observation(setup, number).trials.size();
  const std::size_t places = setup.plan.options.keeps_places ? kBatchBytesOfPlaces : 0;
  return sizeof(Observation) + (trials * (kBatchBytesPerTrial + places)) / kCount;
}

/// Returns a hash of everything that must be the same in all processes of a run.
std::uint64_t hash_of_run(const StoreHeader& header) {
  const std::string text = database::hash_text(header.library_hash) + " " +
                           std::to_string(header.seed) + " " + header.distribution + " " +
                           header.simulation + (header.keeps_places ? " places" : "");
  return database::content_hash(std::as_bytes(std::span(text)));
}

/// Writes the results and reports the progress.
class ResultWriter {
 public:
  /// A null writer means that the store is complete and take() must not be called.
  ResultWriter(const SimulationSetup& setup, StoreWriter* writer, const SimulationRun& run)
      : setup_(setup), writer_(writer), run_(run) {
    progress_.wanted = run.wanted.count;
    report();
  }

  void take(const Batch& batch) { write(batch.observations, batch.counts, batch.cpu); }

  void take(const RangeResult& done) {
    std::vector<Observation> observations;
    for (std::uint64_t i = 0; i < done.range.count; ++i) {
      observations.push_back(make_observation(setup_, done.range.first + i));
      observations.back().trials = decode_trials(done.trials[i]);
      observations.back().places = decode_places(done.places[i]);
    }
    write(observations, done.counts, done.cpu);
  }

 private:
  void write(const std::vector<Observation>& observations, const SimulationCounts& counts,
             const PhaseTimes& cpu) {
    const double begin_s = run_.batch.cpu_s();
    writer_->append(observations);
    progress_.counts.add(counts);
    progress_.cpu.add(cpu);
    progress_.cpu.writing_s += run_.batch.cpu_s() - begin_s;
    report();
  }

  void report() {
    progress_.scenarios = writer_ ? writer_->count() : run_.wanted.count;
    run_.report(progress_);
  }

  const SimulationSetup& setup_;
  StoreWriter* writer_;
  const SimulationRun& run_;
  SimulationProgress progress_;
};

bool is_finished(const std::string& path, const StoreHeader& header, const SimulationRun& run) {
  if (!std::filesystem::is_regular_file(path)) return false;
  if (run.overwrite == database::Overwrite::force &&
      file_kind_at(path) != database::FileKind::store)
    return false;
  const StoreSummary finished = summarise_store(path);
  require_same_run(finished.header, header, path);
  return finished.holds(run.wanted);
}

}  // namespace

std::string describe(const ScenarioDistribution& distribution) {
  Json kinds = Json::array();
  for (const ThreatKind& kind : distribution.kinds) kinds.push_back(document_of(kind));
  Json document{{"kinds", kinds},
                {"time_to_impact_step_s", distribution.time_to_impact_step_s},
                {"character_states", state_count(distribution)}};
  if (distribution.has_stances()) {
    for (const StanceShare& share : distribution.stances)
      document["stances"].push_back({{"name", share.name}, {"weight", share.weight}});
  }
  return document.dump();
}

namespace {

/// The stances with their weights, as --stances has them.
std::string text_of(std::span<const StanceShare> stances) {
  std::string text;
  for (const StanceShare& share : stances) {
    if (!text.empty()) text += ' ';
    text += database::word_of(share.name) + '=' + database::option_text(share.weight);
  }
  return text;
}

/// How the store is made: without the range of scenarios, so that parts of a run and the whole of
/// it agree.
std::string provenance_of(const SimulationSetup& setup, std::uint64_t library_hash) {
  const SimulationPlan& plan = setup.plan;
  const bool is_file = database::names_toml_file(plan.threats);
  database::Provenance made{.command = "simulate", .seed = plan.seed};
  if (!is_file) add_option("threats", plan.threats, SimulationPlan{}.threats, made);
  if (plan.distribution.has_stances())
    made.options.emplace_back("stances", text_of(plan.distribution.stances));
  add_option("reference", plan.unabridged, false, made);
  add_option("places", plan.options.keeps_places, false, made);
  if (plan.options.figure == sim::FigureKind::waist_up)
    made.options.emplace_back("figure", "waist_up");
  made.inputs.push_back({"library", "", library_hash, setup.library.provenance});
  if (is_file) add_inputs("threats", {plan.threats}, made);
  return database::provenance_text(made);
}

}  // namespace

StoreHeader make_store_header(const SimulationSetup& setup) {
  const database::ClipLibrary& library = setup.library;
  StoreHeader header;
  const std::string file = database::bare_library_bytes(library);
  const auto bytes = std::as_bytes(std::span(file));
  header.library_file.assign(bytes.begin(), bytes.end());
  header.library_hash = database::verify_file(database::kLibraryFormat, bytes).hash;
  header.library_name = library.name;
  header.seed = setup.plan.seed;
  header.distribution = describe(setup.plan.distribution);
  header.simulation = describe(setup.plan);
  header.keeps_places = setup.plan.options.keeps_places;
  if (setup.plan.distribution.has_stances()) header.stances = stance_names(library);
  header.kinds.clear();
  for (const ThreatKind& kind : setup.plan.distribution.kinds) header.kinds.push_back(kind);
  header.reference_impulse_ns = largest_impulse_ns(setup.plan.distribution);
  header.idle = library.idle;
  for (int clip = 0; clip < static_cast<int>(library.clips.size()); ++clip) {
    const motion::Clip& source = library.clip(clip);
    const bool answers = source.purpose == motion::Purpose::anticipation && clip != library.idle;
    header.clips.push_back({source.name, answers ? source.annotation : std::nullopt});
    header.clip_work_j.push_back(answers ? reference_work_j(setup, clip) : 0);
  }
  header.reference_work_j = *std::ranges::max_element(header.clip_work_j);
  if (!(header.reference_work_j > 0))
    throw Error("", "the library " + library.name +
                        " has no annotated clip that moves; annotate its clips in the manifest "
                        "and import again");
  const motion::Motion& idle = library.idle_clip().motion;
  header.idle_target_centres = target_centres_in_character_frame(
      library.character.skeleton, setup.body_model, idle.poses.front());
  return header;
}

MemoryPlan plan_memory(const SimulationSetup& setup, std::uint64_t max_bytes, int threads) {
  // Memory of the program with a library of a few hundred clips, and, per thread, of a batch, a
  // response being rehearsed and a world. tests/bench measures them.
  constexpr std::uint64_t kProgramMebibytes = 64;
  constexpr std::uint64_t kThreadMebibytes = 16;
  constexpr int kMebibyteShift = 20;
  const auto each = static_cast<std::uint64_t>(threads);
  const std::uint64_t reserved_bytes = (kProgramMebibytes + kThreadMebibytes * each)
                                       << kMebibyteShift;
  if (max_bytes < reserved_bytes)
    throw Error("", std::to_string(max_bytes >> kMebibyteShift) +
                        " MiB of memory are too little for " + std::to_string(threads) +
                        " threads; give at least --memory " +
                        std::to_string(reserved_bytes >> kMebibyteShift) + "M");
  MemoryPlan plan;
  plan.max_bytes = max_bytes;
  plan.response_count = setup.responses.count();
  plan.all_response_bytes = bytes_of_all_responses(setup);
  plan.response_bytes = max_bytes - reserved_bytes;
  plan.batch_size = kBatchSize;
  if (plan.keeps_all()) return plan;
  // With R bytes of responses, of which c are kept, and batches of b bytes, N scenarios of s bytes
  // each cost N s / b times the rehearsing of R - c. For a given sum M of b and c that is
  // proportional to (R - M + b) / b, which falls as b rises: memory is worth most in batches.
  const std::uint64_t step_bytes = each * scenario_bytes(setup);  // a scenario more per thread
  const std::uint64_t more =
      std::min(plan.response_bytes / step_bytes, kMaxUncachedBatchSize - kMinUncachedBatchSize);
  plan.batch_size = kMinUncachedBatchSize + more;
  plan.response_bytes -= more * step_bytes;
  return plan;
}

bool simulate_store(const SimulationSetup& setup, const std::string& path,
                    const SimulationRun& run) {
  StoreHeader header = make_store_header(setup);
  header.provenance = provenance_of(setup, header.library_hash);
  SingleProcessMessenger nobody;
  Messenger& messenger = run.messenger ? *run.messenger : nobody;
  std::optional<StoreWriter> writer;
  std::vector<ScenarioRange> missing;
  if (is_finished(path, header, run)) {
    StoreWriter::remove_left_overs(path);
  } else {
    writer.emplace(path, header, run.wanted, run.overwrite);
    missing = writer->missing();
  }
  ScenarioScheduler ranges(missing, messenger.size(), range_sizes(run.memory));
  ResultWriter result_writer(setup, writer ? &*writer : nullptr, run);
  WorkerPool pool(messenger,
                  {[&](int threads) { return ranges.next(threads); },
                   [&](const RangeResult& done) { result_writer.take(done); },
                   [&](ScenarioRange range) { ranges.put_back(range); }},
                  hash_of_run(header));
  RehearsalCache rehearsals(run.memory.response_bytes);
  BatchContext context = run.batch;
  context.poll = [&pool] { pool.poll(); };
  for (;;) {
    if (context.stop != nullptr && *context.stop) return false;
    pool.poll();
    if (const auto range = ranges.next(context.threads)) {
      Batch batch;
      if (!simulate_batch(setup, rehearsals, *range, context, batch)) return false;
      result_writer.take(batch);
    } else if (pool.has_active_workers()) {
      pool.wait();
    } else {
      break;
    }
  }
  if (writer) writer->finish();
  return true;
}

void run_simulation_worker(const SimulationSetup& setup, const SimulationRun& run) {
  RehearsalCache rehearsals(run.memory.response_bytes);
  const auto simulate = [&](ScenarioRange range) -> std::optional<RangeResult> {
    Batch batch;
    if (!simulate_batch(setup, rehearsals, range, run.batch, batch)) return std::nullopt;
    RangeResult done{range, batch.counts, batch.cpu, {}, {}};
    for (const Observation& observation : batch.observations) {
      done.trials.push_back(encode_trials(observation.trials));
      done.places.push_back(encode_places(observation.places));
    }
    return done;
  };
  run_worker(*run.messenger, hash_of_run(make_store_header(setup)), run.batch.threads, simulate);
}

}  // namespace flinch::train

// SPDX-License-Identifier: MIT
#include "train/fit/selector_writer.h"

#include <cstdint>
#include <span>
#include <vector>

#include "database/files/file_io.h"
#include "motion/error.h"
#include "runtime/response/prepared_library.h"
#include "runtime/selector_file.h"
#include "selector_generated.h"

namespace flinch::train {
namespace {

namespace schema = runtime::schema;
using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

// Stores one part per statement: the compiler chooses the order in which a call's arguments are
// evaluated, and the bytes must not depend on it.
Offset<schema::Clip> store(FlatBufferBuilder& builder, const models::ClipSummary& clip) {
  const auto name = builder.CreateString(clip.name);
  Offset<schema::Annotation> annotation;
  if (clip.annotation) {
    annotation = schema::CreateAnnotation(
        builder, static_cast<std::uint8_t>(clip.annotation->target),
        static_cast<std::uint8_t>(clip.annotation->degree), clip.annotation->direction,
        clip.annotation->onset_s, clip.annotation->peak_s, clip.annotation->end_s);
  }
  return schema::CreateClip(builder, name, annotation);
}

Offset<void> store(FlatBufferBuilder& builder, const models::SvmModel& model) {
  const auto label = builder.CreateVector(model.label);
  const auto vectors_of_class = builder.CreateVector(model.vectors_of_class);
  const auto bound = builder.CreateVector(model.bound);
  const auto support_vectors = builder.CreateVector(model.support_vectors);
  std::vector<double> rhos;
  std::vector<std::uint16_t> all_counts;
  for (const models::SvmMachine& machine : model.machines) {
    rhos.push_back(machine.rho);
    all_counts.insert(all_counts.end(), machine.count.begin(), machine.count.end());
  }
  const auto rho = builder.CreateVector(rhos);
  const auto counts = builder.CreateVector(all_counts);
  const auto vectors = builder.CreateVector(model.vectors);
  const auto coefficients = builder.CreateVector(model.coefficients);
  return schema::CreateSvm(builder, static_cast<std::uint8_t>(model.kernel), model.degree,
                           model.gamma, model.coef0, model.cost, label, vectors_of_class, bound,
                           support_vectors, rho, counts, vectors, coefficients)
      .Union();
}

Offset<void> store(FlatBufferBuilder& builder, const models::KnnModel& model) {
  const auto points = builder.CreateVector(model.points);
  const auto label = builder.CreateVector(model.label);
  Offset<flatbuffers::Vector<std::uint16_t>> cost;
  if (!model.cost.empty()) cost = builder.CreateVector(model.cost);
  return schema::CreateKnn(builder, model.k, static_cast<std::uint8_t>(model.vote), points, label,
                           cost, model.cost_step_ns)
      .Union();
}

Offset<void> store(FlatBufferBuilder& builder, const models::NetworkModel& model) {
  const auto clip = builder.CreateVector(model.clip);
  const auto weights = builder.CreateVector(model.weights);
  return schema::CreateNetwork(builder, model.hidden_count, model.member_count, clip,
                               model.mean_root, model.scale_root, model.variance_ns, weights)
      .Union();
}

Offset<void> store(FlatBufferBuilder& builder, const models::PairwiseModel& model) {
  const auto clip = builder.CreateVector(model.clip);
  const auto machine = builder.CreateVector(model.machine);
  const auto weights = builder.CreateVector(model.weights);
  return schema::CreatePairwiseLinear(builder, clip, machine, weights).Union();
}

schema::Model kind_of(const models::SvmModel&) {
  return schema::Model::Svm;
}

schema::Model kind_of(const models::KnnModel&) {
  return schema::Model::Knn;
}

schema::Model kind_of(const models::NetworkModel&) {
  return schema::Model::Network;
}

schema::Model kind_of(const models::PairwiseModel&) {
  return schema::Model::PairwiseLinear;
}

Offset<schema::ResponseCosts> store(FlatBufferBuilder& builder,
                                    const models::ResponseCosts& costs) {
  const auto vulnerability =
      builder.CreateVector(costs.vulnerability.data(), costs.vulnerability.size());
  const auto work = builder.CreateVector(costs.work_j);
  Offset<flatbuffers::String> name;
  if (!costs.vulnerability_name.empty()) name = builder.CreateString(costs.vulnerability_name);
  const std::vector<double>& damages_ns = costs.reference_damage_ns;
  Offset<flatbuffers::Vector<double>> damages;
  if (damages_ns.size() > 1) damages = builder.CreateVector(damages_ns);
  std::vector<Offset<schema::KindVulnerability>> own;
  for (const features::KindVulnerability& table : costs.of_kind)
    own.push_back(schema::CreateKindVulnerability(
        builder, table.kind,
        builder.CreateVector(table.vulnerability.data(), table.vulnerability.size())));
  Offset<flatbuffers::Vector<Offset<schema::KindVulnerability>>> of_kind;
  if (!own.empty()) of_kind = builder.CreateVector(own);
  std::vector<Offset<schema::StanceWork>> from;
  for (const models::StanceWork& table : costs.of_stance)
    from.push_back(schema::CreateStanceWork(builder, table.stance, table.phase_count,
                                            builder.CreateVector(table.work_j)));
  Offset<flatbuffers::Vector<Offset<schema::StanceWork>>> of_stance;
  if (!from.empty()) of_stance = builder.CreateVector(from);
  return schema::CreateResponseCosts(
      builder, vulnerability, damages_ns.front(), costs.reference_work_j, work, costs.phase_count,
      costs.time_count, costs.min_time_s, costs.time_step_s, name, damages, of_kind, of_stance);
}

Offset<schema::Kind> store(FlatBufferBuilder& builder, const features::KnownKind& kind) {
  const auto name = builder.CreateString(kind.name);
  const features::KindNumbers of_kind = features::numbers_of(kind);
  const auto numbers = builder.CreateVector(of_kind.data(), of_kind.size());
  Offset<flatbuffers::Vector<double>> rod;
  if (kind.rod != features::RodRanges{}) {
    const features::RodNumbers of_rod = features::numbers_of(kind.rod);
    rod = builder.CreateVector(of_rod.data(), of_rod.size());
  }
  return schema::CreateKind(builder, name, numbers, kind.falls,
                            static_cast<std::uint8_t>(kind.shape), kind.reach_m.min,
                            kind.reach_m.max, rod);
}

Offset<schema::Realism> store(FlatBufferBuilder& builder, const models::RealismModel& realism) {
  const auto judge = builder.CreateString(realism.judge);
  const auto mean = builder.CreateVector(realism.mean);
  const auto basis = builder.CreateVector(realism.basis);
  const auto weight = builder.CreateVector(realism.weight.data(), realism.weight.size());
  const auto points = builder.CreateVector(realism.points);
  const auto quality = builder.CreateVector(realism.quality);
  using Numbers = Offset<flatbuffers::Vector<float>>;
  Numbers theta_weight, theta_points, theta;
  if (realism.theta) {
    theta_weight = builder.CreateVector(realism.theta->weight.data(), realism.theta->weight.size());
    theta_points = builder.CreateVector(realism.theta->points);
    theta = builder.CreateVector(realism.theta->theta);
  }
  return schema::CreateRealism(builder, judge, mean, basis, weight, points, quality,
                               realism.max_distance, theta_weight, theta_points, theta);
}

// Stores the library at a multiple of 16 bytes, so that it can be read in place.
Offset<flatbuffers::Vector<std::uint8_t>> store(FlatBufferBuilder& builder,
                                                std::span<const std::byte> library_file) {
  builder.ForceVectorAlignment(library_file.size(), 1, 16);
  return builder.CreateVector(reinterpret_cast<const std::uint8_t*>(library_file.data()),
                              library_file.size());
}

Offset<schema::Training> store(FlatBufferBuilder& builder, const SelectorRecord& record) {
  const auto parameters = builder.CreateString(record.parameters);
  const auto distribution = builder.CreateString(record.distribution);
  const auto simulation = builder.CreateString(record.simulation);
  return schema::CreateTraining(builder, record.scenarios, parameters,
                                record.cross_validated_regret_ns, record.idle_regret_ns,
                                distribution, simulation);
}

Offset<schema::Footwork> store(FlatBufferBuilder& builder,
                               const std::vector<runtime::Footwork>& footwork) {
  std::vector<float> times_s;
  std::vector<std::uint32_t> counts;
  std::vector<std::uint8_t> support;
  for (const runtime::Footwork& of_clip : footwork) {
    for (const motion::Side side : motion::kSides) {
      counts.push_back(static_cast<std::uint32_t>(of_clip.swings[side].size()));
      for (const runtime::Swing& swing : of_clip.swings[side]) {
        times_s.push_back(swing.begin_s);
        times_s.push_back(swing.end_s);
      }
    }
    support.push_back(static_cast<std::uint8_t>(of_clip.support));
  }
  const auto swings = builder.CreateVector(times_s);
  const auto swing_counts = builder.CreateVector(counts);
  const auto supports = builder.CreateVector(support);
  return schema::CreateFootwork(builder, swings, swing_counts, supports);
}

/// The footwork of a library's file; none if it cannot be read.
std::vector<runtime::Footwork> footwork_of(std::span<const std::byte> library_file) {
  database::ClipLibrary library;
  if (database::read_library(library_file, library) != database::LoadStatus::ok) return {};
  return runtime::prepare(library).footwork;
}

void store(FlatBufferBuilder& builder, const models::Selector& selector,
           std::span<const std::byte> library_file, const SelectorRecord* record) {
  std::vector<Offset<schema::Clip>> stored;
  for (const models::ClipSummary& clip : selector.clips) stored.push_back(store(builder, clip));
  const auto clips = builder.CreateVector(stored);
  const auto names = builder.CreateVectorOfStrings(selector.layout.names());
  const auto least = builder.CreateVector(selector.scaling.min);
  const auto most = builder.CreateVector(selector.scaling.max);
  std::vector<float> floats;
  for (const Eigen::Vector3f& centre : selector.target_centres) {
    floats.insert(floats.end(), centre.begin(), centre.end());
  }
  const auto centres = builder.CreateVector(floats);
  const auto kind = std::visit([](const auto& model) { return kind_of(model); }, selector.model);
  const auto model =
      std::visit([&builder](const auto& one) { return store(builder, one); }, selector.model);
  Offset<flatbuffers::Vector<std::uint8_t>> library;
  if (!library_file.empty()) library = store(builder, library_file);
  Offset<schema::ResponseCosts> costs;
  if (selector.costs) costs = store(builder, *selector.costs);
  Offset<flatbuffers::Vector<Offset<schema::Kind>>> kinds;
  if (selector.kinds != models::Selector{}.kinds) {
    std::vector<Offset<schema::Kind>> each;
    for (const features::KnownKind& known : selector.kinds) each.push_back(store(builder, known));
    kinds = builder.CreateVector(each);
  }
  Offset<schema::Realism> realism;
  if (selector.realism) realism = store(builder, *selector.realism);
  Offset<schema::Footwork> footwork;
  if (const auto computed = footwork_of(library_file); !computed.empty())
    footwork = store(builder, computed);
  Offset<flatbuffers::String> provenance;
  Offset<schema::Training> training;
  if (record != nullptr) {
    provenance = builder.CreateString(record->provenance);
    training = store(builder, *record);
  }
  schema::FinishSelectorBuffer(
      builder, schema::CreateSelector(builder, selector.library_hash, clips, selector.idle, names,
                                      least, most, selector.brawn, centres, kind, model, library,
                                      costs, kinds, realism, provenance, training, footwork));
}

}  // namespace

std::string selector_bytes(const models::Selector& selector,
                           std::span<const std::byte> library_file, const SelectorRecord* record) {
  FlatBufferBuilder builder;
  store(builder, selector, library_file, record);
  const std::string_view content(reinterpret_cast<const char*>(builder.GetBufferPointer()),
                                 builder.GetSize());
  const auto seal =
      database::make_file_header(database::kSelectorFormat, database::bytes_of(content));
  std::string bytes(reinterpret_cast<const char*>(seal.data()), seal.size());
  bytes.append(content);
  models::Selector read;
  const database::LoadStatus status = runtime::read_selector(database::bytes_of(bytes), read);
  if (status != database::LoadStatus::ok) {
    throw Error("", std::string("the selector cannot be written, because on reading it back it ") +
                        database::message_of(status) + "; check what it was trained on");
  }
  return bytes;
}

void write_selector(const models::Selector& selector, std::span<const std::byte> library_file,
                    const SelectorRecord* record, const std::string& path) {
  database::write_file_atomically(path, selector_bytes(selector, library_file, record));
}

}  // namespace flinch::train

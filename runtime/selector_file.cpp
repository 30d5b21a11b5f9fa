// SPDX-License-Identifier: MIT
#include "runtime/selector_file.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

#include "database/library/library_bounds.h"
#include "database/library/unfolded_size.h"
#include "selector_generated.h"

namespace flinch::runtime {
namespace {

using database::LoadStatus;

static_assert(std::endian::native == std::endian::little,
              "files are little-endian and are read in place");

// FlatBuffers' verifier checks that a vector lies inside the file but not that its numbers are
// aligned there. In a forged file they may not be.
template <typename T>
std::vector<T> to_vector(const flatbuffers::Vector<T>& stored) {
  std::vector<T> numbers(stored.size());
  if (!numbers.empty()) std::memcpy(numbers.data(), stored.Data(), numbers.size() * sizeof(T));
  return numbers;
}

models::ClipSummary read_clip(const schema::Clip& stored) {
  models::ClipSummary clip{stored.name()->str(), std::nullopt};
  if (const schema::Annotation* annotation = stored.annotation()) {
    clip.annotation =
        motion::Annotation{.target = static_cast<motion::Target>(annotation->target()),
                           .direction = annotation->direction(),
                           .degree = static_cast<motion::Degree>(annotation->degree()),
                           .onset_s = annotation->onset_s(),
                           .peak_s = annotation->peak_s(),
                           .end_s = annotation->end_s()};
  }
  return clip;
}

/// Returns no machines if their numbers disagree.
std::vector<models::SvmMachine> read_machines(const schema::Svm& stored) {
  const auto& rho = *stored.rho();
  const auto& counts = *stored.counts();
  if (counts.size() != 4 * std::size_t{rho.size()}) return {};
  std::vector<models::SvmMachine> machines(rho.size());
  for (flatbuffers::uoffset_t i = 0; i < rho.size(); ++i) {
    machines[i].rho = rho.Get(i);
    for (flatbuffers::uoffset_t k = 0; k < 4; ++k) machines[i].count[k] = counts.Get(4 * i + k);
  }
  return machines;
}

models::SvmModel read_model(const schema::Svm& stored, int feature_count) {
  return {.kernel = static_cast<models::SvmKernel>(stored.kernel()),
          .degree = stored.degree(),
          .gamma = stored.gamma(),
          .coef0 = stored.coef0(),
          .cost = stored.cost(),
          .feature_count = feature_count,
          .label = to_vector(*stored.label()),
          .vectors_of_class = to_vector(*stored.vectors_of_class()),
          .bound = to_vector(*stored.bound()),
          .support_vectors = to_vector(*stored.support_vectors()),
          .machines = read_machines(stored),
          .vectors = to_vector(*stored.vectors()),
          .coefficients = to_vector(*stored.coefficients())};
}

models::KnnModel read_model(const schema::Knn& stored, int feature_count, int clip_count) {
  return {
      .k = stored.k(),
      .vote = static_cast<models::KnnVote>(stored.vote()),
      .feature_count = feature_count,
      .points = to_vector(*stored.points()),
      .label = to_vector(*stored.label()),
      .cost = stored.cost() == nullptr ? std::vector<std::uint16_t>() : to_vector(*stored.cost()),
      .clip_count = stored.cost() == nullptr ? 0 : clip_count,
      .cost_step_ns = stored.cost_step_ns(),
      .leaves = {}};
}

models::NetworkModel read_model(const schema::Network& stored, int feature_count) {
  return {.feature_count = feature_count,
          .hidden_count = stored.hidden_count(),
          .member_count = stored.member_count(),
          .clip = to_vector(*stored.clip()),
          .mean_root = stored.mean_root(),
          .scale_root = stored.scale_root(),
          .variance_ns = stored.variance_ns(),
          .weights = to_vector(*stored.weights())};
}

models::PairwiseModel read_model(const schema::PairwiseLinear& stored, int feature_count) {
  return {.feature_count = feature_count,
          .clip = to_vector(*stored.clip()),
          .machine = to_vector(*stored.machine()),
          .weights = to_vector(*stored.weights())};
}

using database::UnfoldedSize;

void add_vectors(const schema::Svm& svm, UnfoldedSize& unfolded) {
  unfolded.add(svm.label()).add(svm.vectors_of_class()).add(svm.bound());
  unfolded.add(svm.support_vectors()).add(svm.rho()).add(svm.counts());
  unfolded.add(svm.vectors()).add(svm.coefficients());
}

/// Whether counts are within their bounds, and no more is read than the file holds.
bool has_bounded_size(const schema::Selector& stored, std::size_t content_size) {
  if (stored.clips()->size() > database::kMaxClips ||
      stored.feature_names()->size() > features::kMaxFeatures) {
    return false;
  }
  UnfoldedSize unfolded;
  for (const schema::Clip* clip : *stored.clips()) unfolded.add(clip->name());
  for (const flatbuffers::String* name : *stored.feature_names()) unfolded.add(name);
  unfolded.add(stored.least()).add(stored.most()).add(stored.library());
  if (const schema::ResponseCosts* costs = stored.costs()) {
    unfolded.add(costs->vulnerability()).add(costs->work_j()).add(costs->vulnerability_name());
    unfolded.add(costs->reference_damages_ns());
    if (costs->of_kind() != nullptr) {
      if (costs->of_kind()->size() > features::kMaxThreatKinds) return false;
      for (const schema::KindVulnerability* own : *costs->of_kind())
        unfolded.add(own->vulnerability());
    }
    if (costs->of_stance() != nullptr) {
      if (costs->of_stance()->size() > stored.clips()->size()) return false;
      for (const schema::StanceWork* own : *costs->of_stance()) unfolded.add(own->work_j());
    }
  }
  if (stored.kinds() != nullptr) {
    if (stored.kinds()->size() > features::kMaxThreatKinds) return false;
    for (const schema::Kind* kind : *stored.kinds())
      unfolded.add(kind->name()).add(kind->numbers()).add(kind->rod());
  }
  if (const schema::Footwork* footwork = stored.footwork())
    unfolded.add(footwork->swings()).add(footwork->counts()).add(footwork->support());
  if (const schema::Realism* realism = stored.realism()) {
    unfolded.add(realism->judge()).add(realism->mean()).add(realism->basis());
    unfolded.add(realism->weight()).add(realism->points()).add(realism->quality());
    unfolded.add(realism->theta_weight()).add(realism->theta_points()).add(realism->theta());
  }
  if (const schema::Svm* svm = stored.model_as_Svm()) {
    add_vectors(*svm, unfolded);
  } else if (const schema::Knn* knn = stored.model_as_Knn()) {
    unfolded.add(knn->points()).add(knn->label()).add(knn->cost());
  } else if (const schema::Network* network = stored.model_as_Network()) {
    unfolded.add(network->clip()).add(network->weights());
  } else if (const schema::PairwiseLinear* pairwise = stored.model_as_PairwiseLinear()) {
    unfolded.add(pairwise->clip()).add(pairwise->machine()).add(pairwise->weights());
  }
  return unfolded.is_within(content_size);
}

/// Returns nothing where the number of bodies is not that of a figure.
std::optional<models::ResponseCosts> read_costs(const schema::ResponseCosts& stored,
                                                std::size_t kind_count) {
  models::ResponseCosts costs;
  if (stored.vulnerability()->size() != motion::kBodyCount) return std::nullopt;
  std::copy(stored.vulnerability()->begin(), stored.vulnerability()->end(),
            costs.vulnerability.begin());
  costs.reference_damage_ns = stored.reference_damages_ns() == nullptr
                                  ? std::vector<double>(kind_count, stored.reference_damage_ns())
                                  : to_vector(*stored.reference_damages_ns());
  costs.reference_work_j = stored.reference_work_j();
  costs.work_j = to_vector(*stored.work_j());
  costs.phase_count = stored.phase_count();
  costs.time_count = stored.time_count();
  costs.min_time_s = stored.min_time_s();
  costs.time_step_s = stored.time_step_s();
  if (stored.vulnerability_name() != nullptr)
    costs.vulnerability_name = stored.vulnerability_name()->str();
  if (stored.of_stance() != nullptr) {
    for (const schema::StanceWork* own : *stored.of_stance())
      costs.of_stance.push_back({own->stance(), to_vector(*own->work_j()), own->phase_count()});
  }
  if (stored.of_kind() == nullptr) return costs;
  for (const schema::KindVulnerability* own : *stored.of_kind()) {
    if (own->vulnerability()->size() != motion::kBodyCount) return std::nullopt;
    costs.of_kind.push_back({own->kind(), {}});
    std::copy(own->vulnerability()->begin(), own->vulnerability()->end(),
              costs.of_kind.back().vulnerability.begin());
  }
  return costs;
}

/// Returns nothing where the number of features is not that of this build.
std::optional<models::RealismModel> read_realism(const schema::Realism& stored) {
  models::RealismModel model;
  if (stored.weight()->size() != model.weight.size()) return std::nullopt;
  std::copy(stored.weight()->begin(), stored.weight()->end(), model.weight.begin());
  model.judge = stored.judge()->str();
  model.mean = to_vector(*stored.mean());
  model.basis = to_vector(*stored.basis());
  model.points = to_vector(*stored.points());
  model.quality = to_vector(*stored.quality());
  model.max_distance = stored.max_distance();
  if (stored.theta_weight() == nullptr) return model;
  models::ThetaExamples& theta = model.theta.emplace();
  if (stored.theta_weight()->size() != theta.weight.size() || stored.theta_points() == nullptr ||
      stored.theta() == nullptr) {
    return std::nullopt;
  }
  std::copy(stored.theta_weight()->begin(), stored.theta_weight()->end(), theta.weight.begin());
  theta.points = to_vector(*stored.theta_points());
  theta.theta = to_vector(*stored.theta());
  return model;
}

/// Returns nothing where a kind has another count of numbers.
std::optional<std::vector<features::KnownKind>> read_kinds(
    const flatbuffers::Vector<flatbuffers::Offset<schema::Kind>>& stored) {
  std::vector<features::KnownKind> kinds;
  for (const schema::Kind* kind : stored) {
    features::KindNumbers numbers{};
    if (kind->numbers()->size() != numbers.size()) return std::nullopt;
    std::copy(kind->numbers()->begin(), kind->numbers()->end(), numbers.begin());
    kinds.push_back(features::kind_of(kind->name()->str(), numbers, kind->falls()));
    kinds.back().shape = static_cast<features::ThreatShape>(kind->shape());
    kinds.back().reach_m = {kind->min_reach_m(), kind->max_reach_m()};
    if (kind->rod() == nullptr) continue;
    features::RodNumbers rod{};
    if (kind->rod()->size() != rod.size()) return std::nullopt;
    std::copy(kind->rod()->begin(), kind->rod()->end(), rod.begin());
    kinds.back().rod = features::rod_ranges_of(rod);
  }
  return kinds;
}

/// Returns nothing unless this build computes every feature.
std::optional<features::Layout> read_layout(const schema::Selector& stored) {
  std::vector<std::string> names;
  for (const flatbuffers::String* name : *stored.feature_names()) names.push_back(name->str());
  return features::Layout::of(names);
}

/// Returns false for errors that the schema's own verification does not find.
bool read_stored(const schema::Selector& stored, models::Selector& selector) {
  selector.library_hash = stored.library_hash();
  for (const schema::Clip* clip : *stored.clips()) selector.clips.push_back(read_clip(*clip));
  selector.idle = stored.idle();
  selector.scaling = {to_vector(*stored.least()), to_vector(*stored.most())};
  selector.brawn = stored.brawn();
  const auto& centres = *stored.target_centres();
  if (centres.size() != 3 * selector.target_centres.size()) return false;
  for (flatbuffers::uoffset_t i = 0; i < centres.size(); ++i) {
    selector.target_centres.values[i / 3][i % 3] = centres.Get(i);
  }
  if (const schema::Svm* svm = stored.model_as_Svm()) {
    selector.model = read_model(*svm, selector.layout.size());
  } else if (const schema::Knn* knn = stored.model_as_Knn()) {
    selector.model =
        read_model(*knn, selector.layout.size(), static_cast<int>(selector.clips.size()));
  } else if (const schema::Network* network = stored.model_as_Network()) {
    selector.model = read_model(*network, selector.layout.size());
  } else if (const schema::PairwiseLinear* pairwise = stored.model_as_PairwiseLinear()) {
    selector.model = read_model(*pairwise, selector.layout.size());
  } else {
    return false;
  }
  if (stored.costs() != nullptr) {
    selector.costs =
        read_costs(*stored.costs(), stored.kinds() == nullptr ? 1 : stored.kinds()->size());
    if (!selector.costs) return false;
  }
  if (stored.kinds() != nullptr) {
    auto kinds = read_kinds(*stored.kinds());
    if (!kinds) return false;
    selector.kinds = std::move(*kinds);
  }
  if (stored.realism() != nullptr) {
    selector.realism = read_realism(*stored.realism());
    if (!selector.realism) return false;
  }
  if (!is_sound(selector)) return false;
  if (auto* knn = std::get_if<models::KnnModel>(&selector.model)) models::build_leaves(*knn);
  if (auto* svm = std::get_if<models::SvmModel>(&selector.model)) models::update_derived(*svm);
  return true;
}

/// Returns nothing unless it is that of so many clips.
std::optional<std::vector<Footwork>> read_footwork(const schema::Footwork& stored,
                                                   std::size_t clip_count) {
  const std::vector<std::uint8_t> support = to_vector(*stored.support());
  const std::vector<std::uint32_t> counts = to_vector(*stored.counts());
  const std::vector<float> times_s = to_vector(*stored.swings());
  if (support.size() != clip_count || counts.size() != 2 * clip_count) return std::nullopt;
  std::vector<Footwork> footwork(clip_count);
  std::size_t next = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (times_s.size() - next < std::size_t{2} * counts[i]) return std::nullopt;
    Footwork& of_clip = footwork[i / 2];
    of_clip.support = static_cast<motion::Side>(support[i / 2]);
    const motion::Side side = i % 2 == 0 ? motion::Side::left : motion::Side::right;
    for (std::size_t count = counts[i]; count > 0; --count, next += 2)
      of_clip.swings[side].push_back({times_s[next], times_s[next + 1]});
  }
  if (next != times_s.size()) return std::nullopt;
  return footwork;
}

/// Reads the library that the file contains, if it contains one.
LoadStatus read_clips(const schema::Selector& stored, SelectorFile& file) {
  if (stored.library() == nullptr) return LoadStatus::ok;
  const std::span<const std::byte> bytes =
      std::as_bytes(std::span(stored.library()->data(), stored.library()->size()));
  const LoadStatus status = database::read_embedded_library(bytes, file.library.emplace());
  if (status == LoadStatus::out_of_memory || status == LoadStatus::other_content) return status;
  // Whatever the error, it means that this file cannot be used.
  if (status != LoadStatus::ok) return LoadStatus::damaged;
  if (file.library->hash != file.selector.library_hash) return LoadStatus::other_content;
  if (!is_compatible(file.selector, *file.library)) return LoadStatus::damaged;
  if (stored.footwork() == nullptr) return LoadStatus::ok;
  std::optional<std::vector<Footwork>> footwork =
      read_footwork(*stored.footwork(), file.library->clips.size());
  if (!footwork || !is_sound(*footwork, *file.library)) return LoadStatus::damaged;
  file.footwork = std::move(*footwork);
  return LoadStatus::ok;
}

}  // namespace

LoadStatus read_selector_file(std::span<const std::byte> bytes, SelectorFile& file) noexcept try {
  std::vector<std::byte> storage;
  const database::VerifiedFile unsealed =
      database::verify_file(database::kSelectorFormat, database::aligned(bytes, storage));
  if (unsealed.status != LoadStatus::ok) return unsealed.status;
  flatbuffers::Verifier verifier(reinterpret_cast<const std::uint8_t*>(unsealed.content.data()),
                                 unsealed.content.size());
  if (!schema::VerifySelectorBuffer(verifier)) return LoadStatus::damaged;
  const schema::Selector& stored = *schema::GetSelector(unsealed.content.data());
  if (!has_bounded_size(stored, unsealed.content.size())) return LoadStatus::damaged;
  const std::optional<features::Layout> layout = read_layout(stored);
  if (!layout) return LoadStatus::other_layout;
  SelectorFile read;
  read.selector.layout = *layout;
  if (!read_stored(stored, read.selector)) return LoadStatus::damaged;
  const LoadStatus status = read_clips(stored, read);
  if (status == LoadStatus::ok) file = std::move(read);
  return status;
} catch (const std::bad_alloc&) {
  return LoadStatus::out_of_memory;
}

LoadStatus read_selector(std::span<const std::byte> bytes, models::Selector& selector) noexcept {
  SelectorFile file;
  const LoadStatus status = read_selector_file(bytes, file);
  if (status == LoadStatus::ok) selector = std::move(file.selector);
  return status;
}

LoadStatus read_selector(const std::string& path, models::Selector& selector) noexcept {
  std::vector<std::byte> bytes;
  const LoadStatus status = database::read_bytes(path, bytes);
  return status == LoadStatus::ok ? read_selector(bytes, selector) : status;
}

}  // namespace flinch::runtime

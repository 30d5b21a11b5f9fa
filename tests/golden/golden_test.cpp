// SPDX-License-Identifier: MIT
// Same seed, same bits: the whole way from a library to a reacting character ends in stated hashes,
// whatever the number of threads, the compiler or its sanitizers.
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <bit>
#include <iomanip>
#include <sstream>

#include "database/library/content_hash.h"
#include "features/random.h"
#include "reaction/reacting_character.h"
#include "tests/scenes/synthetic_library.h"
#include "train/fit/labels.h"
#include "train/fit/selector_writer.h"
#include "train/fit/training.h"
#include "train/simulate/simulate.h"
#include "train/store/store_trials.h"

namespace flinch::tests {
namespace {

constexpr std::uint64_t kScenarios = 40;
// Those of the paper and the room that a vector had for others when the hash was stated.
constexpr std::size_t kHashedFeatures = 33;
constexpr std::uint64_t kObservationsHash = 0xb31f555b415568a8;
constexpr std::uint64_t kSelectorHash = 0x6e28be78d480e1cc;
constexpr std::uint64_t kPairwiseHash = 0x295ff4bae11a1fa7;
constexpr std::uint64_t kPosesHash = 0xf49eaf2b57892cfe;

constexpr const char* kAdvice =
    "Results have changed. If that is meant, state the new hash in golden_test.cpp, raise "
    "sim::kLawVersion if the same scenarios have other impulses, and say in CHANGELOG.md that "
    "stores and selectors have to be made anew. If not, check in this order: a value that is read "
    "before it is set (run the asan preset), a sum whose order depends on the threads, a random "
    "stream whose key changed, a compiler flag (-march, -ffp-contract, -ffast-math), a "
    "mathematical function of another C library.";

/// The bytes that a hash is taken of, in the order in which they were added.
class Bytes {
 public:
  template <class Number>
  requires std::is_arithmetic_v<Number>
  void add(Number number) {
    const auto bytes = std::bit_cast<std::array<std::byte, sizeof(Number)>>(number);
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
  void add(std::span<const std::byte> bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
  void add(const Eigen::Vector3f& vector) {
    for (const float number : vector) add(number);
  }
  std::uint64_t hash() const { return database::content_hash(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

void expect_hash(std::uint64_t expected, std::uint64_t found, const std::string& what) {
  std::ostringstream text;
  text << what << ": the new hash is 0x" << std::hex << std::setw(16) << std::setfill('0') << found;
  EXPECT_EQ(expected, found) << text.str() << ". " << kAdvice;
}

/// A store of `kScenarios`, as `threads` simulate it.
train::Store simulated_store(const train::SimulationSetup& setup, int threads) {
  train::RehearsalCache rehearsals(std::uint64_t{1} << 28);
  train::BatchContext context;
  context.threads = threads;
  train::Batch batch;
  EXPECT_TRUE(simulate_batch(setup, rehearsals, {0, kScenarios}, context, batch));
  return {make_store_header(setup), std::move(batch.observations)};
}

std::uint64_t hash_of(std::span<const train::Observation> observations) {
  Bytes bytes;
  for (const train::Observation& observation : observations) {
    bytes.add(observation.number);
    bytes.add(observation.scenario.threat.position);
    bytes.add(observation.scenario.threat.velocity);
    for (const float feature : std::span(observation.features).first(kHashedFeatures))
      bytes.add(feature);
    bytes.add(train::encode_trials(observation.trials));
  }
  return bytes.hash();
}

/// A selector's file, fitted by as many threads as OpenMP is given.
std::string selector_file(const train::Store& store, train::Method method) {
  const train::CostModel cost_model =
      train::make_cost_model(store.header, train::vulnerability_profiles()[0], 0.1);
  const train::Training training =
      train_selector(store.header, store.observations, cost_model, method, store.header.seed);
  return train::selector_bytes(training.selector,
                               std::as_bytes(std::span(store.header.library_file)));
}

std::uint64_t hash_of(const std::string& file) {
  return database::content_hash(std::as_bytes(std::span(file)));
}

/// Number `number` of the balls that fly at a character at the origin: from anywhere, at the
/// height of its trunk, there in 0.6 s.
features::Threat throw_number(std::uint64_t number) {
  features::Random random(1, features::RandomStream::scenario, number);
  features::ThreatDescription description;
  description.azimuth = static_cast<float>(random.uniform(-3, 3));
  description.speed_mps = static_cast<float>(random.uniform(10, 25));
  description.time_to_impact_s = 0.6F;
  return threat_from_description(description, {0, 0, 1.1F}, 0);
}

/// A minute at 60 frames per second with a throw every four seconds, each of which hits or misses.
std::uint64_t hash_of_a_minute(const std::string& selector_file) {
  runtime::Library library;
  runtime::Workspace workspace;
  EXPECT_EQ(library.load(std::as_bytes(std::span(selector_file))), database::LoadStatus::ok);
  EXPECT_EQ(workspace.reserve_memory(library.selection_bytes()), database::LoadStatus::ok);
  reaction::ReactingCharacter character(library, reaction::make_reaction_data(library));
  Bytes bytes;
  constexpr int kFramesPerThrow = 240;
  constexpr float kFrame_s = 1.0F / 60;
  int struck = 0;
  for (int frame = 0; frame < 3600; ++frame) {
    const features::Threat threat =
        throw_number(static_cast<std::uint64_t>(frame / kFramesPerThrow));
    if (frame % kFramesPerThrow == 0) {
      character.stop();
      character.character().place(Eigen::Vector2f::Zero(), 0, 0);
      character.character().perceive(threat, workspace);
    } else if (frame % kFramesPerThrow == 30) {  // 0.1 s before the impact
      EXPECT_EQ(character.react_to(features::ball_of(features::advanced(threat, 30 * kFrame_s))),
                reaction::ReactionStatus::ok);
    }
    EXPECT_EQ(character.update(kFrame_s), reaction::ReactionStatus::ok);
    if (frame % kFramesPerThrow == 60 && std::isfinite(character.reaction().contact_s())) ++struck;
    bytes.add(character.pose().root_position);
    for (const Eigen::Quaternionf& rotation : character.pose().rotation)
      for (const float number : rotation.coeffs()) bytes.add(number);
  }
  EXPECT_GT(struck, 0) << "no ball hit: the hash would say nothing of reactions";
  return bytes.hash();
}

TEST(Golden, StoreSelectorAndAMinuteOfReactionsHaveTheStatedHashes) {
  const database::ClipLibrary library = scenes::synthetic_library();
  const train::SimulationSetup setup(library, {});
  for (const int threads : {1, 2, 3}) {
    SCOPED_TRACE(std::to_string(threads) + " threads");
    const train::Store store = simulated_store(setup, threads);
    expect_hash(kObservationsHash, hash_of(store.observations), "kObservationsHash");
    omp_set_num_threads(threads);
    const std::string selector = selector_file(store, train::Method::network);
    expect_hash(kSelectorHash, hash_of(selector), "kSelectorHash");
    expect_hash(kPairwiseHash, hash_of(selector_file(store, train::Method::pairwise_cost)),
                "kPairwiseHash");
    if (threads == 1) expect_hash(kPosesHash, hash_of_a_minute(selector), "kPosesHash");
  }
}

}  // namespace
}  // namespace flinch::tests

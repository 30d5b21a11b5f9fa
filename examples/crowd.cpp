// SPDX-License-Identifier: MIT
// Twenty characters in a square, who walk about, bump into each other and into its walls, and are
// pushed away: by recorded responses where one would look real, by physics elsewhere. Usage: crowd
// SELECTOR [OUT.glb [SECONDS]]. SELECTOR is a file with pushes and a realism model
// (docs/pushing.md); 60 s unless said otherwise.
//
// Left out: steering. Nobody avoids anybody, as in figure 7 of Arikan et al. 2005.
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>

#include "database/export/gltf_writer.h"
#include "reaction/crowd/crowd.h"

using namespace flinch;

namespace {

constexpr float kRate_hz = 60;

/// FNV-1a over the bits of every pose that is shown, so that two runs can be compared.
class PoseHash {
 public:
  void add(const motion::Pose& pose) {
    add(pose.root_position.data(), 3);
    for (const Eigen::Quaternionf& rotation : pose.rotation) add(rotation.coeffs().data(), 4);
  }
  std::uint64_t value() const { return value_; }
  bool is_finite() const { return is_finite_; }

 private:
  void add(const float* numbers, int count) {
    for (int i = 0; i < count; ++i) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, numbers + i, sizeof bits);
      value_ = (value_ ^ bits) * 0x100000001b3U;
      is_finite_ = is_finite_ && std::isfinite(numbers[i]);
    }
  }
  std::uint64_t value_ = 0xcbf29ce484222325U;
  bool is_finite_ = true;
};

double cpu_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

int play(const runtime::Library& library, const char* out, float seconds) {
  const auto graph = runtime::make_motion_graph(library);
  if (!graph) return 1;
  reaction::Crowd crowd(library, *graph);
  std::vector<motion::Motion> motions(crowd.characters().size());
  PoseHash hash;
  double updating_s = 0;
  float farthest_m = 0;  // from the centre, along an axis
  const auto frames = static_cast<int>(std::lround(seconds * kRate_hz));
  for (int frame = 0; frame < frames; ++frame) {
    const double begin_s = cpu_s();
    crowd.update(1 / kRate_hz);
    updating_s += cpu_s() - begin_s;
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const motion::Pose pose = crowd.characters()[i].pose();
      hash.add(pose);
      farthest_m = std::max(farthest_m, pose.root_position.head<2>().cwiseAbs().maxCoeff());
      if (out != nullptr) motions[i].poses.push_back(pose);
    }
  }
  const reaction::CrowdTally& tally = crowd.tally();
  std::printf("%zu characters for %.0f s: %zu bumps, %zu touches of a wall\n", motions.size(),
              static_cast<double>(seconds), tally.bumps, tally.walls);
  std::printf("%zu pushes answered, %zu by physics, %zu knocked over; at most %.2f m outside\n",
              tally.answered, tally.physical, tally.knocked_over,
              static_cast<double>(std::max(farthest_m - crowd.options().half_side_m, 0.0F)));
  std::printf("%.2f %% of a core; hash %016" PRIx64 "; %s\n",
              100 * updating_s / static_cast<double>(seconds), hash.value(),
              hash.is_finite() ? "every number is finite" : "a number is not finite");
  if (out != nullptr) database::write_group_glb(out, library.clip_library().character, motions);
  return hash.is_finite() ? 0 : 1;
}

}  // namespace

int main(int argument_count, char** arguments) try {
  runtime::Library library;
  if (argument_count < 2 || argument_count > 4 ||
      library.load(arguments[1]) != database::LoadStatus::ok) {
    std::fprintf(stderr, "usage: crowd SELECTOR [OUT.glb [SECONDS]]; SELECTOR can be loaded\n");
    return 2;
  }
  const float seconds = argument_count > 3 ? std::strtof(arguments[3], nullptr) : 60;
  return play(library, argument_count > 2 ? arguments[2] : nullptr, seconds);
} catch (const std::exception& error) {
  std::fprintf(stderr, "crowd: %s\n", error.what());
  return 1;
}

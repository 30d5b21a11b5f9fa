// SPDX-License-Identifier: MIT
#include "sim/rehearsal/track_lanes.h"

#include <algorithm>
#include <array>
#include <functional>

#include "sim/rehearsal/track_run.h"

namespace flinch::sim {
namespace {

using Tracks = std::span<const std::unique_ptr<Rehearsal::Track>>;

/// Returns how many poses two motions begin with in common, to the bit.
std::size_t common_poses(const motion::Motion& first, const motion::Motion& second) {
  if (first.rate_hz != second.rate_hz) return 0;
  const std::size_t size = std::min(first.poses.size(), second.poses.size());
  std::size_t count = 0;
  while (count < size && motion::has_same_bits(first.poses[count], second.poses[count])) ++count;
  return count;
}

void step_alone(TrackRun& run, const FigureModel& figure_model) {
  TreeLanes<1> lanes;
  run.put_step(lanes, 0);
  factor_trees(figure_model.tree, lanes);
  run.solve_contacts(lanes, 0);
  move_figures(figure_model.tree, lanes);
  run.end_step(lanes, 0);
}

/// Records the steps of the first track that are those of all, and copies them to the others.
void record_common_steps(const FigureModel& figure_model, const SimulationOptions& options,
                         Tracks tracks) {
  const double common_s = common_time_s(tracks);
  if (tracks.size() < 2 || common_s <= 0) return;
  Rehearsal::Track& first = *tracks.front();
  TrackRun run(figure_model, options);
  run.start(first);
  while (run.time_s() + options.free_step_s < common_s && run.begin_step())
    step_alone(run, figure_model);
  for (const auto& track : tracks.subspan(1)) track->copy_recording(first);
}

/// A lane whose track is complete takes the next.
template <std::size_t kLanes>
void record_in_lanes(const FigureModel& figure_model, const SimulationOptions& options,
                     Tracks tracks) {
  std::vector<TrackRun> runs;
  runs.reserve(kLanes);
  for (std::size_t lane = 0; lane < std::min(kLanes, tracks.size()); ++lane)
    runs.emplace_back(figure_model, options);
  TreeLanes<kLanes> lanes{};  // an idle lane keeps the numbers of its last step
  std::array<bool, kLanes> is_running{};
  std::size_t next = 0;
  const auto for_each_running = [&](auto visit) {
    for (std::size_t lane = 0; lane < runs.size(); ++lane)
      if (is_running[lane]) visit(runs[lane], lane);
  };
  for (;;) {
    for (std::size_t lane = 0; lane < runs.size(); ++lane) {
      if (is_running[lane]) is_running[lane] = runs[lane].begin_step();
      for (; !is_running[lane] && next < tracks.size(); ++next) {
        runs[lane].start(*tracks[next]);
        is_running[lane] = runs[lane].begin_step();
      }
    }
    if (std::ranges::none_of(is_running, std::identity())) return;
    for_each_running([&](TrackRun& run, std::size_t lane) { run.put_step(lanes, lane); });
    factor_trees(figure_model.tree, lanes);
    for_each_running([&](TrackRun& run, std::size_t lane) { run.solve_contacts(lanes, lane); });
    move_figures(figure_model.tree, lanes);
    for_each_running([&](TrackRun& run, std::size_t lane) { run.end_step(lanes, lane); });
  }
}

}  // namespace

// The velocity of pose k depends on the poses up to k + 1, and the reference at a time on the poses
// around it and their velocities. So n common poses give references that are the same before pose
// n - 2.
double common_time_s(Tracks tracks) {
  if (tracks.empty()) return 0;
  const motion::Motion& first = tracks.front()->motion;
  std::size_t poses = first.poses.size();
  for (const auto& track : tracks.subspan(1))
    poses = std::min(poses, common_poses(first, track->motion));
  return poses > 2 ? static_cast<double>(poses - 2) / static_cast<double>(first.rate_hz) : 0;
}

void record(const FigureModel& figure_model, const SimulationOptions& options, Tracks tracks,
            std::size_t lanes) {
  record_common_steps(figure_model, options, tracks);
  switch (lanes) {
#ifdef __x86_64__
    case 8:
      return record_in_lanes<8>(figure_model, options, tracks);
    case 4:
      return record_in_lanes<4>(figure_model, options, tracks);
#endif
    case 2:
      return record_in_lanes<2>(figure_model, options, tracks);
    default:
      return record_in_lanes<1>(figure_model, options, tracks);
  }
}

}  // namespace flinch::sim

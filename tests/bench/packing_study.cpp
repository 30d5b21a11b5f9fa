// SPDX-License-Identifier: MIT
// Compares selectors of packed clips and their footwork with those of the same clips as floats, as
// files were before, in turns: sizes, loading, sampling, and by how much the grid of packed poses
// moves joints.
//
//     packing_study SELECTOR FOLDER [PROCESSES]
//
// SELECTOR is trained for the default library, as `flinch author` makes it. Writes the selector
// with each kind of clips to FOLDER.
#include <algorithm>
#include <array>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "database/author/authored_library.h"
#include "database/files/file_io.h"
#include "database/files/library_writer.h"
#include "motion/default_character.h"
#include "runtime/selector_file.h"
#include "selector_generated.h"
#include "tests/bench/load_cost.h"
#include "tests/bench/study.h"
#include "train/fit/selector_writer.h"

namespace flinch {
namespace {

/// The selector's file as it was before files had footwork: its table refers to none.
std::string without_footwork(const std::string& file) {
  std::string content = file.substr(database::kFileHeaderSize);
  auto* root = reinterpret_cast<std::uint8_t*>(content.data());
  root += flatbuffers::ReadScalar<flatbuffers::uoffset_t>(root);
  root -= flatbuffers::ReadScalar<flatbuffers::soffset_t>(root);
  flatbuffers::WriteScalar<flatbuffers::voffset_t>(root + runtime::schema::Selector::VT_FOOTWORK,
                                                   0);
  const auto header =
      database::make_file_header(database::kSelectorFormat, database::bytes_of(content));
  return std::string(reinterpret_cast<const char*>(header.data()), header.size()) + content;
}

/// A library, its file, and that of a selector with it.
struct Variant {
  const char* name;
  database::ClipLibrary library;
  std::string library_file;
  std::string selector_path;
  std::size_t selector_size = 0;
};

Variant variant_of(const char* name, database::ClipLibrary library, models::Selector selector,
                   bool with_footwork, const std::string& folder) {
  Variant variant{name, std::move(library), {}, folder + "/" + name + ".flinch", 0};
  variant.library_file = library_bytes(variant.library);
  const auto bytes = database::bytes_of(variant.library_file);
  selector.library_hash = database::verify_file(database::kLibraryFormat, bytes).hash;
  std::string file = train::selector_bytes(selector, bytes);
  if (!with_footwork) file = without_footwork(file);
  variant.selector_size = file.size();
  database::write_file_atomically(variant.selector_path, file);
  return variant;
}

std::array<Variant, 2> make_variants(const std::string& selector_path, const std::string& folder) {
  const std::string bytes = database::read_file(selector_path);
  models::Selector selector;
  if (runtime::read_selector(database::bytes_of(bytes), selector) != database::LoadStatus::ok)
    throw Error(selector_path, "is no selector of today");
  const motion::Physique character = motion::default_character();
  return {
      variant_of("floats", database::authored_library_off_grid(character), selector, false, folder),
      variant_of("packed", database::authored_library(character), selector, true, folder)};
}

/// The paths of both selectors, written by a process of its own: one that has made them has memory
/// in use and to copy, and loads more slowly than a game that has just begun.
std::array<std::string, 2> write_selectors(const std::string& selector_path,
                                           const std::string& folder) {
  const pid_t child = fork();
  if (child == 0) {
    int status = 0;
    try {
      make_variants(selector_path, folder);
    } catch (const Error& error) {
      std::fprintf(stderr, "%s\n", error.what());
      status = 1;
    }
    _exit(status);
  }
  int status = 1;
  if (child < 0 || waitpid(child, &status, 0) != child || status != 0)
    throw Error(folder, "the selectors could not be written");
  return {folder + "/floats.flinch", folder + "/packed.flinch"};
}

/// Median CPU time of the first load by new processes, in turns, ms.
std::array<double, 2> load_ms(const std::array<std::string, 2>& paths, int processes) {
  std::array<std::vector<double>, 2> ms;
  for (int i = 0; i < processes; ++i) {
    for (std::size_t v = 0; v < paths.size(); ++v) {
      const bench::LoadCost cost = bench::cost_in_new_process(paths[v]);
      if (cost.cpu_s < 0) throw Error(paths[v], "the file was refused");
      ms[v].push_back(1e3 * cost.cpu_s);
    }
  }
  return {bench::quantile(ms[0], 0.5), bench::quantile(ms[1], 0.5)};
}

/// Samples random times of random clips. Returns ns per pose; adds to `checksum`.
double sample_ns(const database::ClipLibrary& library, unsigned seed, double& checksum) {
  constexpr int kSamples = 20'000;
  std::mt19937 random(seed);
  const double begin_s = bench::thread_cpu_s();
  for (int i = 0; i < kSamples; ++i) {
    const auto& motion = library.clips[random() % library.clips.size()].motion;
    const float time_s = motion.duration_s() * static_cast<float>(random() % 1000) / 1000;
    checksum += static_cast<double>(sample(motion, time_s).rotation[motion::Role::head].x());
  }
  return 1e9 * (bench::thread_cpu_s() - begin_s) / kSamples;
}

std::array<double, 2> sample_ns(const std::array<Variant, 2>& variants) {
  std::array<std::vector<double>, 2> ns;
  double checksum = 0;
  for (unsigned round = 0; round < 41; ++round) {
    for (std::size_t v = 0; v < variants.size(); ++v)
      ns[v].push_back(sample_ns(variants[v].library, round, checksum));
  }
  std::printf("sampled rotations sum to %.1f\n", checksum);
  return {bench::quantile(ns[0], 0.5), bench::quantile(ns[1], 0.5)};
}

bool is_of_foot(motion::Role role) {
  using motion::Role;
  return role == Role::left_foot || role == Role::right_foot || role == Role::left_toes ||
         role == Role::right_toes;
}

/// Distances in mm between where the same joints are in two libraries' poses.
void print_errors(const database::ClipLibrary& one, const database::ClipLibrary& other) {
  std::vector<double> all;
  std::vector<double> feet;
  const motion::Skeleton& skeleton = one.character.skeleton;
  for (std::size_t c = 0; c < one.clips.size(); ++c) {
    for (std::size_t k = 0; k < one.clips[c].motion.poses.size(); ++k) {
      const auto a = forward_kinematics(skeleton, one.clips[c].motion.poses[k]);
      const auto b = forward_kinematics(skeleton, other.clips[c].motion.poses[k]);
      for (const motion::Role role : motion::kRoles) {
        const Eigen::Vector3f tip_a = a.position[role] + a.orientation[role] * skeleton.tip[role];
        const Eigen::Vector3f tip_b = b.position[role] + b.orientation[role] * skeleton.tip[role];
        const double joint_mm = 1e3 * double{(a.position[role] - b.position[role]).norm()};
        const double tip_mm = 1e3 * double{(tip_a - tip_b).norm()};
        all.push_back(std::max(joint_mm, tip_mm));
        if (is_of_foot(role)) feet.push_back(std::max(joint_mm, tip_mm));
      }
    }
  }
  std::printf("joints moved by the grid, mm: median %.4f, 99 %% %.4f, max %.4f; feet max %.4f\n",
              bench::quantile(all, 0.5), bench::quantile(all, 0.99), bench::quantile(all, 1),
              bench::quantile(feet, 1));
}

void run(const bench::StudyArguments& arguments) {
  const std::string& path = arguments.text(0);
  const std::string& folder = arguments.text(1);
  const int processes = arguments.number_or(2, 41);
  const std::array<double, 2> loading_ms = load_ms(write_selectors(path, folder), processes);
  const std::array<Variant, 2> variants = make_variants(path, folder);
  const std::array<double, 2> sampling_ns = sample_ns(variants);
  std::printf("%-8s %14s %15s %9s %14s\n", "clips", "library, bytes", "selector, bytes", "load, ms",
              "sample, ns");
  for (std::size_t v = 0; v < variants.size(); ++v) {
    std::printf("%-8s %14zu %15zu %9.2f %14.0f\n", variants[v].name,
                variants[v].library_file.size(), variants[v].selector_size, loading_ms[v],
                sampling_ns[v]);
  }
  const auto ratio = [](auto a, auto b) { return static_cast<double>(b) / static_cast<double>(a); };
  std::printf("%-8s %14.3f %15.3f %9.2f %14.2f\n", "ratio",
              ratio(variants[0].library_file.size(), variants[1].library_file.size()),
              ratio(variants[0].selector_size, variants[1].selector_size),
              ratio(loading_ms[0], loading_ms[1]), ratio(sampling_ns[0], sampling_ns[1]));
  print_errors(variants[0].library, variants[1].library);
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(
      count, arguments, {"packing_study SELECTOR FOLDER [PROCESSES]", 2, 3}, flinch::run);
}

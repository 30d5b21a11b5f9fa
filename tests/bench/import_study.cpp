// SPDX-License-Identifier: MIT
// Imports each BVH file of a folder to a character of its own and prints how far the result is from
// the file:
//
//     import_study FOLDER
//
// what docs/importing.md quotes.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "database/import/foot_drift.h"
#include "database/import/source_character.h"
#include "tests/bench/study.h"
#include "tests/database/import/place_deviation.h"

namespace flinch {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() == ".bvh") {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

void measure(const std::string& folder, const std::string& file) {
  const database::Source source = database::analyse_source(database::read_bvh(file));
  const database::SourceMotion motion = source_motion(source);
  const motion::Skeleton skeleton = character_of(source).skeleton;
  const database::Segment whole{0, motion.duration_s(), 0};
  const auto rate_hz = static_cast<float>(1 / motion.frame_time_s);
  const motion::Motion clip = retarget(motion, skeleton, whole, rate_hz);
  const tests::PlaceDeviation place =
      tests::largest(tests::place_deviations(source, skeleton, whole, clip));
  const database::FootDrift feet = measure_foot_drift(motion, skeleton, whole, clip);
  const auto mm = [](float metres) { return 1e3 * double{metres}; };
  std::printf("| %s | %zu | %.0f | %.0f | %.0f | %.1f | %.1f | %.0f | %.0f | %.0f |\n",
              fs::relative(file, folder).c_str(), clip.poses.size(), mm(place.head),
              mm(place.shoulder), mm(place.hand), mm(feet.added_m), mm(-feet.lowest_sole_m),
              tests::angular_acceleration(clip, motion::Role::abdomen),
              tests::angular_acceleration(clip, motion::Role::chest),
              tests::angular_acceleration(clip, motion::Role::neck));
}

void run(const bench::StudyArguments& arguments) {
  std::printf(
      "| file | frames | head, mm | shoulder, mm | hand, mm | foot drift, mm | sole below ground, "
      "mm | abdomen, rad/s^2 | chest, rad/s^2 | neck, rad/s^2 |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::string& file : files_in(arguments.text(0))) {
    try {
      measure(arguments.text(0), file);
    } catch (const Error& error) {
      std::fprintf(stderr, "left out: %s\n", error.what());
    }
  }
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"import_study FOLDER", 1, 1}, flinch::run);
}

// SPDX-License-Identifier: MIT
// Measures the responses of all clips of a library to random threats:
//
//     response_study LIBRARY [THREATS]
//
// and prints what docs/response.md quotes.
#include <algorithm>
#include <cstdio>
#include <random>
#include <vector>

#include "database/files/library_writer.h"
#include "runtime/response/prepared_library.h"
#include "tests/bench/measures.h"
#include "tests/bench/study.h"
#include "tests/runtime/response/response_quality.h"

namespace flinch {
namespace {

struct Row {
  float value = 0;
  std::string what;  // description of the response
};

void print_rows(const char* name, const char* unit, float scale, std::vector<Row> rows) {
  if (rows.empty()) return;
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.value < b.value; });
  const auto at = [&](double share) {
    return scale * rows[bench::quantile_index(rows.size(), share)].value;
  };
  std::printf("| %s, %s | %zu | %.3g | %.3g | %.3g | %.3g | %s |\n", name, unit, rows.size(),
              double{at(0.5)}, double{at(0.95)}, double{at(0.99)}, double{at(1)},
              rows.back().what.c_str());
}

void run(const bench::StudyArguments& arguments) {
  const database::ClipLibrary library = database::load_library(arguments.text(0));
  const int threats = arguments.number_or(1, 200);
  const runtime::PreparedLibrary prepared = runtime::prepare(library);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> part(0, 1);
  std::vector<Row> slip, added, below, seam, lift, extrapolated, peak;
  for (int clip = 0; clip < static_cast<int>(library.clips.size()); ++clip) {
    const motion::Clip& played = library.clip(clip);
    if (!played.annotation || clip == library.idle) continue;
    for (int i = 0; i < threats; ++i) {
      const float time_s = 0.25F + 0.95F * part(random);
      const features::CharacterState state{
          8 * part(random), {2 * part(random), -part(random)}, 6.28F * part(random) - 3.14F};
      const runtime::Response response = runtime::make_response(prepared, state, clip, time_s);
      const tests::ResponseQuality q = tests::measure_response(response, time_s);
      const std::string what = played.name + " at " + std::to_string(time_s);
      slip.push_back({q.support_slip_m, what});
      added.push_back({std::max(q.support_slip_m - q.clip_slip_m, 0.0F), what});
      below.push_back({q.below_ground_m, what});
      seam.push_back({q.seam_share, what + ": " + q.seam});
      if (q.lift_margin_m < 1) {
        lift.push_back({-q.lift_margin_m, what + ", lifts at " + std::to_string(q.lift_s)});
        extrapolated.push_back({-q.extrapolated_margin_m, what});
      }
      if (q.peak_error_s) peak.push_back({*q.peak_error_s, what});
    }
  }
  std::printf(
      "| measure | responses | median | p95 | p99 | worst | of |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n");
  print_rows("slip of the support foot", "mm", 1e3F, slip);
  print_rows("beyond the slip of the clip itself", "mm", 1e3F, added);
  print_rows("foot below ground", "mm", 1e3F, below);
  print_rows("velocity step at a seam", "of the clip's 99th percentile", 1, seam);
  print_rows("centre of mass beyond the standing sole when the other foot lifts", "mm", 1e3F, lift);
  print_rows("extrapolated centre of mass beyond it, then", "mm", 1e3F, extrapolated);
  print_rows("peak from impact, where there is time", "frames of 1/60 s", 60, peak);
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"response_study LIBRARY [THREATS]", 1, 2},
                                   flinch::run);
}

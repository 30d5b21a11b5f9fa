// SPDX-License-Identifier: MIT
// Compares drafts of `flinch annotate` with the annotations of a manifest that was made by hand:
//
//     annotate_study MANIFEST
//
// and prints the tables of docs/importing.md. The files are those of the manifest, in its folder.
// They are split into two halves, one to develop the rules on and one held out: of the files of
// each kind (that of their first clip), those with the fewest clips first and then by name, each
// goes to the half that has fewer clips of the kind so far; the first to the development half.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "database/annotate/draft.h"
#include "database/files/file_io.h"
#include "database/import/manifest.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "tests/bench/measures.h"
#include "tests/bench/study.h"

namespace flinch {
namespace {

using database::Draft;
using database::DraftClip;
using database::Manifest;
using database::ManifestEntry;

constexpr double kClose_s = 0.1;

struct Result {
  const ManifestEntry* entry = nullptr;
  std::optional<DraftClip> drafted;  // nothing where none overlaps

  double onset_error_s() const {
    return drafted->onset_s - static_cast<double>(entry->annotation->onset_s);
  }
  double peak_error_s() const {
    return drafted->peak_s - static_cast<double>(entry->annotation->peak_s);
  }
  bool onset_close() const { return drafted && std::abs(onset_error_s()) <= kClose_s + 1e-6; }
  bool peak_close() const { return drafted && std::abs(peak_error_s()) <= kClose_s + 1e-6; }
  bool kind_right() const { return drafted && name_of(drafted->kind.value) == entry->kind; }
  bool target_right() const {
    return drafted && drafted->protection.target.value == entry->annotation->target;
  }
  bool direction_near() const {
    if (!drafted) return false;
    const float off =
        motion::wrapped_to_pi(drafted->protection.direction.value - entry->annotation->direction);
    return std::abs(off) < motion::radians(46);
  }
};

using DraftsByFile = std::map<std::string, std::optional<Draft>>;

std::optional<Draft> drafted(const std::string& path) {
  try {
    return database::draft_of(database::read_take(path));
  } catch (const Error& error) {
    std::printf("no draft: %s\n", error.what());
    return std::nullopt;
  }
}

double overlap(const DraftClip& clip, const ManifestEntry& entry) {
  const double both = std::min(clip.end_s, *entry.end_s) - std::max(clip.start_s, *entry.start_s);
  const double either = std::max(clip.end_s, *entry.end_s) - std::min(clip.start_s, *entry.start_s);
  return std::max(both, 0.0) / either;
}

std::optional<DraftClip> best_match(const std::optional<Draft>& draft, const ManifestEntry& entry) {
  std::optional<DraftClip> best;
  if (!draft) return best;
  for (const DraftClip& clip : draft->clips) {
    if (overlap(clip, entry) > (best ? overlap(*best, entry) : 0.0)) best = clip;
  }
  return best;
}

// Returns the files of the development half.
std::set<std::string> development_files(const std::vector<const ManifestEntry*>& clips) {
  std::map<std::string, int> clips_of;
  std::map<std::string, std::string> kind_of;
  for (const ManifestEntry* clip : clips) {
    ++clips_of[clip->file];
    kind_of.emplace(clip->file, clip->kind);
  }
  std::map<std::string, std::set<std::pair<int, std::string>>> by_kind;
  for (const auto& [file, count] : clips_of) by_kind[kind_of[file]].insert({count, file});
  std::set<std::string> development;
  for (const auto& [kind, files] : by_kind) {
    int developed = 0, held_out = 0;
    for (const auto& [count, file] : files) {
      const bool is_held_out = held_out < developed;
      (is_held_out ? held_out : developed) += count;
      if (!is_held_out) development.insert(file);
    }
  }
  return development;
}

void print_result(const Result& result, bool is_development) {
  const char* half = is_development ? "development" : "held out";
  if (!result.drafted) {
    std::printf("| %s | %s | none | | | | |\n", result.entry->name.c_str(), half);
    return;
  }
  const DraftClip& clip = *result.drafted;
  std::printf("| %s | %s | %s %.2f | %+.2f | %+.2f | %s | %.0f |\n", result.entry->name.c_str(),
              half, std::string(name_of(clip.kind.value)).c_str(),
              static_cast<double>(clip.kind.confidence), result.onset_error_s(),
              result.peak_error_s(),
              std::string(motion::name_of(clip.protection.target.value)).c_str(),
              static_cast<double>(motion::degrees(clip.protection.direction.value)));
}

std::string share(const std::vector<Result>& results, bool (Result::*is_right)() const) {
  const auto count = std::count_if(results.begin(), results.end(),
                                   [&](const Result& result) { return (result.*is_right)(); });
  char text[48];
  std::snprintf(text, sizeof text, "%td of %zu (%.0f %%)", count, results.size(),
                100 * static_cast<double>(count) / static_cast<double>(results.size()));
  return text;
}

void print_shares(const char* half, const std::vector<Result>& results) {
  if (results.empty()) return;
  std::printf(
      "| %s | %s | %s | %s | %s | %s |\n", half, share(results, &Result::onset_close).c_str(),
      share(results, &Result::peak_close).c_str(), share(results, &Result::kind_right).c_str(),
      share(results, &Result::target_right).c_str(),
      share(results, &Result::direction_near).c_str());
}

// How often guesses of the kind are right, by their confidence.
void print_calibration(const std::vector<Result>& results) {
  std::printf("\n| confidence of the kind | clips | right |\n| --- | --- | --- |\n");
  const double bounds[] = {0, 0.6, 0.7, 0.8, 1.01};
  for (std::size_t k = 0; k + 1 < std::size(bounds); ++k) {
    int count = 0, right = 0;
    for (const Result& result : results) {
      if (!result.drafted) continue;
      const auto confidence = static_cast<double>(result.drafted->kind.confidence);
      if (confidence < bounds[k] || confidence >= bounds[k + 1]) continue;
      ++count;
      right += result.kind_right() ? 1 : 0;
    }
    std::printf("| %.1f to %.1f | %d | %d |\n", bounds[k], std::min(bounds[k + 1], 1.0), count,
                right);
  }
}

void print_pushes(const std::vector<const ManifestEntry*>& pushes, const DraftsByFile& drafts) {
  int found = 0, right = 0;
  for (const ManifestEntry* push : pushes) {
    const std::optional<DraftClip> match = best_match(drafts.at(push->file), *push);
    found += match ? 1 : 0;
    right += match && match->kind.value == database::MovementKind::push ? 1 : 0;
  }
  std::printf("\nPushes: %zu annotated, %d found, %d of them called a push\n", pushes.size(), found,
              right);
}

// A take of 35 s at 120 Hz: the frames of a recorded one, over and over.
void print_time(const std::string& recorded) {
  constexpr int kFrames = 4200;
  std::istringstream lines(database::read_file(recorded));
  std::string line, header;
  std::vector<std::string> rows;
  while (std::getline(lines, line) && !line.starts_with("Frames:")) header += line + "\n";
  std::getline(lines, line);  // Frame Time
  while (std::getline(lines, line)) {
    if (line.size() > 1) rows.push_back(line);
  }
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / "flinch_annotate_study.bvh";
  std::ofstream file(path);
  file << header << "Frames: " << kFrames << "\nFrame Time: 0.00833333\n";
  for (std::size_t i = 0; i < kFrames; ++i) file << rows[i % rows.size()] << "\n";
  file.close();
  const double begin_s = bench::clock_s(CLOCK_MONOTONIC);
  const Draft draft = database::draft_of(database::read_take(path.string()));
  const double spent_s = bench::clock_s(CLOCK_MONOTONIC) - begin_s;
  std::filesystem::remove(path);
  std::printf("\nA take of 35 s at 120 Hz: %.3f s (%zu clips)\n", spent_s, draft.clips.size());
}

void run(const bench::StudyArguments& arguments) {
  const Manifest manifest = database::read_manifest(arguments.text(0));
  const std::filesystem::path folder = std::filesystem::path(arguments.text(0)).parent_path();
  std::vector<const ManifestEntry*> clips, pushes;
  DraftsByFile drafts;
  for (const ManifestEntry& entry : manifest.entries) {
    if (entry.purpose == motion::Purpose::idle || !entry.start_s || !entry.end_s) continue;
    if (entry.purpose == motion::Purpose::push) {
      pushes.push_back(&entry);
    } else if (entry.annotation) {
      clips.push_back(&entry);
    } else {
      continue;
    }
    if (!drafts.contains(entry.file)) drafts[entry.file] = drafted((folder / entry.file).string());
  }
  if (clips.empty()) throw Error(arguments.text(0), "has no annotated clips to compare with");
  const std::set<std::string> development = development_files(clips);
  std::printf(
      "| clip | half | kind | onset, s | peak, s | target | direction |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n");
  std::vector<Result> all, developed, held_out;
  for (const ManifestEntry* clip : clips) {
    const Result result{clip, best_match(drafts.at(clip->file), *clip)};
    print_result(result, development.contains(clip->file));
    all.push_back(result);
    (development.contains(clip->file) ? developed : held_out).push_back(result);
  }
  std::printf(
      "\n| half | onset within 0.1 s | peak within 0.1 s | kind | target | direction within "
      "45 degrees |\n| --- | --- | --- | --- | --- | --- |\n");
  print_shares("development", developed);
  print_shares("held out", held_out);
  print_shares("all", all);
  print_calibration(all);
  if (!pushes.empty()) print_pushes(pushes, drafts);
  const auto longest = std::max_element(drafts.begin(), drafts.end(), [&](auto& a, auto& b) {
    return std::filesystem::file_size(folder / a.first) <
           std::filesystem::file_size(folder / b.first);
  });
  print_time((folder / longest->first).string());
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"annotate_study MANIFEST", 1, 1},
                                   flinch::run);
}

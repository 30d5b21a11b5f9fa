// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <numbers>
#include <optional>

#include "models/selector.h"
#include "motion/error.h"
#include "runtime/selector_file.h"
#include "train/program/command.h"
#include "train/program/load.h"
#include "train/program/table.h"
#include "train/scenario_sampling.h"

namespace flinch::train::program {

namespace {

/// A threat as options say it. Angles in degrees.
struct ThreatOptions {
  double azimuth = 0;
  std::optional<double> elevation;
  double speed_mps = 20;
  std::string target{"head"};
  double time_to_impact_s = 0.5;
  double radius_m = 0.105;
  double mass_kg = 0.27;
};

struct Options {
  std::string selector;
  ThreatOptions threat;
  bool json = false;
};

std::vector<std::string> target_names() {
  std::vector<std::string> names;
  for (int target = 0; target < motion::kTargetCount; ++target)
    names.emplace_back(motion::name_of(static_cast<motion::Target>(target)));
  return names;
}

void add_threat_options(CLI::App& command, ThreatOptions& threat) {
  command
      .add_option("--azimuth", threat.azimuth,
                  "where it comes from, degrees: 0 the front, 90 the character's left")
      ->check(number_in(-360, 360))
      ->capture_default_str();
  command
      .add_option("--elevation", threat.elevation,
                  "how far above the horizontal it comes from at the impact, degrees (default: "
                  "level, or as high as a falling ball must)")
      ->check(number_in(-89, 89));
  command.add_option("--speed", threat.speed_mps, "at the impact, m/s")
      ->check(number_in(0.1, 1000))
      ->capture_default_str();
  command.add_option("--target", threat.target, "what it threatens: head, trunk, pelvis or legs")
      ->check(CLI::IsMember(target_names()))
      ->capture_default_str();
  command.add_option("--time-to-impact", threat.time_to_impact_s, "from perception, s")
      ->check(number_in(0.01, 10))
      ->capture_default_str();
  command.add_option("--radius", threat.radius_m, "of the ball, m")
      ->check(number_in(0.001, 10))
      ->capture_default_str();
  command.add_option("--mass", threat.mass_kg, "of the ball, kg")
      ->check(number_in(0.0001, 1000))
      ->capture_default_str();
}

/// Throws Error when the threat would have come out of the ground.
DescribedThreat described(const ThreatOptions& options, const TargetCentres& centres) {
  DescribedThreat threat;
  threat.target = *motion::target_named(options.target);
  const double least = degrees(
      least_feasible_elevation(options.speed_mps, options.time_to_impact_s, options.radius_m,
                               double{centres[static_cast<std::size_t>(threat.target)].z()}));
  const double elevation = options.elevation.value_or(std::max(0.0, least));
  if (least >= 90)
    throw Error("", "a ball this slow would come from below the ground " +
                        fixed(options.time_to_impact_s, 2) +
                        " s before the impact; raise --speed or shorten --time-to-impact");
  if (elevation < least)
    throw Error("", "the ball would come from below the ground; raise --elevation to at least " +
                        fixed(least, 1) + ", raise --speed or shorten --time-to-impact");
  threat.approach.azimuth = static_cast<float>(options.azimuth * std::numbers::pi / 180);
  threat.approach.elevation = static_cast<float>(elevation * std::numbers::pi / 180);
  threat.approach.speed_mps = static_cast<float>(options.speed_mps);
  threat.approach.time_to_impact_s = static_cast<float>(options.time_to_impact_s);
  threat.approach.radius = static_cast<float>(options.radius_m);
  threat.approach.mass_kg = static_cast<float>(options.mass_kg);
  return threat;
}

Json candidate_document(const models::Selector& selector, const models::Candidate& candidate) {
  const models::ClipSummary& clip = selector.clips[static_cast<std::size_t>(candidate.clip)];
  Json document{{"clip", clip.name}, {"vote", shortest(candidate.vote)}};
  if (clip.annotation) document.update(to_json(clip));
  return document;
}

Json document_of(const models::Selector& selector, const ThreatOptions& threat,
                 std::span<const models::Candidate> candidates) {
  Json list = Json::array();
  for (const models::Candidate& candidate : candidates)
    list.push_back(candidate_document(selector, candidate));
  Json document{{"clip", list[0]["clip"]},
                {"target", threat.target},
                {"time_to_impact_s", threat.time_to_impact_s}};
  if (list[0].contains("direction_degrees"))
    document["direction_degrees"] = list[0]["direction_degrees"];
  document["candidates"] = list;
  return document;
}

void print_text(const models::Selector& selector, const ThreatOptions& threat,
                std::span<const models::Candidate> candidates) {
  using enum Table::Align;
  constexpr std::size_t kMostShown = 5;
  Table table({{"clip"}, {"target"}, {"direction", right}, {"vote", right}});
  for (const models::Candidate& candidate :
       candidates.first(std::min(kMostShown, candidates.size()))) {
    const models::ClipSummary& clip = selector.clips[static_cast<std::size_t>(candidate.clip)];
    const auto& annotation = clip.annotation;
    table.add({clip.name, annotation ? std::string(motion::name_of(annotation->target)) : "-",
               annotation ? fixed(degrees(double{annotation->direction}), 0) : "-",
               fixed(double{candidate.vote}, 3)});
  }
  const models::ClipSummary& best =
      selector.clips[static_cast<std::size_t>(candidates.front().clip)];
  std::cout << best.name << ": for a threat to the " << threat.target << " from "
            << fixed(threat.azimuth, 0) << " degrees in " << fixed(threat.time_to_impact_s, 2)
            << " s\n\n"
            << table.text();
  if (candidates.size() > kMostShown)
    std::cout << "and " << candidates.size() - kMostShown << " more (--json lists all)\n";
}

void run(const Options& options) {
  const models::Selector selector = load_selector_file(options.selector).selector;
  const DescribedThreat threat = described(options.threat, selector.target_centres);
  const std::pmr::vector<models::Candidate> candidates = models::candidates(
      selector, described_features(threat, selector.target_centres), threat.target);
  if (options.json) {
    print(document_of(selector, options.threat, candidates));
  } else {
    print_text(selector, options.threat, candidates);
  }
}

}  // namespace

void add_select(CLI::App& program) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("select", "Ask a selector which clip answers a threat");
  command->add_option("SELECTOR", options->selector, "selector that flinch train made")->required();
  add_threat_options(*command, options->threat);
  add_json_option(*command, options->json);
  command->footer(
      "The character stands still, facing the front, until the impact.\n\n"
      "Example:\n  flinch select real.flinch --azimuth 40 --speed 24 --target head "
      "--time-to-impact 0.5");
  command->callback([options] { run(*options); });
}

}  // namespace flinch::train::program

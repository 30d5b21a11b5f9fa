// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <memory>

#include "models/selector.h"
#include "motion/rotation.h"
#include "program/command.h"
#include "program/load.h"
#include "program/printable.h"
#include "program/table.h"
#include "program/threat_options.h"
#include "train/scenario/scenario_sampling.h"

namespace flinch::program {

namespace {

struct SelectOptions {
  std::string selector;
  ThreatOptions threat;
  bool json = false;
};

Json candidate_document(const models::Selector& selector, const models::Candidate& candidate) {
  const models::ClipSummary& clip = selector.clips[static_cast<std::size_t>(candidate.clip)];
  Json document{{"clip", clip.name}};
  if (std::isnan(candidate.expected_cost_ns)) {
    document["vote"] = shortest(candidate.vote);
  } else {
    document["expected_cost_ns"] = shortest(candidate.expected_cost_ns);
  }
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
  constexpr std::size_t kMaxShown = 5;
  const bool by_votes = std::isnan(candidates.front().expected_cost_ns);
  Table table({{"clip"},
               {"target"},
               {"direction", right},
               {by_votes ? "vote" : "expected cost, N s", right}});
  for (const models::Candidate& candidate :
       candidates.first(std::min(kMaxShown, candidates.size()))) {
    const models::ClipSummary& clip = selector.clips[static_cast<std::size_t>(candidate.clip)];
    const auto& annotation = clip.annotation;
    table.add({clip.name, annotation ? std::string(motion::name_of(annotation->target)) : "-",
               annotation ? fixed(motion::degrees(double{annotation->direction}), 0) : "-",
               fixed(double{by_votes ? candidate.vote : candidate.expected_cost_ns}, 3)});
  }
  const models::ClipSummary& best =
      selector.clips[static_cast<std::size_t>(candidates.front().clip)];
  std::cout << printable(best.name) << ": for a threat to the " << threat.target << " from "
            << fixed(threat.azimuth, 0) << " degrees in " << fixed(threat.time_to_impact_s, 2)
            << " s\n\n"
            << table.text();
  if (candidates.size() > kMaxShown)
    std::cout << "and " << candidates.size() - kMaxShown << " more (--json lists all)\n";
}

void run_select(const SelectOptions& options) {
  const models::Selector selector = load_selector_file(options.selector).selector;
  const features::ThreatDescription threat = described(options.threat, selector.target_centres);
  const std::pmr::vector<models::Candidate> candidates = models::candidates(
      selector, train::described_features(selector.layout, threat, selector.target_centres),
      threat.target);
  if (options.json) {
    print(document_of(selector, options.threat, candidates));
  } else {
    print_text(selector, options.threat, candidates);
  }
}

}  // namespace

Command select_command() {
  auto options = std::make_shared<SelectOptions>();
  return {.name = "select",
          .summary = "Ask a selector for the clip to answer a threat with",
          .required = {{"SELECTOR", "selector made by flinch train", &options->selector}},
          .optional = join({threat_options(options->threat), {json_option(options->json)}}),
          .notes =
              "The character stands still, facing the front, until the impact.\n\n"
              "Example:\n  flinch select real.flinch --azimuth 40 --speed 24 --target head "
              "--time-to-impact 0.5",
          .run = [options] { run_select(*options); }};
}

}  // namespace flinch::program

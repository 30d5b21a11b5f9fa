// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <memory>

#include "models/selector.h"
#include "models/training_range.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "program/command.h"
#include "program/look_ahead_option.h"
#include "program/printable.h"
#include "program/table.h"
#include "program/threat_options.h"
#include "train/fit/selector_reader.h"
#include "train/scenario/scenario_sampling.h"

namespace flinch::program {

namespace {

struct SelectOptions {
  std::string selector;
  ThreatOptions threat;
  std::optional<int> look_ahead;
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

/// What of a threat is outside of the selector's training.
models::OutsideTrainings outside_of(const models::Selector& selector,
                                    const features::ThreatDescription& threat) {
  features::Scenario scenario;
  scenario.threat =
      features::threat_from_description(threat, selector.target_centres[threat.target], 0);
  scenario.target = threat.target;
  scenario.time_to_impact_s = threat.time_to_impact_s;
  return models::outside_training(selector, scenario);
}

Json outside_document(const models::OutsideTrainings& outside) {
  Json list = Json::array();
  for (const models::OutsideTraining& number : outside)
    list.push_back({{"name", number.name},
                    {"value", number.value},
                    {"trained", {number.trained.min, number.trained.max}}});
  return list;
}

void print_outside(const models::OutsideTrainings& outside) {
  for (const models::OutsideTraining& number : outside)
    std::cout << "outside training: " << number.name << ' ' << fixed(number.value, 3)
              << ", trained from " << fixed(number.trained.min, 3) << " to "
              << fixed(number.trained.max, 3) << '\n';
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

/// A candidate with what was foreseen of it; what is not known is left out.
Json foreseen_document(const models::Selector& selector,
                       const lookahead::ForeseenCandidate& candidate) {
  Json document = candidate_document(selector, candidate.candidate);
  document["foreseen"] = name_of(candidate.foreseen);
  const auto put = [&document](const char* key, float value) {
    if (std::isfinite(value)) document[key] = shortest(value);
  };
  put("work_j", candidate.work_j);
  put("damage_ns", candidate.damage_ns);
  put("cost_ns", candidate.cost_ns);
  put("contact_s", candidate.contact_s);
  return document;
}

void print_foreseen(const models::Selector& selector, const ThreatOptions& threat,
                    const lookahead::LookAheadStatus& status) {
  using enum Table::Align;
  Table table({{"candidate"},
               {"foreseen"},
               {"work, J", right},
               {"damage, N s", right},
               {"cost, N s", right},
               {"contact, s", right}});
  const auto number = [](float value, int decimals) {
    return std::isfinite(value) ? fixed(double{value}, decimals) : std::string("-");
  };
  const auto name_of_clip = [&selector](const lookahead::ForeseenCandidate& candidate) {
    return selector.clips[static_cast<std::size_t>(candidate.candidate.clip)].name;
  };
  for (const lookahead::ForeseenCandidate& candidate :
       std::span(status.candidates).first(status.count)) {
    const bool is_bound = candidate.foreseen == lookahead::Foreseen::costlier ||
                          candidate.foreseen == lookahead::Foreseen::cut;
    table.add({printable(name_of_clip(candidate)), name_of(candidate.foreseen),
               number(candidate.work_j, 0), number(candidate.damage_ns, 3),
               (is_bound ? "over " : "") + number(candidate.cost_ns, 3),
               number(candidate.contact_s, 3)});
  }
  std::cout << printable(name_of_clip(status.candidates[status.chosen])) << ": for a threat to the "
            << threat.target << " from " << fixed(threat.azimuth, 0) << " degrees in "
            << fixed(threat.time_to_impact_s, 2) << " s, of " << status.count << " candidates\n\n"
            << table.text();
}

/// Looks ahead as a game does whose character stands at the origin.
void run_look_ahead(const SelectOptions& options) {
  const runtime::Library library = train::load_runtime_library(options.selector);
  lookahead::LookAheadWorkspace workspace = look_ahead_workspace(library, options.selector);
  const models::Selector& selector = library.selector();
  const features::ThreatDescription threat = described(options.threat, selector);
  const features::Threat thrown =
      features::threat_from_description(threat, selector.target_centres[threat.target], 0);
  const runtime::Perception perception{{thrown, threat.target, threat.time_to_impact_s, {}}, 0};
  runtime::Character character(library);
  const lookahead::LookAheadStatus status =
      lookahead::perceive(character, perception, {.candidates = *options.look_ahead}, workspace);
  if (status.status != runtime::Status::ok) throw Error("", message_of(status.status));
  const models::OutsideTrainings outside = outside_of(selector, threat);
  if (!options.json) {
    print_foreseen(selector, options.threat, status);
    print_outside(outside);
    return;
  }
  Json list = Json::array();
  for (const lookahead::ForeseenCandidate& candidate :
       std::span(status.candidates).first(status.count))
    list.push_back(foreseen_document(selector, candidate));
  print({{"clip", list[status.chosen]["clip"]},
         {"target", options.threat.target},
         {"time_to_impact_s", options.threat.time_to_impact_s},
         {"encounters", status.encounters},
         {"outside_training", outside_document(outside)},
         {"candidates", list}});
}

void run_select(const SelectOptions& options) {
  if (options.look_ahead) {
    run_look_ahead(options);
    return;
  }
  const models::Selector selector = train::load_selector_file(options.selector).selector;
  const features::ThreatDescription threat = described(options.threat, selector);
  const std::pmr::vector<models::Candidate> candidates = models::candidates(
      selector, train::described_features(selector.layout, threat, selector.target_centres),
      threat.target);
  const models::OutsideTrainings outside = outside_of(selector, threat);
  if (options.json) {
    Json document = document_of(selector, options.threat, candidates);
    document["outside_training"] = outside_document(outside);
    print(document);
  } else {
    print_text(selector, options.threat, candidates);
    print_outside(outside);
  }
}

}  // namespace

Command select_command() {
  auto options = std::make_shared<SelectOptions>();
  return {.name = "select",
          .summary = "Ask a selector for the clip to answer a threat with",
          .required = {{"SELECTOR", "selector made by flinch train", &options->selector}},
          .optional = join({threat_options(options->threat),
                            {look_ahead_option(options->look_ahead), json_option(options->json)}}),
          .notes =
              "The character stands still, facing the front, until the impact.\n\n"
              "Example:\n  flinch select real.flinch --azimuth 40 --speed 24 --target head "
              "--time-to-impact 0.5",
          .run = [options] { run_select(*options); }};
}

}  // namespace flinch::program

// SPDX-License-Identifier: MIT
#include "evolve/run/evolution_file.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "database/files/file_io.h"
#include "motion/error.h"

namespace flinch::evolve {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxGenerations = 100'000;  // of all runs; `flinch evolve` makes fewer

bool is_chromosome(const Json& json, std::size_t gene_count) {
  return json.is_array() && json.size() == gene_count &&
         std::ranges::all_of(json, [](const Json& gene) {
           return gene.is_number_unsigned() && gene.get<std::uint64_t>() <= kMaxGene;
         });
}

bool is_record(const Json& json, std::size_t gene_count) {
  return json.is_array() && json.size() == 4 && json[0].is_number() && json[1].is_number() &&
         is_chromosome(json[2], gene_count) && json[3].is_number();
}

bool is_history(const Json& json, std::size_t gene_count) {
  return json.is_array() &&
         std::ranges::all_of(json, [&](const Json& r) { return is_record(r, gene_count); });
}

bool is_finished(const Json& json, std::size_t gene_count) {
  return json.is_array() && json.size() == 2 &&
         (json[0].is_null() || is_chromosome(json[0], gene_count)) &&
         is_history(json[1], gene_count);
}

bool is_sound(const Json& json, std::size_t population, std::size_t gene_count) {
  for (const char* list : {"finished", "history", "chromosomes"})
    if (!json.contains(list) || !json[list].is_array()) return false;
  const Json& chromosomes = json["chromosomes"];
  const bool is_between_runs = chromosomes.empty() && json["history"].empty();
  return (chromosomes.size() == population || is_between_runs) &&
         is_history(json["history"], gene_count) &&
         std::ranges::all_of(json["finished"],
                             [&](const Json& f) { return is_finished(f, gene_count); }) &&
         std::ranges::all_of(chromosomes,
                             [&](const Json& c) { return is_chromosome(c, gene_count); });
}

Json document_of(const std::vector<GenerationRecord>& history) {
  Json document = Json::array();
  for (const GenerationRecord& record : history)
    document.push_back(
        {record.best_fitness, record.mean_fitness, record.best, record.check_fitness});
  return document;
}

std::vector<GenerationRecord> history_in(const Json& json) {
  std::vector<GenerationRecord> history;
  for (const Json& record : json)
    history.push_back({record[0].get<double>(), record[1].get<double>(),
                       record[2].get<Chromosome>(), record[3].get<double>()});
  return history;
}

}  // namespace

void write_evolution(const std::string& path, const std::string& key,
                     const EvolutionSeries& series) {
  Json finished = Json::array();
  for (const EvolutionSeries::Finished& run : series.finished)
    finished.push_back({run.kept ? Json(*run.kept) : Json(), document_of(run.history)});
  const Json json{{"kind", "evolution"},
                  {"key", key},
                  {"finished", finished},
                  {"history", document_of(series.current.history)},
                  {"chromosomes", series.current.chromosomes}};
  database::write_file_atomically(path, json.dump() + "\n");
}

std::optional<EvolutionSeries> read_evolution(const std::string& path, const std::string& key,
                                              std::size_t population, std::size_t gene_count) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  const std::string text = database::read_file(path);
  if (!text.starts_with(kEvolutionMark)) throw Error(path, "is no unfinished evolution");
  // Deep nesting would overflow the stack, and many small values take twenty times the memory of
  // the file, before is_sound() could refuse them.
  const std::size_t max_events = 16 + (gene_count + 10) * (population + kMaxGenerations);
  std::size_t events = 0;
  bool is_bounded = true;
  const auto require_bounded = [&](int depth, Json::parse_event_t, const Json&) {
    is_bounded = is_bounded && depth <= 6 && ++events <= max_events;
    return is_bounded;
  };
  const Json json = Json::parse(text, require_bounded, false);
  if (!is_bounded || !json.is_object() || !json.contains("key") || !json["key"].is_string())
    throw Error(path, "the unfinished evolution is damaged; remove the file to begin anew");
  if (json["key"].get<std::string>() != key)
    throw Error(path,
                "an evolution with other options is unfinished here; run that command again, or "
                "remove the file to begin anew");
  if (!is_sound(json, population, gene_count))
    throw Error(path, "the unfinished evolution is damaged; remove the file to begin anew");
  EvolutionSeries series;
  for (const Json& run : json["finished"]) {
    EvolutionSeries::Finished& finished = series.finished.emplace_back();
    if (!run[0].is_null()) finished.kept = run[0].get<Chromosome>();
    finished.history = history_in(run[1]);
  }
  series.current = {history_in(json["history"]),
                    json["chromosomes"].get<std::vector<Chromosome>>()};
  return series;
}

}  // namespace flinch::evolve

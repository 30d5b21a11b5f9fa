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

bool is_chromosome(const Json& json, std::size_t gene_count) {
  return json.is_array() && json.size() == gene_count &&
         std::ranges::all_of(json, [](const Json& gene) {
           return gene.is_number_unsigned() && gene.get<std::uint64_t>() <= kMaxGene;
         });
}

bool is_record(const Json& json, std::size_t gene_count) {
  return json.is_array() && json.size() == 3 && json[0].is_number() && json[1].is_number() &&
         is_chromosome(json[2], gene_count);
}

bool is_sound(const Json& json, std::size_t population, std::size_t gene_count) {
  if (!json.contains("history") || !json.contains("chromosomes")) return false;
  const Json& history = json["history"];
  const Json& chromosomes = json["chromosomes"];
  return history.is_array() && chromosomes.is_array() && chromosomes.size() == population &&
         std::ranges::all_of(history, [&](const Json& r) { return is_record(r, gene_count); }) &&
         std::ranges::all_of(chromosomes,
                             [&](const Json& c) { return is_chromosome(c, gene_count); });
}

}  // namespace

void write_evolution(const std::string& path, const std::string& key, const Evolution& evolution) {
  Json history = Json::array();
  for (const GenerationRecord& record : evolution.history)
    history.push_back({record.best_fitness, record.mean_fitness, record.best});
  const Json json{{"kind", "evolution"},
                  {"key", key},
                  {"history", history},
                  {"chromosomes", evolution.chromosomes}};
  database::write_file_atomically(path, json.dump() + "\n");
}

std::optional<Evolution> read_evolution(const std::string& path, const std::string& key,
                                        std::size_t population, std::size_t gene_count) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  const std::string text = database::read_file(path);
  if (!text.starts_with(kEvolutionMark)) throw Error(path, "is no unfinished evolution");
  // One level of nesting more than ours has would be refused below; deep nesting would overflow the
  // stack before.
  bool is_flat = true;
  const auto require_flat = [&is_flat](int depth, Json::parse_event_t, const Json&) {
    is_flat &= depth <= 4;
    return is_flat;
  };
  const Json json = Json::parse(text, require_flat, false);
  if (!is_flat || !json.is_object() || !json.contains("key") || !json["key"].is_string())
    throw Error(path, "the unfinished evolution is damaged; remove the file to begin anew");
  if (json["key"].get<std::string>() != key)
    throw Error(path,
                "an evolution with other options is unfinished here; run that command again, or "
                "remove the file to begin anew");
  if (!is_sound(json, population, gene_count))
    throw Error(path, "the unfinished evolution is damaged; remove the file to begin anew");
  Evolution evolution;
  for (const Json& record : json["history"])
    evolution.history.push_back(
        {record[0].get<double>(), record[1].get<double>(), record[2].get<Chromosome>()});
  evolution.chromosomes = json["chromosomes"].get<std::vector<Chromosome>>();
  return evolution;
}

}  // namespace flinch::evolve

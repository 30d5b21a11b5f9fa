// SPDX-License-Identifier: MIT
// Throws balls at a character through the C interface and writes the selector and what happened,
// which WebAssembly must repeat. Usage: js_native_throws FOLDER
#include <array>
#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "bindings/js/exports.h"
#include "database/author/authored_library.h"
#include "motion/default_character.h"
#include "tests/runtime/made_up_selector.h"
#include "tests/scenes/walk.h"

using namespace flinch;

namespace {

constexpr int kThrows = 1000;
constexpr int kHits = 40;
constexpr int kOracleThrows = 3;
constexpr float kFrame_s = 1.0F / 60;

tests::MadeUpSelector selector_with_costs(const database::ClipLibrary& library) {
  return tests::with_response_costs(tests::made_up_selector(library, 60, tests::ModelKind::knn));
}

void write(const std::string& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  if (!(file << bytes).flush()) throw std::runtime_error("cannot write " + path);
}

flinch_status checked(flinch_status status) {
  if (status < 0) throw std::runtime_error(flinch_status_message(status));
  return status;
}

/// Writes JSON: numbers that read back to the same bits.
class Json {
 public:
  explicit Json(std::ostream& out) : out_(out) { out_.precision(9); }
  void number(double value) { item() << value; }
  template <class Values>
  void numbers(const Values& values) {
    open('[');
    for (const auto value : values) number(static_cast<double>(value));
    close(']');
  }
  void key(const char* name) {
    item() << '"' << name << "\":";
    is_first_ = true;
  }
  void open(char bracket) {
    item() << bracket;
    is_first_ = true;
  }
  void close(char bracket) {
    out_ << bracket << '\n';
    is_first_ = false;
  }

 private:
  std::ostream& item() {
    if (!is_first_) out_ << ',';
    is_first_ = false;
    return out_;
  }

  std::ostream& out_;
  bool is_first_ = true;
};

/// A ball from anywhere around the character that passes within half a metre of its middle.
flinch_threat random_throw(std::mt19937_64& random) {
  const auto uniform = [&random](float low, float high) {
    return low + (high - low) * static_cast<float>(random() >> 40U) / static_cast<float>(1 << 24);
  };
  const float azimuth = uniform(-3.1F, 3.1F);
  const float distance_m = uniform(3, 9);
  const float flight_s = uniform(0.3F, 1.1F);
  flinch_threat threat{};
  threat.size = sizeof threat;
  const std::array from{distance_m * std::cos(azimuth), distance_m * std::sin(azimuth),
                        uniform(0.5F, 2)};
  const std::array to{uniform(-0.3F, 0.3F), uniform(-0.3F, 0.3F), uniform(0.3F, 1.8F)};
  for (std::size_t i = 0; i < 3; ++i) {
    threat.position[i] = from[i];
    threat.velocity[i] = (to[i] - from[i]) / flight_s;
  }
  threat.velocity[2] += 9.81F * flight_s / 2;
  threat.radius = uniform(0.03F, 0.2F);
  threat.mass_kg = uniform(0.1F, 1);
  return threat;
}

/// A character and what it needs, freed at the end of the program.
struct Scene {
  flinch_library* library = nullptr;
  flinch_workspace* workspace = nullptr;
  flinch_look_ahead* look_ahead = nullptr;
  flinch_oracle* oracle = nullptr;
  flinch_character* character = nullptr;

  explicit Scene(const std::string& file) {
    checked(flinch_library_load_memory(file.data(), file.size(), &library));
    checked(flinch_workspace_create(library, &workspace));
    checked(flinch_look_ahead_create(library, &look_ahead));
    checked(flinch_oracle_create(library, &oracle));
    checked(flinch_character_create_reacting(library, &character));
  }
  ~Scene() {
    flinch_character_free(character);
    flinch_oracle_free(oracle);
    flinch_look_ahead_free(look_ahead);
    flinch_workspace_free(workspace);
    flinch_library_free(library);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void reset() const { checked(flinch_character_place(character, 0, 0, 0, 0.5F)); }
  int clip() const {
    flinch_character_state state{};
    state.size = sizeof state;
    checked(flinch_character_describe(character, &state));
    return state.clip;
  }
  void write_pose(Json& json) const {
    flinch_pose pose{};
    pose.size = sizeof pose;
    checked(flinch_character_pose(character, &pose));
    json.open('[');
    for (const float value : pose.root_position) json.number(double{value});
    for (const auto& rotation : pose.rotation)
      for (const float value : rotation) json.number(double{value});
    json.close(']');
  }
  void play(int frames) const {
    for (int frame = 0; frame < frames; ++frame)
      checked(flinch_character_update(character, kFrame_s));
  }
};

void write_threat(Json& json, const flinch_threat& threat) {
  json.key("threat");
  json.open('[');
  for (const float value : threat.position) json.number(double{value});
  for (const float value : threat.velocity) json.number(double{value});
  json.number(double{threat.radius});
  json.number(double{threat.mass_kg});
  json.close(']');
}

/// What a throw does: its answer, the clip of the selector and of looking ahead, and two poses.
void write_throw(Json& json, const Scene& scene, const flinch_threat& threat) {
  json.open('{');
  write_threat(json, threat);
  scene.reset();
  flinch_look_ahead_options options{};
  options.size = sizeof options;
  options.candidates = 4;
  checked(flinch_character_look_ahead(scene.character, &threat, 1, &options, scene.look_ahead,
                                      nullptr));
  json.key("ahead");
  json.number(scene.clip());
  scene.reset();
  json.key("answer");
  json.number(checked(flinch_character_perceive(scene.character, &threat, scene.workspace)));
  json.key("clip");
  json.number(scene.clip());
  json.key("poses");
  json.open('[');
  for (int part = 0; part < 2; ++part) {
    scene.play(20);
    scene.write_pose(json);
  }
  json.close(']');
  json.close('}');
}

/// What the oracle finds: the costs of all clips, and the best.
void write_oracle(Json& json, const Scene& scene, const flinch_threat& threat) {
  std::array<flinch_trial, 256> trials{};
  std::int32_t count = 0;
  std::int32_t best = -1;
  json.open('{');
  write_threat(json, threat);
  scene.reset();
  if (checked(flinch_oracle_try_all(scene.oracle, scene.character, &threat, trials.data(),
                                    static_cast<std::int32_t>(trials.size()), &count, &best)) != 0)
    throw std::runtime_error("the oracle's throw misses");
  json.key("best");
  json.number(best);
  json.key("costs");
  json.open('[');
  for (int i = 0; i < count; ++i) json.number(double{trials[static_cast<std::size_t>(i)].cost_ns});
  json.close(']');
  json.close('}');
}

/// What a hit does to a character that stands still: the pose half a second after.
void write_hit(Json& json, const Scene& scene, flinch_threat threat) {
  for (std::size_t i = 0; i < 2; ++i) threat.position[i] = -0.12F * threat.velocity[i];
  threat.position[2] = 1.2F;
  threat.velocity[2] = 0;
  json.open('{');
  write_threat(json, threat);
  scene.reset();
  checked(flinch_character_react_to(scene.character, &threat));
  scene.play(30);
  flinch_reaction reaction{};
  reaction.size = sizeof reaction;
  checked(flinch_character_reaction(scene.character, &reaction));
  json.key("impulses");
  json.numbers(reaction.impulse_ns);
  json.key("pose");
  scene.write_pose(json);
  json.close('}');
}

void write_all(const std::string& folder) {
  const database::ClipLibrary authored = database::authored_library(motion::default_character());
  const tests::MadeUpSelector made = selector_with_costs(authored);
  const std::string file = made.file();
  write(folder + "/throws.flinch", file);
  write(folder + "/bare.flinch", train::selector_bytes(made.selector));
  write(folder + "/clips.flinchlib", made.library_file);
  write(folder + "/stances.flinch", selector_with_costs(tests::with_walk(authored)).file());
  std::ofstream out(folder + "/throws.json");
  const Scene scene(file);
  Json json(out);
  std::mt19937_64 random(1);
  std::vector<flinch_threat> threats(kThrows);
  for (flinch_threat& threat : threats) threat = random_throw(random);
  json.open('{');
  json.key("throws");
  json.open('[');
  for (const flinch_threat& threat : threats) write_throw(json, scene, threat);
  json.close(']');
  json.key("oracle");
  json.open('[');
  for (int i = 0; i < kOracleThrows; ++i) {
    flinch_threat threat = threats[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < 2; ++k) threat.velocity[k] = -threat.position[k] / 0.6F;
    threat.velocity[2] = (1.1F - threat.position[2]) / 0.6F + 9.81F * 0.3F;
    write_oracle(json, scene, threat);
  }
  json.close(']');
  json.key("hits");
  json.open('[');
  for (int i = 0; i < kHits; ++i) write_hit(json, scene, threats[static_cast<std::size_t>(i)]);
  json.close(']');
  json.close('}');
  if (!out.flush()) throw std::runtime_error("cannot write " + folder + "/throws.json");
}

}  // namespace

int main(int argument_count, char** arguments) try {
  if (argument_count != 2) throw std::runtime_error("usage: js_native_throws FOLDER");
  write_all(arguments[1]);
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}

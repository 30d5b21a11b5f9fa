// SPDX-License-Identifier: MIT
// What characters cost a game: a frame of an idling character, a frame of one in the costliest part
// of its response, a perceived threat, and a thousand characters at 60 Hz.
#include <benchmark/benchmark.h>

#include <random>

#include "database/author/authored_library.h"
#include "motion/default_character.h"
#include "runtime/character.h"
#include "runtime/response/prepared_library.h"
#include "tests/motion/random_motion.h"
#include "tests/runtime/loaded_selector.h"
#include "tests/scenes/walk.h"

namespace flinch::runtime {
namespace {

constexpr float kInstant_s = 1e-9F;  // an update that leaves the character unchanged
constexpr float kFrame_s = 1.0F / 60;

struct Loaded {
  Library library;
  Workspace workspace;
};

/// The authored clips with a model over made-up observations.
Loaded load(tests::ModelKind model) {
  Loaded made{tests::loaded_selector(2000, model), {}};
  if (!made.library.is_loaded() ||
      made.workspace.reserve_memory(made.library.selection_bytes()) != database::LoadStatus::ok) {
    std::abort();
  }
  return made;
}

Loaded& loaded() {
  static Loaded loaded = load(tests::ModelKind::svm);
  return loaded;
}

Loaded& loaded_with_network() {
  static Loaded loaded = load(tests::ModelKind::network);
  return loaded;
}

/// A ball that hits a character at `position` somewhere between shin and head.
features::Threat random_ball(std::mt19937& random, const Eigen::Vector2f& position) {
  features::ThreatDescription approach;
  approach.azimuth = tests::uniform(random, -3.1F, 3.1F);
  approach.elevation = tests::uniform(random, 0.1F, 0.5F);
  approach.speed_mps = tests::uniform(random, 8, 30);
  approach.time_to_impact_s = tests::uniform(random, 0.25F, 1.2F);
  const Eigen::Vector3f goal(position.x(), position.y(), tests::uniform(random, 0.4F, 1.7F));
  return features::threat_from_description(approach, goal, 0);
}

/// Whether a response is both blending and shifting weight at this time.
bool is_shifting_and_blending(const Character& character) {
  const float now_s = character.response_time_s();
  return character.phase() == Phase::blending &&
         std::ranges::any_of(character.response().shifts, [now_s](const WeightShift& shift) {
           return shift.interval.begin_s < now_s && now_s < shift.interval.end_s;
         });
}

std::vector<Character> shifting_and_blending_characters(std::size_t count) {
  std::mt19937 random(1);
  const Library& library = loaded().library;
  const auto clip_count = library.clip_library().clips.size();
  std::vector<Character> found;
  while (found.size() < count) {
    Character character(library);
    character.place({0, 0}, 0, tests::uniform(random, 0, 3));
    const auto clip = static_cast<int>(random() % clip_count);
    if (character.respond(clip, tests::uniform(random, 0.25F, 1.2F)) != Status::ok) continue;
    character.update(tests::uniform(random, 0.01F, 1));
    if (is_shifting_and_blending(character)) found.push_back(character);
  }
  return found;
}

void update_and_pose(benchmark::State& state, std::vector<Character>& characters) {
  std::size_t next = 0;
  for (auto _ : state) {
    Character& character = characters[next++ % characters.size()];
    character.update(kInstant_s);
    benchmark::DoNotOptimize(character.pose());
  }
  state.counters["bytes_a_character"] = sizeof(Character);
}

void frame_of_idle(benchmark::State& state) {
  std::mt19937 random(2);
  std::vector<Character> characters(64, Character(loaded().library));
  for (Character& character : characters)
    character.place({1, 2}, tests::uniform(random, -3, 3), tests::uniform(random, 0, 3));
  update_and_pose(state, characters);
}
BENCHMARK(frame_of_idle)->Unit(benchmark::kMicrosecond);

void frame_of_shift_and_blend(benchmark::State& state) {
  std::vector<Character> characters = shifting_and_blending_characters(256);
  update_and_pose(state, characters);
}
BENCHMARK(frame_of_shift_and_blend)->Unit(benchmark::kMicrosecond);

/// The same up to the frames of all joints, which a renderer needs.
void frame_of_shift_and_blend_with_kinematics(benchmark::State& state) {
  std::vector<Character> characters = shifting_and_blending_characters(256);
  const motion::Skeleton& skeleton = loaded().library.prepared().skeleton();
  std::size_t next = 0;
  for (auto _ : state) {
    Character& character = characters[next++ % characters.size()];
    character.update(kInstant_s);
    benchmark::DoNotOptimize(motion::forward_kinematics(skeleton, character.pose()));
  }
}
BENCHMARK(frame_of_shift_and_blend_with_kinematics)->Unit(benchmark::kMicrosecond);

/// From position and velocity to a planned response: prediction, selection, weight shift.
void perceive_and_plan(benchmark::State& state, Loaded& with) {
  std::mt19937 random(3);
  std::vector<features::Threat> balls;
  for (int i = 0; i < 512; ++i) balls.push_back(random_ball(random, {0, 0}));
  Character character(with.library);
  std::size_t next = 0;
  double answered = 0;
  for (auto _ : state) {
    character.place({0, 0}, 0, 0.5F);
    const Status status = character.perceive(balls[next++ % balls.size()], with.workspace);
    answered += status == Status::ok ? 1 : 0;
  }
  state.counters["answered"] = answered / static_cast<double>(state.iterations());
}
void perceive_and_plan(benchmark::State& state) {
  perceive_and_plan(state, loaded());
}
BENCHMARK(perceive_and_plan)->Unit(benchmark::kMicrosecond);

void perceive_and_plan_by_network(benchmark::State& state) {
  perceive_and_plan(state, loaded_with_network());
}
BENCHMARK(perceive_and_plan_by_network)->Unit(benchmark::kMicrosecond);

/// The stances of the authored library and a walk.
enum Stance { kIdle, kGuard, kWalk };

const PreparedLibrary& library_with_walk() {
  static const database::ClipLibrary clips =
      tests::with_walk(database::authored_library(motion::default_character()));
  static const PreparedLibrary prepared = prepare(clips);
  return prepared;
}

/// Only the planning, for any clip at any time, from any moment of a stance.
void plan(benchmark::State& state, Stance stance) {
  std::mt19937 random(5);
  struct Answer {
    int clip;
    float time_to_impact_s;
    float stance_time_s;
  };
  const PreparedLibrary& library = library_with_walk();
  std::vector<Answer> answers;
  while (answers.size() < 512) {
    const auto clip = static_cast<int>(random() % library.library->clips.size());
    const float time_to_impact_s = tests::uniform(random, 0.25F, 1.2F);
    const float stance_time_s = tests::uniform(random, 0, 2);
    if (library.library->clip(clip).annotation)
      answers.push_back({clip, time_to_impact_s, stance_time_s});
  }
  std::size_t next = 0;
  for (auto _ : state) {
    const Answer& answer = answers[next++ % answers.size()];
    const features::CharacterState there{answer.stance_time_s, {0, 0}, 0, stance};
    benchmark::DoNotOptimize(make_response(library, there, answer.clip, answer.time_to_impact_s));
  }
}
BENCHMARK_CAPTURE(plan, from_idle, kIdle)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(plan, from_guard, kGuard)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(plan, from_walk, kWalk)->Unit(benchmark::kMicrosecond);

/// A frame of all characters, with a ball at each every three seconds: one iteration per frame.
void frame_of_a_thousand(benchmark::State& state) {
  constexpr std::size_t kCount = 1000;
  constexpr std::size_t kFramesPerBall = 180;
  std::mt19937 random(4);
  std::vector<Character> characters(kCount, Character(loaded().library));
  std::size_t frame = 0;
  double responding = 0;
  const auto play = [&] {
    for (std::size_t i = 0; i < kCount; ++i) {
      Character& character = characters[i];
      if ((frame + i * 7) % kFramesPerBall == 0) {
        character.perceive(random_ball(random, character.state().position), loaded().workspace);
      }
      character.update(kFrame_s);
      benchmark::DoNotOptimize(character.pose());
      responding += character.phase() == Phase::idle ? 0 : 1;
    }
    ++frame;
  };
  for (std::size_t i = 0; i < kFramesPerBall; ++i) play();  // until all characters respond
  responding = 0;
  for (auto _ : state) play();
  state.counters["responding"] = responding / static_cast<double>(state.iterations() * kCount);
  state.counters["percent_of_a_core_at_60_hz"] =
      benchmark::Counter(static_cast<double>(state.iterations()) / (60 * 100),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(frame_of_a_thousand)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flinch::runtime

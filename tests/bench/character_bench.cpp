// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <vector>

#include "database/authored_library.h"
#include "motion/default_character.h"
#include "runtime/character.h"
#include "tests/runtime/made_up_selector.h"

namespace flinch::runtime {
namespace {

constexpr float kFrame_s = 1.0F / 60;

const Library& library() {
  static const Library kLibrary = [] {
    const std::string file =
        tests::made_up_selector(database::authored_library(motion::default_character()), 2000,
                                tests::Fitted::svm)
            .file();
    Library loaded;
    loaded.load(std::as_bytes(std::span(file)));
    return loaded;
  }();
  return kLibrary;
}

// Clips that step, so that the weight is shifted while they blend in.
std::vector<int> stepping_clips() {
  std::vector<int> clips;
  const auto& all = library().clips().clips;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].kind == "sidestep" || all[i].kind == "lift") clips.push_back(static_cast<int>(i));
  }
  return clips;
}

float step(Character& character) {
  character.update(kFrame_s);
  return character.pose().root_position.x();
}

void frame_idle(benchmark::State& state) {
  Character character(library());
  for (auto unused : state) {
    (void)unused;
    benchmark::DoNotOptimize(step(character));
  }
}
BENCHMARK(frame_idle)->Unit(benchmark::kMicrosecond);

// From the beginning of the shift to the end of the blend, again and again.
void frame_with_weight_shift_and_blend(benchmark::State& state) {
  const std::vector<int> clips = stepping_clips();
  Character character(library());
  std::size_t next = 0;
  for (auto unused : state) {
    (void)unused;
    if (character.phase() != Phase::shifting && character.phase() != Phase::blending) {
      state.PauseTiming();
      character.place({0, 0}, 0, 0);
      character.respond(clips[next++ % clips.size()], 0.5F);
      while (character.phase() == Phase::waiting) character.update(kFrame_s);
      state.ResumeTiming();
    }
    benchmark::DoNotOptimize(step(character));
  }
}
BENCHMARK(frame_with_weight_shift_and_blend)->Unit(benchmark::kMicrosecond);

// One frame of all: at 60 Hz a core has 16.7 ms for it. Each answers a threat once in 2 s.
void frame_of_1000_characters(benchmark::State& state) {
  const std::vector<int> clips = stepping_clips();
  std::vector<Character> characters(1000, Character(library()));
  int frame = 0;
  for (auto unused : state) {
    (void)unused;
    for (std::size_t i = 0; i < characters.size(); ++i) {
      if ((static_cast<std::size_t>(frame) + i) % 120 == 0) {
        characters[i].respond(clips[i % clips.size()], 0.5F);
      }
      benchmark::DoNotOptimize(step(characters[i]));
    }
    ++frame;
  }
  state.counters["context_bytes"] = static_cast<double>(sizeof(Character));
}
BENCHMARK(frame_of_1000_characters)->Unit(benchmark::kMillisecond);

void perceive_predict_and_select(benchmark::State& state) {
  Workspace workspace;
  workspace.make_room(library().selection_bytes());
  Character character(library());
  const features::Threat threat{.position = {12, 3, 1.5F}, .velocity = {-24, -6, 2.2F}};
  for (auto unused : state) {
    (void)unused;
    character.place({0, 0}, 0, 0);
    if (character.perceive(threat, workspace) != Status::ok) state.SkipWithError("not answered");
  }
}
BENCHMARK(perceive_predict_and_select)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace flinch::runtime

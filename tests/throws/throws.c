/* SPDX-License-Identifier: MIT */
/* throws SELECTOR [LIBRARY]: throws balls at a character and prints what it does: a line with the
 * answer and the clip of each throw, and lines with numbers that may differ in their last digits.
 * Random numbers come of whole ones, so that all systems throw the same balls. A character of the
 * library, which has everyday motion, then walks about. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "flinch.h"

enum { THROWS = 300, HITS = 20, WALKS = 30, FRAMES = 20 };

static uint64_t state = 1;

static float uniform(float low, float high) {
  state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return low + (high - low) * (float)(state >> 40) / (float)(1 << 24);
}

static void check(flinch_status status) {
  if (status >= 0) return;
  fprintf(stderr, "throws: %s\n", flinch_status_message(status));
  exit(1);
}

/* A ball from 3 to 9 m away that passes within a third of a metre of the character's middle. */
static flinch_threat ball(void) {
  flinch_threat threat = {.size = sizeof threat};
  float x, y, square;
  do {
    x = uniform(-9, 9);
    y = uniform(-9, 9);
    square = x * x + y * y;
  } while (square < 9 || square > 81);
  const float from[3] = {x, y, uniform(0.5F, 2)};
  const float to[3] = {uniform(-0.3F, 0.3F), uniform(-0.3F, 0.3F), uniform(0.3F, 1.8F)};
  const float flight_s = uniform(0.3F, 1.1F);
  for (int i = 0; i < 3; ++i) {
    threat.position[i] = from[i];
    threat.velocity[i] = (to[i] - from[i]) / flight_s;
  }
  threat.velocity[2] += 9.81F * flight_s / 2;
  threat.radius = uniform(0.03F, 0.2F);
  threat.mass_kg = uniform(0.1F, 1);
  return threat;
}

static void print_clip(const flinch_character* character, const char* how, flinch_status answer) {
  flinch_character_state now = {.size = sizeof now};
  check(flinch_character_describe(character, &now));
  printf("%s %" PRId32 " %" PRId32 "\n", how, answer, now.clip);
}

static void print_pose(const flinch_pose* pose) {
  printf("pose");
  for (int i = 0; i < 3; ++i) printf(" %.9g", (double)pose->root_position[i]);
  for (int joint = 0; joint < FLINCH_JOINT_COUNT; ++joint)
    for (int i = 0; i < 4; ++i) printf(" %.9g", (double)pose->rotation[joint][i]);
  printf("\n");
}

static void play_and_print(flinch_character* character) {
  for (int frame = 0; frame < FRAMES; ++frame) check(flinch_character_update(character, 1.0F / 60));
  flinch_pose pose = {.size = sizeof pose};
  check(flinch_character_pose(character, &pose));
  print_pose(&pose);
}

/* Answers a threat by the steps of perceiving, and shows the plan on the way. */
static void answer_by_steps(flinch_character* character, const flinch_threat* threat,
                            flinch_workspace* workspace) {
  flinch_perception noticed = {.size = sizeof noticed};
  noticed.threat.size = sizeof noticed.threat;
  const flinch_status hits = flinch_character_notice(character, threat, &noticed);
  check(hits);
  printf("notices %" PRId32 " %" PRId32 "\n", hits, noticed.target);
  if (hits != FLINCH_OK) return;
  flinch_candidate best[FLINCH_MOST_CANDIDATES];
  int32_t count = 0;
  check(
      flinch_character_rank(character, &noticed, workspace, best, FLINCH_MOST_CANDIDATES, &count));
  flinch_plan plan = {.size = sizeof plan};
  check(flinch_character_plan(character, &noticed, best[0].clip, &plan));
  printf("pose %.9g %.9g %.9g %.9g %.9g %.9g\n", (double)plan.first_motion_s, (double)plan.begin_s,
         (double)plan.peak_s, (double)plan.end_s, (double)plan.duration_s,
         (double)plan.playback_rate);
  flinch_pose pose = {.size = sizeof pose};
  check(flinch_character_planned_pose(character, &noticed, best[0].clip, 0.3F, &pose));
  print_pose(&pose);
  print_clip(character, "answers",
             flinch_character_answer(character, &noticed, best[0].clip, best, count));
  play_and_print(character);
}

/* Takes a library without a selector; its character walks, and braces on the way. */
static void walk(const char* path) {
  static char bytes[1 << 24];
  FILE* file = fopen(path, "rb");
  const size_t byte_count = file == NULL ? 0 : fread(bytes, 1, sizeof bytes, file);
  if (file != NULL) fclose(file);
  flinch_library* library = NULL;
  flinch_motion_graph* graph = NULL;
  flinch_character* character = NULL;
  check(flinch_library_take(bytes, byte_count, &library));
  check(flinch_motion_graph_create(library, &graph));
  check(flinch_character_create(library, &character));
  check(flinch_character_walk(character, graph, 7, 0, 0, 3));
  for (int i = 0; i < WALKS; ++i) {
    const flinch_threat threat = ball();
    play_and_print(character);
    print_clip(character, "braces", flinch_character_brace(character, &threat, 0));
  }
  flinch_character_free(character);
  flinch_motion_graph_free(graph);
  flinch_library_free(library);
}

int main(int count, char** arguments) {
  if (count != 2 && count != 3) {
    fprintf(stderr, "Usage: throws SELECTOR [LIBRARY]\n");
    return 2;
  }
  flinch_library* library = NULL;
  flinch_workspace* workspace = NULL;
  flinch_look_ahead* look_ahead = NULL;
  flinch_character* character = NULL;
  check(flinch_library_load(arguments[1], &library));
  check(flinch_workspace_create(library, &workspace));
  check(flinch_look_ahead_create(library, &look_ahead));
  check(flinch_character_create_reacting(library, &character));
  for (int i = 0; i < THROWS; ++i) {
    const flinch_threat threat = ball();
    check(flinch_character_place(character, 0, 0, 0, 0.5F));
    print_clip(character, "perceives", flinch_character_perceive(character, &threat, workspace));
    play_and_print(character);
    play_and_print(character);
  }
  for (int i = 0; i < HITS; ++i) {
    const flinch_threat threat = ball();
    const flinch_look_ahead_options options = {.size = sizeof options, .candidates = 4};
    check(flinch_character_place(character, 0, 0, 0, 0.5F));
    print_clip(character, "looks ahead",
               flinch_character_look_ahead(character, &threat, 1, &options, look_ahead, NULL));
    check(flinch_character_place(character, 0, 0, 0, 0.5F));
    check(flinch_character_react_to(character, &threat));
    play_and_print(character);
    play_and_print(character);
    check(flinch_character_place(character, 0, 0, 0, 0.5F));
    answer_by_steps(character, &threat, workspace);
  }
  flinch_character_free(character);
  flinch_look_ahead_free(look_ahead);
  flinch_workspace_free(workspace);
  flinch_library_free(library);
  if (count == 3) walk(arguments[2]);
  return 0;
}

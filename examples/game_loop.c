/* SPDX-License-Identifier: MIT */
/* A game loop in C: two people stand side by side, a ball flies at one of them, who looks ahead
 * before choosing an answer, and the loop prints what both do. Usage: game_loop SELECTOR, which
 * `flinch train` makes.
 *
 * Left out: drawing, and what happens when the ball hits. */
#include <flinch.h>
#include <stdio.h>

#define COUNT 2

static int failures;

/* Statuses below 0 are errors; FLINCH_MISSES is a valid result. */
static flinch_status checked(const char* what, flinch_status status) {
  if (status < 0) {
    fprintf(stderr, "game_loop: %s: %s\n", what, flinch_status_message(status));
    ++failures;
  }
  return status;
}

/* A ball from (9, 1) that reaches the head of the person at (0, 0) in 0.45 s under gravity. */
static flinch_threat thrown_ball(void) {
  const float flight_s = 0.45f;
  flinch_threat ball = {.size = sizeof ball, .radius = 0.105f, .mass_kg = 0.27f};
  ball.position[0] = 9;
  ball.position[1] = 1;
  ball.position[2] = 1.4f;
  ball.velocity[0] = -9 / flight_s;
  ball.velocity[1] = -1 / flight_s;
  ball.velocity[2] = (1.65f - 1.4f) / flight_s + 9.81f * flight_s / 2;
  return ball;
}

static float head_height(const flinch_library* library, const flinch_character* character) {
  const int head = 4;
  flinch_pose pose = {.size = sizeof pose};
  flinch_joint_frames frames = {.size = sizeof frames};
  checked("pose", flinch_character_pose(character, &pose));
  checked("joint frames", flinch_library_joint_frames(library, &pose, &frames));
  return frames.position[head][2];
}

static flinch_character_state state_of(const flinch_character* character) {
  flinch_character_state state = {.size = sizeof state};
  checked("describe", flinch_character_describe(character, &state));
  return state;
}

static void print_person(const flinch_library* library, const flinch_character* character,
                         int number, float time_s) {
  const flinch_character_state state = state_of(character);
  flinch_clip clip = {.size = sizeof clip};
  checked("clip", flinch_library_clip(library, state.clip, &clip));
  printf("%5.2f s  person %d  %-10s  %-36s  head at %.2f m\n", (double)time_s, number,
         flinch_phase_name(state.phase), clip.name, (double)head_height(library, character));
}

/* Simulates what the best clips would do, answers with the cheapest, and prints why. */
static flinch_status look_ahead_at(flinch_character* character, flinch_look_ahead* look_ahead,
                                   const flinch_threat* ball) {
  const flinch_look_ahead_options options = {.size = sizeof options, .candidates = 8};
  flinch_look_ahead_status found = {.size = sizeof found};
  const flinch_status status =
      flinch_character_look_ahead(character, ball, 1, &options, look_ahead, &found);
  for (int i = 0; status == FLINCH_OK && i < found.candidate_count; ++i) {
    const flinch_foreseen* candidate = &found.candidate[i];
    printf("%s clip %3d: %-9s  damage %6.3f N s, work %4.0f J, cost %6.3f N s\n",
           i == found.chosen ? "->" : "  ", (int)candidate->clip,
           flinch_foreseen_name(candidate->foreseen), (double)candidate->damage_ns,
           (double)candidate->work_j, (double)candidate->cost_ns);
  }
  return status;
}

/* One frame: perceives the ball if it is thrown now, then updates. Returns the new phase. */
static int32_t step(flinch_character* character, flinch_look_ahead* look_ahead,
                    const flinch_threat* ball, float dt_s) {
  if (ball != NULL) {
    const flinch_status seen = look_ahead_at(character, look_ahead, ball);
    printf("a ball is thrown: %s\n", flinch_status_message(checked("look ahead", seen)));
  }
  checked("update", flinch_character_update(character, dt_s));
  return state_of(character).phase;
}

int main(int argument_count, char** arguments) {
  const flinch_threat ball = thrown_ball();
  flinch_library* library = NULL;
  flinch_look_ahead* look_ahead = NULL; /* one per thread */
  flinch_character* person[COUNT] = {NULL, NULL};
  int32_t phase[COUNT] = {FLINCH_IDLE, FLINCH_IDLE};
  int answers[COUNT] = {0, 0};
  int is_thrown = 0;
  float time_s = 0;
  if (argument_count != 2) return fputs("usage: game_loop SELECTOR\n", stderr), 2;
  if (checked(arguments[1], flinch_library_load(arguments[1], &library)) != FLINCH_OK) return 1;
  checked("look ahead", flinch_look_ahead_create(library, &look_ahead));
  for (int i = 0; i < COUNT; ++i) {
    checked("character", flinch_character_create(library, &person[i]));
    checked("place", flinch_character_place(person[i], 0, -3.0f * (float)i, 0, 0.7f * (float)i));
  }

  printf("flinch %s\n", flinch_version());
  for (int frame = 0; time_s < 4; ++frame) {
    const float dt_s = frame % 3 == 0 ? 1.0f / 30 : 1.0f / 144; /* uneven, as in games */
    const int throws = !is_thrown && time_s >= 0.5f;
    time_s += dt_s;
    for (int i = 0; i < COUNT; ++i) {
      const int32_t before = phase[i];
      phase[i] = step(person[i], look_ahead, throws ? &ball : NULL, dt_s);
      if (phase[i] != before) print_person(library, person[i], i, time_s);
      answers[i] += phase[i] == FLINCH_PROTECTING && before != phase[i];
    }
    is_thrown |= throws;
  }

  for (int i = 0; i < COUNT; ++i) {
    checked("free", flinch_character_free(person[i]));
  }
  checked("free", flinch_look_ahead_free(look_ahead));
  checked("free", flinch_library_free(library));
  printf("answers: %d and %d\n", answers[0], answers[1]);
  return failures == 0 && answers[0] == 1 && answers[1] == 0 && phase[0] == FLINCH_IDLE ? 0 : 1;
}

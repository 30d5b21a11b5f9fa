/* SPDX-License-Identifier: MIT */
#ifndef FLINCH_JS_EXPORTS_H
#define FLINCH_JS_EXPORTS_H

/*
 * What flinch.wasm exports beside the C interface, by the same rules. No game should call these:
 * the oracle allocates and takes tenths of a second, and the layout is for languages that cannot
 * include a header of C.
 */

#include "runtime/c/flinch.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The structs of both headers as this build lays them out, in JSON:
 * {"flinch_pose": {"size": 352, "fields": {"root_position": {"offset": 4, "type": "f32", "count":
 * 3}, ...}}, ...}. A type is "i32", "u32" or "f32", "pointer", or the name of another struct;
 * arrays of arrays are flat. Never NULL. */
FLINCH_API const char* flinch_layout(void);

/* A surface for drawing the figure as a person. */
typedef struct flinch_skin flinch_skin;
/* Makes the surface of a library's character; takes about a millisecond. */
FLINCH_API flinch_status flinch_skin_create(const flinch_library* library, flinch_skin** out);
/* Frees it. */
FLINCH_API flinch_status flinch_skin_free(flinch_skin* skin);

#define FLINCH_SKIN_JOINTS 4 /* that move a vertex */
#define FLINCH_COVERINGS 7   /* skin, hair, eyes, lips, shirt, trousers, shoes */

/* Closed surfaces of triangles in the rest pose. A vertex v moves with its joints: with their
 * positions p and orientations R, and r their positions at rest, where all orientations are the
 * identity, v' = sum of w (p + R (v - r)). The arrays belong to the skin. */
typedef struct flinch_skin_mesh {
  uint32_t size;
  int32_t vertex_count;
  const float* position; /* 3 per vertex, m */
  const float* normal;   /* 3 per vertex, unit, outward */
  const uint8_t* joint;  /* FLINCH_SKIN_JOINTS per vertex */
  const float* weight;   /* FLINCH_SKIN_JOINTS per vertex, 0 or more, sum 1 */
  /* Of each covering, three vertices per triangle, counter-clockwise from outside. */
  const uint32_t* triangle[FLINCH_COVERINGS];
  int32_t triangle_count[FLINCH_COVERINGS];
} flinch_skin_mesh;
/* Writes the above to `out`. */
FLINCH_API flinch_status flinch_skin_describe(const flinch_skin* skin, flinch_skin_mesh* out);

/* Simulates what every clip would do: the best choice that is possible. Immutable. */
typedef struct flinch_oracle flinch_oracle;
/* Makes an oracle. FLINCH_WITHOUT_COSTS for a selector of an earlier version. */
FLINCH_API flinch_status flinch_oracle_create(const flinch_library* library, flinch_oracle** out);
/* Frees it. */
FLINCH_API flinch_status flinch_oracle_free(flinch_oracle* oracle);

/* How the selector weighs work against damage, in N s (docs/cost.md):
 * cost = (1 - brawn) damage + brawn work_weight_ns_per_j work. This struct will not grow. */
typedef struct flinch_costs {
  float brawn;
  float work_weight_ns_per_j;
} flinch_costs;
/* Writes the above to `out`. */
FLINCH_API flinch_status flinch_oracle_costs(const flinch_oracle* oracle, flinch_costs* out);

/* What a threat does to a character that answers it with a clip. This struct will not grow. */
typedef struct flinch_trial {
  int32_t clip;
  float work_j;                        /* of the whole response */
  float damage_ns;                     /* impulses by the vulnerability of each body */
  float cost_ns;                       /* of both: what training minimises */
  float contact_s;                     /* of the first touch, s after perception; infinite: none */
  float impulse_ns[FLINCH_BODY_COUNT]; /* on each body */
} flinch_trial;

/* Simulates the response with one clip to a threat that the character notices now; the character
 * itself stays as it is. FLINCH_MISSES or FLINCH_UNNOTICED where there is nothing to answer,
 * FLINCH_BAD_CLIP for a clip that cannot answer. */
FLINCH_API flinch_status flinch_oracle_try(const flinch_oracle* oracle,
                                           const flinch_character* character,
                                           const flinch_threat* threat, int32_t clip,
                                           flinch_trial* out);
/* The same for the idle clip and all clips that are allowed, in ascending order. Writes at most
 * `capacity` trials (FLINCH_BAD_INDEX if there are more), their number, and which of them is
 * best. */
FLINCH_API flinch_status flinch_oracle_try_all(const flinch_oracle* oracle,
                                               const flinch_character* character,
                                               const flinch_threat* threat, flinch_trial* out,
                                               int32_t capacity, int32_t* count, int32_t* best);

/* A scenario as training draws them (docs/program.md): a character stands at the origin, faces +X
 * and notices a ball that will hit this target. This struct will not grow. */
typedef struct flinch_scenario {
  int32_t target;
  float time_to_impact_s;
  float idle_time_s; /* time of the idle clip, as in flinch_character_place */
  float position[3]; /* of the ball's centre, now, m */
  float velocity[3]; /* m/s */
  float radius;      /* m */
  float mass_kg;
} flinch_scenario;
/* Draws scenario `number` of a seed: that of `flinch simulate --seed`. */
FLINCH_API flinch_status flinch_scenario_draw(const flinch_library* library, uint32_t seed,
                                              uint32_t number, flinch_scenario* out);
/* The clip that the selector chooses in a scenario. FLINCH_BAD_INDEX for an unknown target,
 * FLINCH_BAD_THREAT for a ball or time that cannot be answered; so below. */
FLINCH_API flinch_status flinch_scenario_choose(const flinch_library* library,
                                                const flinch_scenario* scenario,
                                                flinch_workspace* workspace, int32_t* clip);
/* The clip that looking ahead at so many candidates chooses. */
FLINCH_API flinch_status flinch_scenario_look_ahead(const flinch_library* library,
                                                    const flinch_scenario* scenario,
                                                    int32_t candidates,
                                                    flinch_look_ahead* look_ahead, int32_t* clip);
/* The allowed clip with the nearest annotation. */
FLINCH_API flinch_status flinch_scenario_nearest_annotation(const flinch_library* library,
                                                            const flinch_scenario* scenario,
                                                            int32_t* clip);
/* As flinch_oracle_try_all, for the character of a scenario. */
FLINCH_API flinch_status flinch_oracle_try_scenario(const flinch_oracle* oracle,
                                                    const flinch_scenario* scenario,
                                                    flinch_trial* out, int32_t capacity,
                                                    int32_t* count, int32_t* best);

/* The pose of a clip at a time, s from its start: before it the first, after its end the last.
 * FLINCH_BAD_INDEX for an unknown clip, FLINCH_BAD_TIME for a time that is not finite. */
FLINCH_API flinch_status flinch_clip_pose(const flinch_library* library, int32_t clip, float time_s,
                                          flinch_pose* out);

/* The clip that games commonly script by hand: of the allowed clips that whose annotation is
 * nearest to the threat that the character notices now. The status as above. */
FLINCH_API flinch_status flinch_oracle_nearest_annotation(const flinch_oracle* oracle,
                                                          const flinch_character* character,
                                                          const flinch_threat* threat,
                                                          int32_t* clip);

/* A judge looks at pushed motions and says how good they are; each answer improves the estimate of
 * the next (docs/pushing.md). */
typedef struct flinch_labelling flinch_labelling;
/* Begins. `seed` decides which motions are drawn. FLINCH_BAD_PUSH for a library without pushes. */
FLINCH_API flinch_status flinch_labelling_create(const flinch_library* library, uint32_t seed,
                                                 flinch_labelling** out);
/* Frees it. */
FLINCH_API flinch_status flinch_labelling_free(flinch_labelling* labelling);

/* A pushed motion, as label files have it. Vectors are in the frame of the character's facing. This
 * struct will not grow. */
typedef struct flinch_push_example {
  int32_t state_clip; /* what the character does */
  float state_s;      /* when in that clip the push comes */
  int32_t place;      /* the pushed joint */
  float asked[3];     /* its velocity, m/s */
  int32_t response_clip;
  float turn;           /* of the response, radians */
  float taper;          /* w of theta, 1/m^2 */
  float deformation[3]; /* m of theta, m/s */
} flinch_push_example;
/* Takes labels of earlier sittings: motions and how good they are, 0 to 1. FLINCH_BAD_INDEX where a
 * clip, place or number cannot be one of this library; then none is taken. */
FLINCH_API flinch_status flinch_labelling_add(flinch_labelling* labelling,
                                              const flinch_push_example* examples,
                                              const float* qualities, int32_t count);

/* The motion that is judged now. This struct will not grow. */
typedef struct flinch_question {
  float estimate;       /* how good it will look, 0 to 1; negative where labels are too few */
  float push_s;         /* when the push comes, s from the first frame */
  int32_t frame_count;  /* at 60 Hz */
  int32_t label_count;  /* so far */
  int32_t compared;     /* of the last 50 answers, those that were estimated before */
  float same_side;      /* share of them that are good, or not, as was estimated */
  float mean_error;     /* of the estimates */
  int32_t is_agreement; /* 1: estimate and judge agree, the judge may stop */
} flinch_question;
/* Writes the above to `out`. */
FLINCH_API flinch_status flinch_labelling_question(const flinch_labelling* labelling,
                                                   flinch_question* out);
/* How it is made. */
FLINCH_API flinch_status flinch_labelling_example(const flinch_labelling* labelling,
                                                  flinch_push_example* out);
/* The pose of one of its frames. */
FLINCH_API flinch_status flinch_labelling_pose(const flinch_labelling* labelling, int32_t frame,
                                               flinch_pose* out);
/* Takes the judge's answer, 0 to 1, fits again, and draws the next motion. */
FLINCH_API flinch_status flinch_labelling_judge(flinch_labelling* labelling, float quality);
/* Draws another motion without an answer. */
FLINCH_API flinch_status flinch_labelling_skip(flinch_labelling* labelling);
/* Shows motion `number` of a seed in the test whether it is a recording (docs/pushing.md): `shown`
 * is 0 for one whose realism is estimated above 0.5 by the library's selector, 1 for one below, 2
 * for a recording as it is. FLINCH_BAD_PUSH for a selector without a realism model. */
FLINCH_API flinch_status flinch_labelling_study(flinch_labelling* labelling, uint32_t seed,
                                                uint32_t number, int32_t* shown, float* realism);
/* The library's hash as label files have it. Never NULL for a labelling. */
FLINCH_API const char* flinch_labelling_library(const flinch_labelling* labelling);

/* Twenty characters that walk about in a square, and push each other and are pushed by its walls
 * (docs/pushing.md): what examples/crowd.cpp records. */
typedef struct flinch_crowd flinch_crowd;
/* Makes it; `seed` decides places and walks. The same seed and frames give the same motion.
 * FLINCH_WITHOUT_PUSHES for a library without pushes or a selector without a realism model. */
FLINCH_API flinch_status flinch_crowd_create(const flinch_library* library, uint32_t seed,
                                             flinch_crowd** out);
/* Frees it. */
FLINCH_API flinch_status flinch_crowd_free(flinch_crowd* crowd);
/* Advances by `dt_s`, above 0 and at most 0.1 s. */
FLINCH_API flinch_status flinch_crowd_update(flinch_crowd* crowd, float dt_s);

/* Where they walk, and what has happened so far. This struct will not grow. */
typedef struct flinch_crowd_state {
  int32_t characters;
  float half_side_m;    /* of the square, whose centre is the origin */
  int32_t bumps;        /* of two characters */
  int32_t walls;        /* touched by a character */
  int32_t answered;     /* pushes by either, with a recorded response */
  int32_t physical;     /* by physics, since no response would look real */
  int32_t knocked_over; /* of those */
  int32_t push_count;   /* of the last frame */
} flinch_crowd_state;
/* Writes the above to `out`. */
FLINCH_API flinch_status flinch_crowd_describe(const flinch_crowd* crowd, flinch_crowd_state* out);
/* The joints of one character, world. */
FLINCH_API flinch_status flinch_crowd_joint_frames(const flinch_crowd* crowd, int32_t character,
                                                   flinch_joint_frames* out);

/* A push that a character took in the last frame. This struct will not grow. */
typedef struct flinch_crowd_push {
  int32_t character;
  int32_t is_physical; /* 1: physics answers it, 0: a recorded response */
  float at[2];         /* where the character's chest is, on the ground, m */
  float velocity[2];   /* that the pushed joint shall reach, m/s */
} flinch_crowd_push;
/* Push `index` of flinch_crowd_state's push_count. */
FLINCH_API flinch_status flinch_crowd_pushed(const flinch_crowd* crowd, int32_t index,
                                             flinch_crowd_push* out);

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: MIT */
#ifndef FLINCH_H
#define FLINCH_H

/*
 * Flinch's C interface: characters that see an impact coming. docs/embedding.md shows it in C, in
 * Python and in engines.
 *
 *   flinch_library    what `flinch train` writes: skeleton, clips and selector. Immutable.
 *   flinch_workspace  memory to think with. One for each thread that perceives.
 *   flinch_character  one character of a library: it perceives, answers, and comes back to idle.
 *
 * Units and frames. SI units, seconds, radians. The world is right-handed with Z up, the ground at
 * 0; a character whose facing is 0 looks along +X and has +Y at its left. Quaternions are unit, in
 * the order w, x, y, z. Places are within 1e6 m of the origin; what is farther is refused like what
 * is not finite.
 *
 * Errors. Functions that can fail return a status: 0 is success, above 0 are answers that are no
 * errors, below 0 the call was refused and has changed nothing, neither the handle nor what `out`
 * points to (but a handle that was to be made is set to NULL). Nothing is printed, no exception
 * leaves, and after any error the handles stay usable.
 *
 * Handles. Passing NULL for a handle or for `out` is FLINCH_NULL_POINTER, a handle of another kind
 * FLINCH_BAD_HANDLE. So is one that was freed, in builds with FLINCH_CHECK_HANDLES (debug builds
 * have it), which keep a few bytes of each freed handle for that; in others it is undefined.
 * Libraries are counted: one may be freed before its workspaces and characters, whose last one
 * takes it with it.
 *
 * Memory. Only the functions that load or create allocate, only those that free give back.
 *
 * Threads. Flinch has no global state and starts no thread. Any number of threads may use a library
 * at once. A workspace or a character is for one thread at a time; different ones are independent.
 *
 * Structs. Those that may grow begin with `size`, which the caller sets to sizeof the struct:
 *
 *   flinch_threat threat = {.size = sizeof threat};
 *
 * A program that was compiled with an older header passes a smaller size and is served: what it
 * does not know is taken as the default that the field names, or not written. A size that is above
 * this library's, below what the first version had, or no multiple of 4, is FLINCH_BAD_SIZE.
 */

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define FLINCH_API __attribute__((visibility("default")))
#else
#define FLINCH_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define FLINCH_JOINT_COUNT 21
#define FLINCH_MOST_CANDIDATES 8

typedef struct flinch_library flinch_library;
typedef struct flinch_workspace flinch_workspace;
typedef struct flinch_character flinch_character;

/* ---- Status ---------------------------------------------------------------------------------- */

typedef int32_t flinch_status;
enum {
  FLINCH_OK = 0,
  /* No errors: there is nothing to answer. */
  FLINCH_MISSES = 1,    /* the threat will hit nothing */
  FLINCH_UNNOTICED = 2, /* it escaped the character's perception */
  /* How a call was wrong. */
  FLINCH_NULL_POINTER = -1,
  FLINCH_BAD_HANDLE = -2,    /* freed, or of another kind */
  FLINCH_BAD_SIZE = -3,      /* of a struct */
  FLINCH_OTHER_LIBRARY = -4, /* character and workspace are of different libraries */
  FLINCH_BAD_INDEX = -5,     /* no such clip or target, or a capacity below 0 */
  FLINCH_BAD_CLIP = -6,      /* no such clip, or one without annotation, which cannot answer */
  FLINCH_BAD_THREAT = -7,    /* a number that is not finite or out of range */
  FLINCH_BAD_TIME = -8,      /* a time that is not positive and finite */
  FLINCH_BAD_POSE = -9,      /* a number that is not finite, a rotation that is not unit */
  FLINCH_BAD_PLACEMENT = -10,
  FLINCH_BAD_LIMITS = -11, /* of perception: not finite, or out of range */
  FLINCH_BAD_MASK = -12,   /* a weight that is not in [0, 1] */
  FLINCH_OUT_OF_MEMORY = -13,
  /* What was wrong with a file. */
  FLINCH_CANNOT_OPEN = -20,
  FLINCH_NOT_A_SELECTOR = -21, /* another kind of file */
  FLINCH_OTHER_VERSION = -22,  /* of the file format */
  FLINCH_DAMAGED = -23,        /* cut short, or changed */
  FLINCH_OTHER_LAYOUT = -24,   /* trained on other features than this build computes */
  FLINCH_WITHOUT_CLIPS = -25   /* a selector without its clips: train it again */
};

/* What it means, one line of English without a full stop. Never NULL, for any number. */
FLINCH_API const char* flinch_status_message(flinch_status status);

/* "MAJOR.MINOR.PATCH" of the library that runs. Before 1.0 another MINOR may change the interface;
 * the name of the shared library changes with it. */
FLINCH_API const char* flinch_version(void);

/* ---- Library --------------------------------------------------------------------------------- */

/* Loads what `flinch train` has written (FILE.flinch), verified whole before anything is used. */
FLINCH_API flinch_status flinch_library_load(const char* path, flinch_library** out);
/* The same from memory, which need not stay. */
FLINCH_API flinch_status flinch_library_load_memory(const void* bytes, size_t byte_count,
                                                    flinch_library** out);
/* NULL is nothing to free, for this and all other handles. */
FLINCH_API flinch_status flinch_library_free(flinch_library* library);

typedef struct flinch_library_info {
  uint32_t size;
  int32_t clip_count;
  int32_t idle_clip; /* index of the clip that characters stand in */
  float rate_hz;     /* of the clips' poses */
  float mass_kg;     /* of the character */
} flinch_library_info;
FLINCH_API flinch_status flinch_library_describe(const flinch_library* library,
                                                 flinch_library_info* out);

/* The joints: parents come before their children; 0 is the pelvis. The same for every library. */
FLINCH_API const char* flinch_joint_name(int32_t joint); /* NULL: no such joint */
FLINCH_API int32_t flinch_joint_parent(int32_t joint);   /* -1: none, or no such joint */

/* In the rest pose (all rotations identity) the character stands in a T-pose and faces +X, and
 * every joint's frame is parallel to the world's. */
typedef struct flinch_skeleton {
  uint32_t size;
  /* From the parent's joint in the parent's frame, m; the pelvis' above the ground. */
  float offset[FLINCH_JOINT_COUNT][3];
  /* From the joint to the far end of its segment in its own frame, m. */
  float tip[FLINCH_JOINT_COUNT][3];
} flinch_skeleton;
FLINCH_API flinch_status flinch_library_skeleton(const flinch_library* library,
                                                 flinch_skeleton* out);

/* What a threat aims at and a clip protects. */
enum { FLINCH_HEAD = 0, FLINCH_TRUNK = 1, FLINCH_PELVIS = 2, FLINCH_LEGS = 3 };
FLINCH_API const char* flinch_target_name(int32_t target); /* NULL: no such target */

/* Texts belong to the library and live as long as it does. */
typedef struct flinch_clip {
  uint32_t size;
  int32_t is_annotated; /* 0: it answers no threat, and what follows `duration_s` is 0 */
  const char* name;     /* unique in the library */
  const char* kind;     /* "block", "duck", ..., free text */
  float duration_s;
  int32_t target;   /* FLINCH_HEAD, ... */
  float direction;  /* of the threat from the character's facing, counter-clockwise, radians */
  int32_t degree;   /* 0 mild, 1 exaggerated */
  float onset_s;    /* when the protective movement begins */
  float peak_s;     /* when it protects most */
  float end_s;      /* when it is over */
  int32_t reserved; /* 0 */
} flinch_clip;
FLINCH_API flinch_status flinch_library_clip(const flinch_library* library, int32_t index,
                                             flinch_clip* out);

/* ---- Poses ----------------------------------------------------------------------------------- */

typedef struct flinch_pose {
  uint32_t size;
  float root_position[3]; /* of the pelvis joint, world, m */
  /* Relative to the parent's frame, the pelvis' to the world; w, x, y, z. */
  float rotation[FLINCH_JOINT_COUNT][4];
} flinch_pose;

typedef struct flinch_joint_frames {
  uint32_t size;
  float position[FLINCH_JOINT_COUNT][3];    /* world, m */
  float orientation[FLINCH_JOINT_COUNT][4]; /* world; w, x, y, z */
} flinch_joint_frames;
/* Where every joint of a pose is, in the world: forward kinematics. */
FLINCH_API flinch_status flinch_library_joint_frames(const flinch_library* library,
                                                     const flinch_pose* pose,
                                                     flinch_joint_frames* out);

/* ---- Characters ------------------------------------------------------------------------------ */

/* A workspace is several kilobytes that only perceiving needs, so it is apart from the characters:
 * a thread has one for all of its characters. */
FLINCH_API flinch_status flinch_workspace_create(const flinch_library* library,
                                                 flinch_workspace** out);
FLINCH_API flinch_status flinch_workspace_free(flinch_workspace* workspace);

/* It stands idling at the world's origin, facing +X. */
FLINCH_API flinch_status flinch_character_create(const flinch_library* library,
                                                 flinch_character** out);
FLINCH_API flinch_status flinch_character_free(flinch_character* character);

/* Where it stands, m, which way it faces, radians, and how far it is into its idle clip, s, which
 * makes neighbours differ. Ends any response. */
FLINCH_API flinch_status flinch_character_place(flinch_character* character, float x, float y,
                                                float facing, float idle_time_s);

/* Tells it that it does not idle but is in a motion of the game's: its pose now and `dt_s` (at
 * least 1e-4) before, world. The next response starts there with these velocities. Ends any
 * response; call it in every frame before `perceive` for as long as the game moves the character
 * itself. */
FLINCH_API flinch_status flinch_character_set_pose(flinch_character* character,
                                                   const flinch_pose* before,
                                                   const flinch_pose* now, float dt_s);

/* Goes back to idle from whatever it is doing. */
FLINCH_API flinch_status flinch_character_settle(flinch_character* character);

/* How far perception falls short of the truth. All 0: not at all. Each at least 0. */
typedef struct flinch_perception_limits {
  uint32_t size;
  float reaction_delay_s; /* until it can act on what it has seen */
  float bearing_noise;    /* of the direction in which it sees the threat, radians */
  float distance_noise;   /* as a fraction of the distance */
  float heading_noise;    /* of the direction of the threat's velocity, radians */
  float speed_noise;      /* as a fraction of the speed */
  float chance_to_fail;   /* that it does not notice a threat at all, at most 1 */
} flinch_perception_limits;
/* The same seed gives the same chance again; different seeds make characters differ. */
FLINCH_API flinch_status flinch_character_limit_perception(flinch_character* character,
                                                           const flinch_perception_limits* limits,
                                                           uint64_t seed);
/* A person's limits, who chooses among `choices` answers (below 1 counts as 1). */
FLINCH_API flinch_status flinch_human_limits(int32_t choices, flinch_perception_limits* out);

/* Something that approaches, now: a falling ball. `radius` and `mass_kg` may be left out by `size`;
 * then they are a volleyball's. */
typedef struct flinch_threat {
  uint32_t size;
  float position[3]; /* of its centre, world, m */
  float velocity[3]; /* world, m/s */
  float radius;      /* m; default 0.105 */
  float mass_kg;     /* default 0.27 */
} flinch_threat;

/* A threat of which only place and velocity are known: predicts whether, when and where it will
 * hit, and answers. FLINCH_MISSES and FLINCH_UNNOTICED where there is nothing to answer. */
FLINCH_API flinch_status flinch_character_perceive(flinch_character* character,
                                                   const flinch_threat* threat,
                                                   flinch_workspace* workspace);
/* A threat that the game knows to aim at `target` and to be there in `time_to_impact_s`, which is
 * above 0 and at most 100. */
FLINCH_API flinch_status flinch_character_perceive_known(flinch_character* character,
                                                         const flinch_threat* threat,
                                                         int32_t target, float time_to_impact_s,
                                                         flinch_workspace* workspace);
/* Answers with this clip, whatever the selector would say; the time as above. */
FLINCH_API flinch_status flinch_character_respond(flinch_character* character, int32_t clip,
                                                  float time_to_impact_s);

/* Lets `dt_s` pass. */
FLINCH_API flinch_status flinch_character_update(flinch_character* character, float dt_s);

/* The pose now. */
FLINCH_API flinch_status flinch_character_pose(const flinch_character* character, flinch_pose* out);

/* Which joints move by Flinch and which as the game has them. */
typedef struct flinch_mask {
  uint32_t size;
  float weight;                    /* of everything, 0 to 1 */
  float joint[FLINCH_JOINT_COUNT]; /* 0 to 1; the pelvis' is that of the whole body's place too */
} flinch_mask;
/* The game's own pose with Flinch's over it where the mask says so. `out` may be `game`. */
FLINCH_API flinch_status flinch_character_pose_over(const flinch_character* character,
                                                    const flinch_pose* game,
                                                    const flinch_mask* mask, flinch_pose* out);

/* What a character is doing. */
enum {
  FLINCH_IDLE = 0,       /* nothing answers anything */
  FLINCH_REACTING = 1,   /* it has perceived, and the delay of its reaction runs */
  FLINCH_WAITING = 2,    /* it knows its answer, and there is time yet */
  FLINCH_SHIFTING = 3,   /* shifts its weight before the clip begins */
  FLINCH_BLENDING = 4,   /* goes over into the clip */
  FLINCH_PROTECTING = 5, /* plays the clip */
  FLINCH_RETURNING = 6   /* on the way back to idle */
};
FLINCH_API const char* flinch_phase_name(int32_t phase); /* NULL: no such phase */

typedef struct flinch_character_state {
  uint32_t size;
  int32_t phase;          /* FLINCH_IDLE, ... */
  int32_t clip;           /* that answers; the idle clip where none does */
  int32_t target;         /* of the last threat that was perceived */
  float time_to_impact_s; /* negative after it; infinity where there is none */
  float position[2];      /* where it stands, or began its response, world, m */
  float facing;           /* radians */
} flinch_character_state;
FLINCH_API flinch_status flinch_character_describe(const flinch_character* character,
                                                   flinch_character_state* out);

/* A clip that the selector considered. This struct will not grow. */
typedef struct flinch_candidate {
  int32_t clip;
  float vote;             /* share of the votes cast, 0 to 1; 0 where costs are expected */
  float expected_cost_ns; /* what playing it is expected to cost, N s; not a number where clips are
                           * voted for */
} flinch_candidate;
/* What the selector considered for the last threat, best first: writes at most `capacity` of them,
 * and to `count` how many it wrote. There are never more than FLINCH_MOST_CANDIDATES. */
FLINCH_API flinch_status flinch_character_candidates(const flinch_character* character,
                                                     flinch_candidate* out, int32_t capacity,
                                                     int32_t* count);

#ifdef __cplusplus
}
#endif

#endif

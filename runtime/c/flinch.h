/* SPDX-License-Identifier: MIT */
#ifndef FLINCH_H
#define FLINCH_H

/*
 * Flinch's C interface: characters that see an impact coming. docs/embedding.md shows it in C, in
 * Python and in engines.
 *
 *   flinch_library    what `flinch train` writes: skeleton, clips and selector. Immutable.
 *   flinch_workspace  memory for choosing clips. One for each thread that perceives.
 *   flinch_character  one character of a library: it perceives, answers, and returns to idle.
 *   flinch_look_ahead memory for simulating what clips would do. One for each thread that looks
 * ahead.
 *
 * Units and frames. SI units, seconds, radians. The world is right-handed with Z up, the ground at
 * 0; a character whose facing is 0 looks along +X and has +Y at its left. Quaternions are unit, in
 * the order w, x, y, z. Characters are within 1e5 m of the origin, where floats are 8 mm apart, and
 * a threat's position, velocity, radius and mass within 1e6 m, m/s, m and kg; numbers beyond are
 * refused as those that are not finite are.
 *
 * Errors. Functions that can fail return a status. 0 is success; a status above 0 is an answer, not
 * an error; below 0 the call was refused and has changed nothing, neither the object nor what `out`
 * points to (except that a handle that was to be made is set to NULL). Flinch prints nothing and
 * throws no exception into the caller. After any error the handles stay usable.
 *
 * Handles. NULL for a handle or for `out` gives FLINCH_NULL_POINTER, a handle of another kind
 * FLINCH_BAD_HANDLE. A freed handle gives that too in builds with FLINCH_CHECK_HANDLES (debug
 * builds have it), which keep a few bytes of each freed handle; in other builds its use is
 * undefined. Libraries are reference-counted: you may free one before its workspaces and
 * characters; it then lives until the last of them is freed.
 *
 * Memory. Functions that load or create allocate, and those that may hand a body to physics
 * (flinch_character_react_to, and flinch_character_push of a character with reactions).
 *
 * Threads. Flinch has no global state and starts no thread. Any number of threads may use a library
 * at once. A workspace or a character is for one thread at a time; different ones are independent.
 *
 * Structs. Those that may grow begin with `size`, which the caller sets to sizeof the struct:
 *
 *   flinch_threat threat = {.size = sizeof threat};
 *
 * A program that was compiled with an older header passes a smaller size. The library then takes
 * the documented default for each field that the program does not know, or does not write the
 * field. A size above this library's, below the first version's, or not a multiple of 4 gives
 * FLINCH_BAD_SIZE.
 */

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__) && !defined(_WIN32)
#define FLINCH_API __attribute__((visibility("default")))
#else
#define FLINCH_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define FLINCH_JOINT_COUNT 21    /* joints of every skeleton */
#define FLINCH_BODY_COUNT 17     /* bodies of every figure */
#define FLINCH_MOST_CANDIDATES 8 /* candidates kept for each threat */
#define FLINCH_MOST_THREATS 256  /* threats of one call */

typedef struct flinch_library flinch_library;       /* see above */
typedef struct flinch_workspace flinch_workspace;   /* see above */
typedef struct flinch_character flinch_character;   /* see above */
typedef struct flinch_look_ahead flinch_look_ahead; /* see above */

/* ---- Status ---------------------------------------------------------------------------------- */

typedef int32_t flinch_status; /* one of the values below */
/* The results of calls. */
enum {
  FLINCH_OK = 0,
  /* Not errors: there is nothing to answer. */
  FLINCH_MISSES = 1,    /* the threat will hit nothing */
  FLINCH_UNNOTICED = 2, /* the character did not notice the threat */
  /* Answered, but unlike all threats that the selector was trained for. */
  FLINCH_OUTSIDE_TRAINING = 3,
  FLINCH_NO_GOOD_ANSWER = 4, /* no response to a push would look real */
  /* What was wrong with a call. */
  FLINCH_NULL_POINTER = -1,
  FLINCH_BAD_HANDLE = -2,     /* freed, or of another kind */
  FLINCH_BAD_SIZE = -3,       /* `size` of a struct */
  FLINCH_OTHER_LIBRARY = -4,  /* character and workspace are of different libraries */
  FLINCH_BAD_INDEX = -5,      /* no such clip or target, or a capacity or count out of range */
  FLINCH_BAD_CLIP = -6,       /* no such clip, or one without annotation, which cannot answer */
  FLINCH_BAD_THREAT = -7,     /* a number that is not finite or out of range */
  FLINCH_BAD_TIME = -8,       /* a time step that is not above 0 and at most 1e6 s */
  FLINCH_BAD_POSE = -9,       /* a number that is not finite, a rotation that is not unit */
  FLINCH_BAD_PLACEMENT = -10, /* a position beyond 1e5 m, another number beyond 1e6, not finite */
  FLINCH_BAD_LIMITS = -11,    /* of perception or of a reaction: not finite, or out of range */
  FLINCH_BAD_MASK = -12,      /* a weight that is not in [0, 1] */
  FLINCH_OUT_OF_MEMORY = -13,
  FLINCH_NOT_REACTING = -14,      /* the character was created without reactions */
  FLINCH_SIMULATION_FAILED = -15, /* of a hit; the character goes on without physics */
  FLINCH_BAD_PUSH = -16,          /* not at the upper body, or not 0.05 to 20 m/s fast */
  FLINCH_WITHOUT_PUSHES = -17,    /* the file has no pushes, or no realism model for them */
  FLINCH_WITHOUT_SELECTOR = -18,  /* clips that were taken without a selector, which chooses */
  /* What was wrong with a file. */
  FLINCH_CANNOT_OPEN = -20,
  FLINCH_NOT_A_SELECTOR = -21, /* another kind of file */
  FLINCH_OTHER_VERSION = -22,  /* of the file format */
  FLINCH_DAMAGED = -23,        /* cut short, changed, or with a value out of bounds */
  FLINCH_OTHER_LAYOUT = -24,   /* trained on other features than this build computes */
  FLINCH_WITHOUT_CLIPS = -25,  /* a selector without its clips: see flinch_library_load_beside */
  FLINCH_NOT_A_FILE = -26,     /* a folder, a pipe or a device */
  FLINCH_TOO_LARGE = -27,      /* larger than 1 GiB */
  FLINCH_WITHOUT_COSTS = -28,  /* a selector that does not know what clips cost: train it again */
  FLINCH_NOT_A_LIBRARY = -29,  /* another kind of file, where flinch_library_take wants clips */
  FLINCH_OTHER_CLIPS = -30,    /* a selector of another library than the one given */
  FLINCH_OTHER_CONTENT = -31   /* clips that are not those of the hash that the file names */
};

/* The status in words: one line of English without a full stop. Never NULL, for any number. */
FLINCH_API const char* flinch_status_message(flinch_status status);

/* The version of the running library, "MAJOR.MINOR.PATCH". Before 1.0 another MINOR may change the
 * interface; the name of the shared library then changes too. */
FLINCH_API const char* flinch_version(void);

/* ---- Library --------------------------------------------------------------------------------- */

/* Loads a file that `flinch train` has written (FILE.flinch). Verifies the whole file before using
 * any of it. */
FLINCH_API flinch_status flinch_library_load(const char* path, flinch_library** out);
/* The same from the file's bytes in memory, which are not needed afterwards. */
FLINCH_API flinch_status flinch_library_load_memory(const void* bytes, size_t byte_count,
                                                    flinch_library** out);
/* Takes the bytes of a library's file (FILE.flinchlib), which has clips and no selector: its
 * characters answer by rule (flinch_character_brace) or as they are told
 * (flinch_character_respond). What asks a selector gives FLINCH_WITHOUT_SELECTOR. */
FLINCH_API flinch_status flinch_library_take(const void* bytes, size_t byte_count,
                                             flinch_library** out);
/* Loads the bytes of a selector's file for the clips of `owner`, which both share from then on: so
 * selectors that `flinch train --without-clips` writes play from one library, in memory and on
 * disk. `owner` comes from any of these functions and may be freed before or after.
 * FLINCH_OTHER_CLIPS: the selector was trained for another library. */
FLINCH_API flinch_status flinch_library_load_beside(const void* bytes, size_t byte_count,
                                                    const flinch_library* owner,
                                                    flinch_library** out);
/* Frees a library. NULL is allowed and does nothing, here and for all other handles. */
FLINCH_API flinch_status flinch_library_free(flinch_library* library);

/* What a library holds. */
typedef struct flinch_library_info {
  uint32_t size;
  int32_t clip_count;
  int32_t idle_clip;  /* index of the clip that idle characters play */
  float rate_hz;      /* poses per second of the clips */
  float mass_kg;      /* of the character */
  int32_t kind_count; /* of threats that it was trained for; at least 1 */
} flinch_library_info;
/* Writes the above to `out`. */
FLINCH_API flinch_status flinch_library_describe(const flinch_library* library,
                                                 flinch_library_info* out);

/* The joints: parents come before their children; 0 is the pelvis. The same for every library. */
FLINCH_API const char* flinch_joint_name(int32_t joint); /* NULL: no such joint */
FLINCH_API int32_t flinch_joint_parent(int32_t joint);   /* -1: none, or no such joint */

/* Bone lengths. In the rest pose (all rotations identity) the character stands in a T-pose and
 * faces +X, and every joint's frame is parallel to the world's. */
typedef struct flinch_skeleton {
  uint32_t size;
  /* From the parent's joint in the parent's frame, m; the pelvis' above the ground. */
  float offset[FLINCH_JOINT_COUNT][3];
  /* From the joint to the far end of its segment in its own frame, m. */
  float tip[FLINCH_JOINT_COUNT][3];
} flinch_skeleton;
/* Writes the library's skeleton to `out`. */
FLINCH_API flinch_status flinch_library_skeleton(const flinch_library* library,
                                                 flinch_skeleton* out);

/* The bodies of the figure that balls hit: parents come before their children; 0 is the pelvis. */
FLINCH_API const char* flinch_body_name(int32_t body); /* NULL: no such body */

/* The outline and mass of a body, in the frame of the joint that moves it. */
typedef struct flinch_outline {
  uint32_t size;
  int32_t joint;         /* that moves it */
  int32_t is_box;        /* 1: `half_extents` holds; 0: a capsule along Z */
  float centre[3];       /* m */
  float orientation[4];  /* w, x, y, z */
  float radius;          /* of a capsule, m */
  float half_length;     /* of a capsule's axis, without the caps, m */
  float half_extents[3]; /* of a box, m */
  float mass_kg;
  float centre_of_mass[3]; /* m */
} flinch_outline;
/* Writes the outline of body number `body`, from 0 to FLINCH_BODY_COUNT - 1, to `out`. */
FLINCH_API flinch_status flinch_library_outline(const flinch_library* library, int32_t body,
                                                flinch_outline* out);

/* The parts of the body that threats aim at and clips protect. */
enum { FLINCH_HEAD = 0, FLINCH_TRUNK = 1, FLINCH_PELVIS = 2, FLINCH_LEGS = 3 };
FLINCH_API const char* flinch_target_name(int32_t target); /* NULL: no such target */

/* A clip of a library. Its texts belong to the library and live as long as it does. */
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
/* Writes clip number `index`, from 0 to clip_count - 1, to `out`. */
FLINCH_API flinch_status flinch_library_clip(const flinch_library* library, int32_t index,
                                             flinch_clip* out);

/* What a kind of threat is. */
enum {
  FLINCH_BALL = 0,
  FLINCH_BLADE = 1, /* thin; does not bounce */
  FLINCH_FIST = 2,  /* the end of a limb, which is driven along a stroke */
  FLINCH_ROD = 3    /* a bat or a stick: a capsule that is swung along a stroke or thrown */
};

/* A kind of threat that a library was trained for, and the ranges of its numbers: [0] the smallest,
 * [1] the largest. Its name belongs to the library. */
typedef struct flinch_kind {
  uint32_t size;
  int32_t shape; /* FLINCH_BALL, ... */
  const char* name;
  float radius[2];           /* m */
  float mass_kg[2];          /* of a fist, its effective mass */
  float speed_mps[2];        /* at the impact */
  float elevation[2];        /* above the horizontal that it comes from, at the impact, radians */
  float time_to_impact_s[2]; /* from perception */
  /* That a fist, or the striking point of a swung rod, moves before the impact; 0 for others. */
  float reach_m[2];
  float restitution;
  float friction;
  int32_t is_straight; /* 1: it flies straight; 0: it falls */
  int32_t reserved;    /* 0 */
  float length_m[2];   /* of a rod, from end to end; 0 for others */
} flinch_kind;
/* Writes kind number `index`, from 0 to kind_count - 1, to `out`. */
FLINCH_API flinch_status flinch_library_kind(const flinch_library* library, int32_t index,
                                             flinch_kind* out);

/* ---- Poses ----------------------------------------------------------------------------------- */

/* A pose: all that moves. */
typedef struct flinch_pose {
  uint32_t size;
  float root_position[3]; /* of the pelvis joint, world, m */
  /* Relative to the parent's frame, the pelvis' to the world; unit; w, x, y, z. */
  float rotation[FLINCH_JOINT_COUNT][4];
} flinch_pose;

/* Position and orientation of every joint. */
typedef struct flinch_joint_frames {
  uint32_t size;
  float position[FLINCH_JOINT_COUNT][3];    /* world, m */
  float orientation[FLINCH_JOINT_COUNT][4]; /* world; w, x, y, z */
} flinch_joint_frames;
/* Writes the joint frames of a pose to `out`: forward kinematics. */
FLINCH_API flinch_status flinch_library_joint_frames(const flinch_library* library,
                                                     const flinch_pose* pose,
                                                     flinch_joint_frames* out);

/* Writes the pose of clip number `clip` at `time_s` of it to `out`, interpolated; before its first
 * pose and after its last one, those. A clip begins with the pelvis above the world's origin, and
 * the character facing +X. */
FLINCH_API flinch_status flinch_library_clip_pose(const flinch_library* library, int32_t clip,
                                                  float time_s, flinch_pose* out);

/* ---- Characters ------------------------------------------------------------------------------ */

/* Makes a workspace: memory, up to a hundred kilobytes, that only perceiving needs. One serves all
 * characters of a thread. */
FLINCH_API flinch_status flinch_workspace_create(const flinch_library* library,
                                                 flinch_workspace** out);
/* Frees a workspace. */
FLINCH_API flinch_status flinch_workspace_free(flinch_workspace* workspace);

/* Makes a character that idles at the world's origin and faces +X. */
FLINCH_API flinch_status flinch_character_create(const flinch_library* library,
                                                 flinch_character** out);
/* Frees a character. */
FLINCH_API flinch_status flinch_character_free(flinch_character* character);

/* Puts the character at (x, y), m, turned by `facing`, radians counter-clockwise from +X, at
 * `idle_time_s` of its idle clip; different times make neighbours differ. Ends any response. */
FLINCH_API flinch_status flinch_character_place(flinch_character* character, float x, float y,
                                                float facing, float idle_time_s);

/* The same in stance number `stance`, from 0 on: 0 is the idle clip, the others are those of the
 * library, such as a guard or a walk. FLINCH_BAD_PLACEMENT: there is no such stance. */
FLINCH_API flinch_status flinch_character_place_in_stance(flinch_character* character, float x,
                                                          float y, float facing,
                                                          float stance_time_s, int32_t stance);
/* Changes to stance number `stance` smoothly, with steps where the feet need them. */
FLINCH_API flinch_status flinch_character_change_stance(flinch_character* character,
                                                        int32_t stance);
/* The index of the clip that stance number `stance` plays; -1: there is no such stance. */
FLINCH_API int32_t flinch_library_stance(const flinch_library* library, int32_t stance);

/* Reports the pose of a character that the game animates: `now`, and `before`, which it had `dt_s`
 * earlier (at least 1e-4); both in the world. The next response starts from `now` with these
 * velocities. Ends any response. Call it in each frame before `perceive` for as long as the game
 * animates the character. */
FLINCH_API flinch_status flinch_character_set_pose(flinch_character* character,
                                                   const flinch_pose* before,
                                                   const flinch_pose* now, float dt_s);

/* Puts the character into the state of `saved`, bit for bit, as for a saved game or a rewind; from
 * then on equal calls give equal bits. Both are characters of one library, without reactions to
 * hits (FLINCH_BAD_HANDLE: one has them). */
FLINCH_API flinch_status flinch_character_copy(flinch_character* character,
                                               const flinch_character* saved);

/* Stops the response and returns to idle smoothly. */
FLINCH_API flinch_status flinch_character_settle(flinch_character* character);

/* How a character's perception falls short of the truth. All 0: perfect. Each at least 0. */
typedef struct flinch_perception_limits {
  uint32_t size;
  float reaction_delay_s; /* from seeing a threat to acting on it */
  float bearing_noise;    /* of the direction from the eye to the threat, radians */
  float distance_noise;   /* of the distance and the speed together, a fraction */
  float heading_noise;    /* of the direction of the threat's velocity, radians */
  float speed_noise;      /* of the speed, a fraction */
  float chance_to_fail;   /* probability of not noticing a threat at all, at most 1 */
} flinch_perception_limits;
/* Makes perception imperfect. The same seed gives the same numbers; characters with different seeds
 * differ. */
FLINCH_API flinch_status flinch_character_limit_perception(flinch_character* character,
                                                           const flinch_perception_limits* limits,
                                                           uint64_t seed);
/* Writes the limits of a person who chooses among `choices` answers (below 1 counts as 1). */
FLINCH_API flinch_status flinch_human_limits(int32_t choices, flinch_perception_limits* out);

/* Something that approaches, as it is now. A `size` that leaves out `radius` and `mass_kg` makes
 * them a volleyball's. How it bounces, and whether it falls, is that of its kind. Every call checks
 * all of it. */
typedef struct flinch_threat {
  uint32_t size;
  float position[3]; /* of its centre, or of a swung rod's grip, world, m */
  float velocity[3]; /* world, m/s */
  float radius;      /* m, at least 0; default 0.105 */
  float mass_kg;     /* at least 0; default 0.27 */
  int32_t kind;      /* of those that the library was trained for; default 0 */
  /* Of a fist, which waits where it is, then moves straight at its velocity, and stops; it touches
   * nothing before and after. At least 0; default 0. A swung rod turns about its grip while that
   * moves so. */
  float starts_in_s;
  float lasts_s; /* from its start or, once it moves, from now */
  /* Of a rod only: its axis from butt to tip, a unit vector; how it turns, across the axis; and
   * from `position` to its ends, along the axis. Default 0, which is no rod. */
  float axis[3];             /* world */
  float angular_velocity[3]; /* world, rad/s */
  float to_butt_m;           /* at least 0; both together above 0 and at most 5 m */
  float to_tip_m;            /* at least 0 */
} flinch_threat;

/* Answers a threat of which only position and velocity are known: predicts whether, when and where
 * it will hit, chooses a clip and starts the response. FLINCH_MISSES or FLINCH_UNNOTICED where
 * there is nothing to answer. Costs tens of microseconds. */
FLINCH_API flinch_status flinch_character_perceive(flinch_character* character,
                                                   const flinch_threat* threat,
                                                   flinch_workspace* workspace);
/* Answers `count` threats that come at once: the most urgent one first and, when its impact is
 * over, the next. All have the `size` of the first. One that is refused refuses all. */
FLINCH_API flinch_status flinch_character_perceive_all(flinch_character* character,
                                                       const flinch_threat* threats, int32_t count,
                                                       flinch_workspace* workspace);
/* Answers a threat that the game knows to hit `target` in `time_to_impact_s`, which is above 0 and
 * at most 100. */
FLINCH_API flinch_status flinch_character_perceive_known(flinch_character* character,
                                                         const flinch_threat* threat,
                                                         int32_t target, float time_to_impact_s,
                                                         flinch_workspace* workspace);
/* Answers by the pose rules instead of a clip: predicts the impact as flinch_character_perceive
 * does, and braces against it. `startles`: 1 to flinch first, else 0. */
FLINCH_API flinch_status flinch_character_brace(flinch_character* character,
                                                const flinch_threat* threat, int32_t startles);
/* A number of a threat that is outside of the range that the library was trained for. This struct
 * will not grow. */
typedef struct flinch_outside {
  const char* name; /* "radius_m", "mass_kg", "speed_mps", ...; angles in degrees */
  float value;
  float trained[2]; /* the smallest and the largest */
  int32_t reserved; /* 0 */
} flinch_outside;
#define FLINCH_MOST_OUTSIDE 8 /* numbers that can be outside at once */
/* Tells whether `threat`, as it was when the character last perceived one, is outside of what the
 * library was trained for: FLINCH_OUTSIDE_TRAINING, or FLINCH_OK. Writes the numbers that are, at
 * most `capacity` of them, and their number to `count`. */
FLINCH_API flinch_status flinch_character_outside_training(const flinch_character* character,
                                                           const flinch_threat* threat,
                                                           flinch_outside* out, int32_t capacity,
                                                           int32_t* count);
/* Answers with clip number `clip`, whatever the selector would choose; the time as above. */
FLINCH_API flinch_status flinch_character_respond(flinch_character* character, int32_t clip,
                                                  float time_to_impact_s);

/* ---- Pushes (docs/pushing.md) ---------------------------------------------------------------- */

/* Pushes the character: the joint `joint` (chest, neck, head or an upper arm, by its number) shall
 * move with `velocity` (world, m/s, 0.05 to 20). Starts the recorded response that will look most
 * real when it is bent to this push, also during another. FLINCH_NO_GOOD_ANSWER where none would:
 * nothing changes then but the candidates. A character with reactions is moved by physics then,
 * with FLINCH_OK, unless it has been knocked over; see flinch_character_reaction. */
FLINCH_API flinch_status flinch_character_push(flinch_character* character, int32_t joint,
                                               const float velocity[3],
                                               flinch_workspace* workspace);

/* A response that could answer a push. This struct will not grow. */
typedef struct flinch_push_candidate {
  int32_t clip;
  float realism; /* how much it will look like a recording, 0 to 1 */
  float turn;    /* of the response against the character's facing, radians */
  float taper;   /* how fast the deformation declines over the body, 1/m^2 */
  /* Velocity that the deformation adds to the pushed joint, in the frame of the facing, m/s. */
  float deformation[3];
} flinch_push_candidate;
/* Writes the responses that the last push could have had, best first, at most `capacity` of them,
 * and their number to `count`. There are never more than FLINCH_MOST_CANDIDATES. */
FLINCH_API flinch_status flinch_character_push_candidates(const flinch_character* character,
                                                          flinch_push_candidate* out,
                                                          int32_t capacity, int32_t* count);

/* ---- Walking (docs/pushing.md) --------------------------------------------------------------- */

/* A graph of the moments of a library's everyday clips that can follow each other. */
typedef struct flinch_motion_graph flinch_motion_graph;
/* Makes the graph, which never changes; any threads may use it. Takes a few tenths of a second for
 * two minutes of everyday clips. FLINCH_BAD_CLIP: the library has none. */
FLINCH_API flinch_status flinch_motion_graph_create(const flinch_library* library,
                                                    flinch_motion_graph** out);
/* Frees a graph. Characters that walk by it go on. */
FLINCH_API flinch_status flinch_motion_graph_free(flinch_motion_graph* graph);
/* From now on the character moves about by the graph instead of idling: a random walk that `seed`
 * decides. It keeps to the circle about (x, y) as far as the graph has a way; INFINITY: anywhere.
 * It answers threats and pushes as before, and then walks on. Placing moves it along; settling,
 * another stance and a pose from the game end the walk. */
FLINCH_API flinch_status flinch_character_walk(flinch_character* character,
                                               const flinch_motion_graph* graph, uint64_t seed,
                                               float x, float y, float radius);

/* Advances the character by `dt_s`, above 0 and at most 1e6, which may differ from frame to frame.
 */
FLINCH_API flinch_status flinch_character_update(flinch_character* character, float dt_s);

/* Writes the current pose, world, to `out`. */
FLINCH_API flinch_status flinch_character_pose(const flinch_character* character, flinch_pose* out);

/* How much of each joint's motion comes from Flinch and how much from the game. */
typedef struct flinch_mask {
  uint32_t size;
  float weight; /* scales the weights of all joints, 0 to 1 */
  /* 0 (the game's motion) to 1 (Flinch's). The pelvis' weight applies to the position too. */
  float joint[FLINCH_JOINT_COUNT];
} flinch_mask;
/* Writes the game's pose with Flinch's laid over it by the mask. `out` may be `game`. */
FLINCH_API flinch_status flinch_character_pose_over(const flinch_character* character,
                                                    const flinch_pose* game,
                                                    const flinch_mask* mask, flinch_pose* out);

/* What a character is doing. */
enum {
  FLINCH_IDLE = 0,       /* answers no threat */
  FLINCH_REACTING = 1,   /* has perceived a threat; its reaction delay runs */
  FLINCH_WAITING = 2,    /* has chosen a clip; its first movement is still to come */
  FLINCH_SHIFTING = 3,   /* shifts its weight before the clip begins */
  FLINCH_BLENDING = 4,   /* blends from idle into the clip */
  FLINCH_PROTECTING = 5, /* plays the clip */
  FLINCH_RETURNING = 6,  /* blends back to idle */
  FLINCH_PUSHED = 7,     /* plays the response to a push */
  FLINCH_WALKING = 8     /* moves about by the motion graph */
};
FLINCH_API const char* flinch_phase_name(int32_t phase); /* NULL: no such phase */

/* What a character is doing, and where. */
typedef struct flinch_character_state {
  uint32_t size;
  int32_t phase;          /* FLINCH_IDLE, ... */
  int32_t clip;           /* index of the clip that answers, or of the idle clip; -1: by rule */
  int32_t target;         /* of the last threat that was perceived */
  float time_to_impact_s; /* negative after it; infinite without a threat */
  float position[2];      /* where it stands, or began its response, world, m */
  float facing;           /* radians */
} flinch_character_state;
/* Writes the above to `out`. */
FLINCH_API flinch_status flinch_character_describe(const flinch_character* character,
                                                   flinch_character_state* out);

/* A clip that the selector considered. This struct will not grow. */
typedef struct flinch_candidate {
  int32_t clip;
  float vote;             /* share of the votes cast, 0 to 1; 0 where costs are expected */
  float expected_cost_ns; /* expected cost of playing it, N s; not a number where the model votes */
} flinch_candidate;
/* Writes the clips that the selector considered for the last threat, best first, at most `capacity`
 * of them, and their number to `count`. There are never more than FLINCH_MOST_CANDIDATES. */
FLINCH_API flinch_status flinch_character_candidates(const flinch_character* character,
                                                     flinch_candidate* out, int32_t capacity,
                                                     int32_t* count);

/* ---- The steps of perceiving ----------------------------------------------------------------- */

/* A threat that a character has noticed: what an answer is planned and chosen for. Numbers out of
 * range give FLINCH_BAD_THREAT. */
typedef struct flinch_perception {
  uint32_t size;
  int32_t target;         /* that it will hit: FLINCH_HEAD, ... */
  float time_to_impact_s; /* from now, above 0 and at most 100 */
  float delay_s;          /* until the character can act, at least 0 */
  /* The character now: where it stands, m, its facing, radians, and the stance that it is in. */
  float position[2];
  float facing;
  float stance_time_s;
  int32_t stance;
  flinch_threat threat; /* as it is perceived; with a `size` of its own */
} flinch_perception;

/* Predicts the impact as flinch_character_perceive does, and counts as one: the next threat draws
 * other random numbers. Writes what was noticed to `out`, and answers nothing. */
FLINCH_API flinch_status flinch_character_notice(flinch_character* character,
                                                 const flinch_threat* threat,
                                                 flinch_perception* out);
/* The same for `count` threats at once: writes those that will hit, the most urgent first, at most
 * `capacity` of them and never more than 8, one after the other with the `size` of the first, and
 * their number to `noticed`. One threat that is refused refuses all. */
FLINCH_API flinch_status flinch_character_notice_all(flinch_character* character,
                                                     const flinch_threat* threats, int32_t count,
                                                     flinch_perception* out, int32_t capacity,
                                                     int32_t* noticed);
/* Writes the clips that the selector considers for what was noticed, best first, at most `capacity`
 * of them, and their number to `count`. */
FLINCH_API flinch_status flinch_character_rank(const flinch_character* character,
                                               const flinch_perception* perception,
                                               flinch_workspace* workspace, flinch_candidate* out,
                                               int32_t capacity, int32_t* count);

/* When a response would do what, in seconds after the reaction delay. */
typedef struct flinch_plan {
  uint32_t size;
  float first_motion_s; /* when it first differs from going on */
  float begin_s;        /* of the clip */
  float peak_s;         /* when the clip protects most */
  float end_s;          /* of the clip; the way back begins */
  float duration_s;     /* when the character idles again */
  float playback_rate;  /* seconds of the clip per second */
} flinch_plan;
/* Writes the plan of the response with clip number `clip` that flinch_character_answer would start.
 * FLINCH_MISSES: there is none, since the threat arrives before the delay is over. */
FLINCH_API flinch_status flinch_character_plan(const flinch_character* character,
                                               const flinch_perception* perception, int32_t clip,
                                               flinch_plan* out);
/* Writes the pose, world, of that response at `time_s`, at least 0. */
FLINCH_API flinch_status flinch_character_planned_pose(const flinch_character* character,
                                                       const flinch_perception* perception,
                                                       int32_t clip, float time_s,
                                                       flinch_pose* out);
/* Starts that response, or the reaction delay before it. `candidates`, at most
 * FLINCH_MOST_CANDIDATES, are what flinch_character_candidates will give. */
FLINCH_API flinch_status flinch_character_answer(flinch_character* character,
                                                 const flinch_perception* perception, int32_t clip,
                                                 const flinch_candidate* candidates, int32_t count);

/* ---- Looking ahead --------------------------------------------------------------------------- */

#define FLINCH_MOST_FORESEEN 16 /* candidates that are looked at for one answer */

/* Makes memory for looking ahead, at most 256 KiB and the figure's, which is for one thread at a
 * time. FLINCH_WITHOUT_COSTS for a selector of an earlier version. */
FLINCH_API flinch_status flinch_look_ahead_create(const flinch_library* library,
                                                  flinch_look_ahead** out);
/* Frees it. */
FLINCH_API flinch_status flinch_look_ahead_free(flinch_look_ahead* look_ahead);

/* How far to look ahead. A `size` that leaves out all but `candidates` means no limit of time. */
typedef struct flinch_look_ahead_options {
  uint32_t size;
  int32_t candidates; /* of the selector's best clips, from 1 to FLINCH_MOST_FORESEEN; clamped */
  float budget_us;    /* exceeded by at most one simulation; without `now_us` there is no limit */
  int32_t reserved;   /* 0 */
  double (*now_us)(void* clock); /* time since any fixed moment, us; NULL: no limit */
  void* clock;                   /* passed to `now_us` */
} flinch_look_ahead_options;

/* What is known of a candidate. */
enum {
  FLINCH_FORESEEN_NOTHING = 0,  /* not tried: see flinch_look_ahead_status */
  FLINCH_FORESEEN_COSTLIER = 1, /* its work alone costs more than the best; not simulated */
  FLINCH_FORESEEN_MISSES = 2,   /* no ball comes near it */
  FLINCH_FORESEEN_SIMULATED = 3,
  FLINCH_FORESEEN_CUT = 4 /* given up when it cost more than the best: damage is a lower bound */
};
FLINCH_API const char* flinch_foreseen_name(int32_t foreseen); /* NULL: no such value */

/* A candidate, and why it was chosen or not; not a number where nothing is known. */
typedef struct flinch_foreseen {
  int32_t clip;
  int32_t foreseen; /* FLINCH_FORESEEN_NOTHING, ... */
  float work_j;
  float damage_ns; /* of all threats together */
  float cost_ns;
  float contact_s; /* s after perception; infinite if nothing touches */
} flinch_foreseen;

/* The result of looking ahead. */
typedef struct flinch_look_ahead_status {
  uint32_t size;
  int32_t candidate_count;
  int32_t tried;       /* as many as the budget allowed; 0 if there is only one candidate, or the
                          work of responses from the character's stance is not known */
  int32_t encounters;  /* balls that were simulated */
  int32_t chosen;      /* index of the answer in `candidate` */
  int32_t threats;     /* that will hit and were looked at, the most urgent ones */
  int32_t ignored;     /* that would hit, and are less urgent */
  int32_t is_complete; /* 1: all candidates were tried */
  flinch_foreseen candidate[FLINCH_MOST_FORESEEN]; /* in the selector's order */
} flinch_look_ahead_status;

/* Perceives `count` threats, simulates the selector's best clips against all of them, and answers
 * with the one that costs least. All threats have the `size` of the first. `out` may be NULL. */
FLINCH_API flinch_status flinch_character_look_ahead(flinch_character* character,
                                                     const flinch_threat* threats, int32_t count,
                                                     const flinch_look_ahead_options* options,
                                                     flinch_look_ahead* look_ahead,
                                                     flinch_look_ahead_status* out);

/* ---- Reacting to hits ------------------------------------------------------------------------ */

/* Makes a character as flinch_character_create does that balls can also hit (docs/reaction.md). All
 * functions for characters take it, with one difference: while physics moves it, the time step of
 * flinch_character_update is at most 0.1 s. */
FLINCH_API flinch_status flinch_character_create_reacting(const flinch_library* library,
                                                          flinch_character** out);

/* How a character takes a hit. */
typedef struct flinch_reaction_options {
  uint32_t size;
  float simulation_only_s; /* for which physics alone moves it after the contact, 0.05 to 0.5 */
  float stiffness; /* of the joints, as a share of that in training, above 0 and at most 1 */
} flinch_reaction_options;
/* Writes what flinch_character_create_reacting takes to `out`. */
FLINCH_API flinch_status flinch_reaction_defaults(flinch_reaction_options* out);
/* The same with these options. FLINCH_BAD_LIMITS: one is out of range. */
FLINCH_API flinch_status flinch_character_create_reacting_as(const flinch_library* library,
                                                             const flinch_reaction_options* options,
                                                             flinch_character** out);

/* Hands the body to physics, because `ball`, as it is now, is about to hit: at the contact or up to
 * 0.3 s before it. flinch_character_update then moves the body and the ball, blends back to the
 * character's own motion after the hit, and allocates nothing. The first call may allocate. */
FLINCH_API flinch_status flinch_character_react_to(flinch_character* character,
                                                   const flinch_threat* ball);

/* Ends physics, or the clip that follows it, at once: the body is where the character's own motion,
 * which has gone on meanwhile, has it. Call it when the game moves a body itself, as after a fall.
 */
FLINCH_API flinch_status flinch_character_stop_reaction(flinch_character* character);

/* The stage of a reaction. */
enum {
  FLINCH_REACTION_NONE = 0,
  FLINCH_REACTION_AWAITS = 1,   /* physics moves the figure; the ball has not hit yet */
  FLINCH_REACTION_STRUCK = 2,   /* the ball has hit; physics alone moves the figure */
  FLINCH_REACTION_RECOVERS = 3, /* blends from physics to the protective motion */
  FLINCH_REACTION_RETURNS = 4,  /* blends to the motion to return to; no physics */
  FLINCH_REACTION_OVER = 5,
  FLINCH_REACTION_KNOCKED_OVER = 6 /* falls until the game places or moves it */
};

/* What moves the body of a character. */
enum { FLINCH_MOVED_BY_CHARACTER = 0, FLINCH_MOVED_BY_PHYSICS = 1, FLINCH_MOVED_BY_CLIP = 2 };

/* The last reaction of a character. */
typedef struct flinch_reaction {
  uint32_t size;
  int32_t phase;          /* FLINCH_REACTION_NONE, ... */
  int32_t moved_by;       /* FLINCH_MOVED_BY_CHARACTER, ... */
  int32_t clip;           /* that continues the motion after the hit; -1: none */
  float contact_s;        /* of the first touch, s after react_to; infinite: none yet */
  float ball_position[3]; /* of its centre; of a rod, of its middle; world, m */
  float ball_velocity[3]; /* world, m/s */
  float impulse_ns[FLINCH_BODY_COUNT]; /* on each body so far, N s */
  float ball_axis[3];                  /* of a rod, from butt to tip, unit; 0 for a ball */
  float ball_momentum[3]; /* that the ball has passed to the figure so far, world, N s */
} flinch_reaction;
/* Writes the above to `out`. */
FLINCH_API flinch_status flinch_character_reaction(const flinch_character* character,
                                                   flinch_reaction* out);

#ifdef __cplusplus
}
#endif

#endif

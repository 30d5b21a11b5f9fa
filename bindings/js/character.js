// SPDX-License-Identifier: MIT

const kMostForeseen = 16; // FLINCH_MOST_FORESEEN
const kMostCandidates = 8; // FLINCH_MOST_CANDIDATES
const kMostOutside = 8; // FLINCH_MOST_OUTSIDE
const kAnswers = ["ok", "misses", "unnoticed"];

/** A character: it perceives, answers, can be hit, and returns to idle. */
export class Character {
  constructor(library) {
    this.library = library;
    this.memory = library.memory;
    this.handle = this.memory.handle((out) =>
      this.memory.call.flinch_character_create_reacting(library.handle, out),
    );
  }

  /** Puts it at (x, y), turned by `facing`, at a time of a stance: an index in Library.stances. */
  place(x, y, facing = 0, stance_time_s = 0, stance = 0) {
    const { call } = this.memory;
    this.memory.checked(
      call.flinch_character_place_in_stance(this.handle, x, y, facing, stance_time_s, stance),
    );
  }

  /** Changes to another stance smoothly. */
  changeStance(stance) {
    this.memory.checked(this.memory.call.flinch_character_change_stance(this.handle, stance));
  }

  /** Makes perception imperfect. */
  limitPerception(limits, seed = 1) {
    const { memory } = this;
    const at = memory.begin().makeStructs("flinch_perception_limits", [limits]);
    memory.checked(
      memory.call.flinch_character_limit_perception(this.handle, at, BigInt(seed)),
    );
  }

  /** Answers threats: "ok", or "misses" or "unnoticed" where there is nothing to answer. */
  perceive(...threats) {
    const { memory } = this;
    const at = memory.begin().makeThreats(threats);
    const { workspace } = this.library;
    return kAnswers[
      memory.checked(
        memory.call.flinch_character_perceive_all(this.handle, at, threats.length, workspace),
      )
    ];
  }

  /** Simulates the selector's best clips against the threats and answers with the cheapest. */
  lookAhead(threats, { candidates = 8 } = {}) {
    const { memory } = this;
    const handle = this.library.lookAheadMemory();
    const at = memory.begin().makeThreats(threats);
    const how = memory.makeStructs("flinch_look_ahead_options", [
      { candidates: Math.min(candidates, kMostForeseen), budget_us: 0, now_us: 0, clock: 0 },
    ]);
    const out = memory.reserveStructs("flinch_look_ahead_status");
    const status = memory.checked(
      memory.call.flinch_character_look_ahead(this.handle, at, threats.length, how, handle, out),
    );
    const { candidate, candidate_count, ...rest } = memory.readStruct(
      "flinch_look_ahead_status",
      out,
    );
    return { answer: kAnswers[status], candidates: candidate.slice(0, candidate_count), ...rest };
  }

  /** Answers with a clip of the caller's choice. */
  respond(clip, time_to_impact_s) {
    const { call } = this.memory;
    this.memory.checked(call.flinch_character_respond(this.handle, clip, time_to_impact_s));
  }

  /** Advances by `dt_s`; at most 0.1 s while physics moves the body. */
  update(dt_s) {
    this.memory.checked(this.memory.call.flinch_character_update(this.handle, dt_s));
  }

  /** Hands the body to physics, because `ball` is about to hit. */
  reactTo(ball) {
    const { memory } = this;
    const at = memory.begin().makeThreats([ball]);
    memory.checked(memory.call.flinch_character_react_to(this.handle, at));
  }

  /** Ends physics at once: the body is where the character's own motion has it. */
  stopReaction() {
    this.memory.checked(this.memory.call.flinch_character_stop_reaction(this.handle));
  }

  /** The last reaction: what moves the body, the ball, and the impulse on each body. */
  reaction() {
    return this.described("flinch_reaction", "flinch_character_reaction");
  }

  /** The current pose: root_position[3], rotation[21 * 4] (w, x, y, z). */
  pose() {
    return this.described("flinch_pose", "flinch_character_pose");
  }

  /** Position and orientation of every joint, in the world. */
  jointFrames() {
    const { memory } = this;
    const pose = memory.begin().reserveStructs("flinch_pose");
    const out = memory.reserveStructs("flinch_joint_frames");
    memory.checked(memory.call.flinch_character_pose(this.handle, pose));
    memory.checked(memory.call.flinch_library_joint_frames(this.library.handle, pose, out));
    return memory.readStruct("flinch_joint_frames", out);
  }

  /** What it is doing, and where. */
  state() {
    return this.described("flinch_character_state", "flinch_character_describe");
  }

  /** The clips that the selector considered for the last threat, best first. */
  candidates() {
    const { memory } = this;
    const out = memory.begin().reserveStructs("flinch_candidate", kMostCandidates);
    const count = memory.reserve(4);
    memory.checked(
      memory.call.flinch_character_candidates(this.handle, out, kMostCandidates, count),
    );
    return memory.readStructs("flinch_candidate", out, memory.readInt(count));
  }

  /** The numbers of a threat, as it was when the last one was perceived, that are outside of what
   * the library was trained for. */
  outsideTraining(threat) {
    const { memory } = this;
    const at = memory.begin().makeThreats([threat]);
    const out = memory.reserveStructs("flinch_outside", kMostOutside);
    const count = memory.reserve(4);
    memory.checked(
      memory.call.flinch_character_outside_training(this.handle, at, out, kMostOutside, count),
    );
    return memory
      .readStructs("flinch_outside", out, memory.readInt(count))
      .map((number) => ({ ...number, name: memory.text(number.name) }));
  }

  /** Stops the response and returns to idle smoothly. */
  settle() {
    this.memory.checked(this.memory.call.flinch_character_settle(this.handle));
  }

  free() {
    this.memory.call.flinch_character_free(this.handle);
    this.handle = 0;
  }

  described(struct, describe) {
    return this.memory.result(struct, (out) => this.memory.call[describe](this.handle, out));
  }
}

// SPDX-License-Identifier: MIT

/** Characters that walk about in a square, and push each other and are pushed by its walls. */
export class Crowd {
  constructor(library, seed) {
    this.memory = library.memory;
    this.handle = this.memory.handle((out) =>
      this.memory.call.flinch_crowd_create(library.handle, seed, out),
    );
  }

  /** Advances by `dt_s`, at most 0.1 s. */
  update(dt_s) {
    this.memory.checked(this.memory.call.flinch_crowd_update(this.handle, dt_s));
  }

  /** How many there are, in which square, and what has happened so far. */
  state() {
    return this.memory.result("flinch_crowd_state", (out) =>
      this.memory.call.flinch_crowd_describe(this.handle, out),
    );
  }

  /** Positions and orientations of all joints of one character. */
  jointFrames(character) {
    return this.memory.result("flinch_joint_frames", (out) =>
      this.memory.call.flinch_crowd_joint_frames(this.handle, character, out),
    );
  }

  /** The pushes of the last frame. */
  pushes() {
    return Array.from({ length: this.state().push_count }, (_, push) =>
      this.memory.result("flinch_crowd_push", (out) =>
        this.memory.call.flinch_crowd_pushed(this.handle, push, out),
      ),
    );
  }

  free() {
    this.memory.call.flinch_crowd_free(this.handle);
    this.handle = 0;
  }
}

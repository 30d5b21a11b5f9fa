// SPDX-License-Identifier: MIT

const kAnswers = ["ok", "misses", "unnoticed"];

/** Simulates what clips would do, as training does; takes about 2 ms a clip. */
export class Oracle {
  constructor(library) {
    this.library = library;
    this.memory = library.memory;
    this.handle = this.memory.handle((out) =>
      this.memory.call.flinch_oracle_create(library.handle, out),
    );
  }

  /** How the selector weighs work against damage. */
  costs() {
    return this.memory.result("flinch_costs", (out) =>
      this.memory.call.flinch_oracle_costs(this.handle, out),
    );
  }

  /** The clip with the nearest annotation, as games commonly script it; null if nothing is hit. */
  nearestAnnotation(character, threat) {
    const { memory } = this;
    const at = memory.begin().makeThreats([threat]);
    const clip = memory.reserve(4);
    const status = memory.checked(
      memory.call.flinch_oracle_nearest_annotation(this.handle, character.handle, at, clip),
    );
    return status === 0 ? memory.readInt(clip) : null;
  }

  /** What `threat` does to a character that answers it with `clip`; null if it hits nothing. */
  tryClip(character, threat, clip) {
    const { memory } = this;
    const at = memory.begin().makeThreats([threat]);
    const out = memory.reserveStructs("flinch_trial");
    const status = memory.checked(
      memory.call.flinch_oracle_try(this.handle, character.handle, at, clip, out),
    );
    return status === 0 ? memory.readStruct("flinch_trial", out) : null;
  }

  /** The same for all clips that may answer: the trials, and the index of the best in `best`. */
  tryAll(character, threat) {
    return this.tried((memory, trials, capacity, count, best) => {
      const at = memory.makeThreats([threat]);
      return memory.call.flinch_oracle_try_all(
        this.handle, character.handle, at, trials, capacity, count, best,
      );
    });
  }

  /** The trials that `call` writes. */
  tried(call) {
    const { memory } = this;
    const capacity = this.library.clips.length;
    const { size } = memory.structs.flinch_trial;
    const trials = memory.call.malloc(size * capacity);
    if (trials === 0) throw new RangeError("there is not enough memory");
    try {
      const count = memory.begin().reserve(4);
      const best = memory.reserve(4);
      const status = memory.checked(call(memory, trials, capacity, count, best));
      if (status !== 0) return { answer: kAnswers[status], trials: [], best: -1 };
      return {
        answer: "ok",
        trials: memory.readStructs("flinch_trial", trials, memory.readInt(count)),
        best: memory.readInt(best),
      };
    } finally {
      memory.call.free(trials);
    }
  }

  /** All trials in a scenario of training, and the index of the best. */
  tryScenario(scenario) {
    return this.tried((memory, trials, capacity, count, best) => {
      const at = memory.makeStructs("flinch_scenario", [scenario]);
      return memory.call.flinch_oracle_try_scenario(this.handle, at, trials, capacity, count, best);
    });
  }

  free() {
    this.memory.call.flinch_oracle_free(this.handle);
    this.handle = 0;
  }
}

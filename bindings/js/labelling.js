// SPDX-License-Identifier: MIT

const kBatch = 500; // labels that find room in one call

/** Draws pushed motions, takes a judge's answers, and estimates the next from all so far. */
export class Labelling {
  constructor(library, seed) {
    this.library = library;
    this.memory = library.memory;
    const { call } = this.memory;
    this.handle = this.memory.handle((out) => call.flinch_labelling_create(library.handle, seed, out));
    this.libraryHash = this.memory.text(call.flinch_labelling_library(this.handle));
  }

  /** Takes labels of earlier sittings: [{example, realism}]. */
  add(labels) {
    const { memory } = this;
    for (let first = 0; first < labels.length; first += kBatch) {
      const some = labels.slice(first, first + kBatch);
      const examples = memory.begin().makeStructs("flinch_push_example", some.map(({ example }) => example));
      const qualities = memory.reserve(4 * some.length);
      some.forEach(({ realism }, i) => memory.view.setFloat32(qualities + 4 * i, realism, true));
      memory.checked(
        memory.call.flinch_labelling_add(this.handle, examples, qualities, some.length),
      );
    }
  }

  /** The motion that is judged now: its estimate, negative where there is none, and how well the
   * last estimates agreed with the judge. */
  question() {
    return this.memory.result("flinch_question", (out) =>
      this.memory.call.flinch_labelling_question(this.handle, out),
    );
  }

  /** How it is made, as label files have it. */
  example() {
    return this.memory.result("flinch_push_example", (out) =>
      this.memory.call.flinch_labelling_example(this.handle, out),
    );
  }

  /** The pose of one of its frames, which are 1/60 s apart. */
  pose(frame) {
    return this.memory.result("flinch_pose", (out) =>
      this.memory.call.flinch_labelling_pose(this.handle, frame, out),
    );
  }

  /** Takes the answer, 0 to 1, and draws the next motion. */
  judge(realism) {
    this.memory.checked(this.memory.call.flinch_labelling_judge(this.handle, realism));
  }

  /** Draws another motion without an answer. */
  skip() {
    this.memory.checked(this.memory.call.flinch_labelling_skip(this.handle));
  }

  /** Shows motion `number` of a seed in the test whether it is a recording. */
  study(seed, number) {
    const { memory } = this;
    const shown = memory.begin().reserve(4);
    const realism = memory.reserve(4);
    memory.checked(memory.call.flinch_labelling_study(this.handle, seed, number, shown, realism));
    return {
      shown: ["good", "bad", "recording"][memory.readInt(shown)],
      realism: memory.view.getFloat32(realism, true),
    };
  }

  free() {
    this.memory.call.flinch_labelling_free(this.handle);
    this.handle = 0;
  }
}

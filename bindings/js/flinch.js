// SPDX-License-Identifier: MIT
// Flinch for JavaScript: characters that see an impact coming. The names, units and frames of all
// values are those of Flinch's C interface (flinch.h).
import { Library } from "./library.js";
import { Memory } from "./memory.js";

export { Character } from "./character.js";
export { Crowd } from "./crowd.js";
export { Labelling } from "./labelling.js";
export { Library } from "./library.js";
export { FlinchError } from "./memory.js";
export { Oracle } from "./oracle.js";

/** Flinch, loaded. Instances share nothing; make one for each worker. */
class Flinch {
  constructor(instance) {
    this.memory = new Memory(instance);
    const { memory } = this;
    this.version = memory.text(memory.call.flinch_version());
    this.joints = memory.names("flinch_joint_name");
    this.parents = this.joints.map((_, joint) => memory.call.flinch_joint_parent(joint));
    this.bodies = memory.names("flinch_body_name");
    this.targets = memory.names("flinch_target_name");
    this.phases = memory.names("flinch_phase_name");
    this.foreseen = memory.names("flinch_foreseen_name");
  }

  /** Loads a selector file from its bytes. Throws FlinchError where it cannot be used. */
  load(bytes) {
    const { flinch_library_load_memory } = this.memory.call;
    return new Library(this, bytes, flinch_library_load_memory);
  }

  /** Loads a selector file for the clips of another library, which both share from then on: so
   * selectors that `flinch train --without-clips` writes play from one library. `owner` may be
   * freed before. */
  loadBeside(bytes, owner) {
    const { flinch_library_load_beside } = this.memory.call;
    return new Library(this, bytes, (file, size, out) =>
      flinch_library_load_beside(file, size, owner.handle, out),
    );
  }

  /** Takes a library's file, which has clips and no selector: its characters answer as they are
   * told. */
  take(bytes) {
    const { flinch_library_take } = this.memory.call;
    return new Library(this, bytes, flinch_library_take);
  }

  /** The limits of a person who chooses among `choices` answers. */
  humanLimits(choices) {
    const { call } = this.memory;
    return this.memory.result("flinch_perception_limits", (out) =>
      call.flinch_human_limits(choices, out),
    );
  }
}

/** Loads Flinch from flinch.wasm: its bytes, a compiled module, a response or its address. */
export async function loadFlinch(source = new URL("./flinch.wasm", import.meta.url)) {
  const module = await compiled(await source);
  const instance = await WebAssembly.instantiate(module, {});
  instance.exports._initialize();
  return new Flinch(instance);
}

async function compiled(source) {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source))
    return WebAssembly.compile(source);
  const isFile = source instanceof URL && source.protocol === "file:";
  if (isFile && typeof process !== "undefined") {
    const { readFile } = await import("node:fs/promises");
    return WebAssembly.compile(await readFile(source));
  }
  const response = source instanceof Response ? source : await fetch(source);
  if (!response.ok) throw new Error(`cannot load ${response.url}: ${response.statusText}`);
  return WebAssembly.compile(await response.arrayBuffer());
}

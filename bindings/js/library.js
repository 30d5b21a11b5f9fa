// SPDX-License-Identifier: MIT
import { Character } from "./character.js";
import { Crowd } from "./crowd.js";
import { Labelling } from "./labelling.js";
import { Oracle } from "./oracle.js";

/** A selector with its clips, or clips alone. Free it when it is no longer needed. */
export class Library {
  /** `load` makes the handle from the address and size of a copy of `bytes`, at `out`. */
  constructor(flinch, bytes, load) {
    this.flinch = flinch;
    this.memory = flinch.memory;
    const { memory } = this;
    const { call } = memory;
    const data = new Uint8Array(bytes.buffer ?? bytes, bytes.byteOffset ?? 0, bytes.byteLength);
    const address = call.malloc(Math.max(data.length, 1));
    if (address === 0) throw new RangeError("there is not enough memory");
    try {
      new Uint8Array(call.memory.buffer).set(data, address);
      this.handle = memory.handle((out) => load(address, data.length, out));
    } finally {
      call.free(address);
    }
    this.info = this.described("flinch_library_info", "flinch_library_describe");
    this.skeleton = this.described("flinch_skeleton", "flinch_library_skeleton");
    this.clips = Array.from({ length: this.info.clip_count }, (_, clip) => this.clipAt(clip));
    this.kinds = Array.from({ length: this.info.kind_count }, (_, kind) => this.kindAt(kind));
    this.stances = this.stanceClips();
    this.outlines = flinch.bodies.map((_, body) =>
      memory.result("flinch_outline", (out) =>
        call.flinch_library_outline(this.handle, body, out),
      ),
    );
    this.workspace = memory.handle((out) => call.flinch_workspace_create(this.handle, out));
    this.lookAhead = 0; // made when it is first needed
  }

  described(struct, describe) {
    return this.memory.result(struct, (out) => this.memory.call[describe](this.handle, out));
  }

  clipAt(index) {
    const { memory } = this;
    const clip = memory.result("flinch_clip", (out) =>
      memory.call.flinch_library_clip(this.handle, index, out),
    );
    return { ...clip, name: memory.text(clip.name), kind: memory.text(clip.kind) };
  }

  stanceClips() {
    const stances = [];
    for (;;) {
      const clip = this.memory.call.flinch_library_stance(this.handle, stances.length);
      if (clip < 0) return stances;
      stances.push(clip);
    }
  }

  kindAt(index) {
    const { memory } = this;
    const kind = memory.result("flinch_kind", (out) =>
      memory.call.flinch_library_kind(this.handle, index, out),
    );
    return { ...kind, name: memory.text(kind.name) };
  }

  /** Memory for looking ahead, made once. */
  lookAheadMemory() {
    const { memory } = this;
    this.lookAhead ||= memory.handle((out) =>
      memory.call.flinch_look_ahead_create(this.handle, out),
    );
    return this.lookAhead;
  }

  /** A character that idles at the origin and faces +X; balls can hit it. */
  createCharacter() {
    return new Character(this);
  }

  /** Simulates what every clip would do. Throws FlinchError for a selector without costs. */
  createOracle() {
    return new Oracle(this);
  }

  /** Begins to judge pushed motions. Throws FlinchError for a library without pushes. */
  createLabelling(seed) {
    return new Labelling(this, seed);
  }

  /** Twenty characters that walk about and push each other. Throws FlinchError for a library without
   * pushes or a selector without a realism model. */
  createCrowd(seed = 1) {
    return new Crowd(this, seed);
  }

  /** Positions and orientations of all joints in a pose, in the world. */
  jointFrames(pose) {
    const { memory } = this;
    const from = memory.begin().makeStructs("flinch_pose", [pose]);
    const out = memory.reserveStructs("flinch_joint_frames");
    memory.checked(memory.call.flinch_library_joint_frames(this.handle, from, out));
    return memory.readStruct("flinch_joint_frames", out);
  }

  /** The pose of a clip at a time from its start, s. */
  clipPose(clip, time_s) {
    return this.memory.result("flinch_pose", (out) =>
      this.memory.call.flinch_clip_pose(this.handle, clip, time_s, out),
    );
  }

  /** Scenario `number` of a seed, as `flinch simulate --seed` draws it. */
  drawScenario(seed, number) {
    return this.memory.result("flinch_scenario", (out) =>
      this.memory.call.flinch_scenario_draw(this.handle, seed, number, out),
    );
  }

  /** The clip that the selector chooses in a scenario; by looking ahead, if `candidates` says at how
   * many clips. */
  chooseIn(scenario, candidates = 0) {
    const { call } = this.memory;
    const ahead = candidates > 0 ? this.lookAheadMemory() : 0;
    return this.clipIn(scenario, (at, clip) =>
      candidates > 0
        ? call.flinch_scenario_look_ahead(this.handle, at, candidates, ahead, clip)
        : call.flinch_scenario_choose(this.handle, at, this.workspace, clip),
    );
  }

  /** The clip with the nearest annotation, as games commonly script it, in a scenario. */
  nearestIn(scenario) {
    return this.clipIn(scenario, (at, clip) =>
      this.memory.call.flinch_scenario_nearest_annotation(this.handle, at, clip),
    );
  }

  clipIn(scenario, call) {
    const { memory } = this;
    const at = memory.begin().makeStructs("flinch_scenario", [scenario]);
    const clip = memory.reserve(4);
    memory.checked(call(at, clip));
    return memory.readInt(clip);
  }

  /** A surface for drawing the figure as a person (see flinch_skin_mesh in exports.h). */
  skin() {
    const { memory } = this;
    const { call } = memory;
    const handle = memory.handle((out) => call.flinch_skin_create(this.handle, out));
    const mesh = memory.result("flinch_skin_mesh", (out) => call.flinch_skin_describe(handle, out));
    const copied = (Array, address, count) =>
      new Array(call.memory.buffer, address, count).slice();
    const { vertex_count: count } = mesh;
    const skin = {
      position: copied(Float32Array, mesh.position, 3 * count),
      normal: copied(Float32Array, mesh.normal, 3 * count),
      joint: copied(Uint8Array, mesh.joint, 4 * count),
      weight: copied(Float32Array, mesh.weight, 4 * count),
      triangles: Array.from(mesh.triangle, (address, covering) =>
        copied(Uint32Array, address, 3 * mesh.triangle_count[covering]),
      ),
    };
    call.flinch_skin_free(handle);
    return skin;
  }

  /** Frees it; its characters and oracles stay usable until they are freed. */
  free() {
    const { call } = this.memory;
    call.flinch_look_ahead_free(this.lookAhead);
    call.flinch_workspace_free(this.workspace);
    call.flinch_library_free(this.handle);
    this.handle = this.workspace = this.lookAhead = 0;
  }
}

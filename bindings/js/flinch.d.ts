// SPDX-License-Identifier: MIT
// Names, units and frames are those of flinch.h, the C interface: SI units, radians, Z up,
// quaternions w, x, y, z, flat arrays.

/** An error that Flinch reports; `status` is its number in flinch.h. */
export class FlinchError extends Error {
  readonly status: number;
}

/** Whether a threat is answered, hits nothing, or was not noticed. */
export type Answer = "ok" | "misses" | "unnoticed";
type Vector = ArrayLike<number>;

/** A kind of threat that a library was trained for; ranges are smallest and largest. */
export interface ThreatKind {
  /** 0 a ball, 1 a blade, 2 a fist, 3 a rod. */
  shape: number;
  name: string;
  radius: Float32Array;
  mass_kg: Float32Array;
  speed_mps: Float32Array;
  elevation: Float32Array;
  time_to_impact_s: Float32Array;
  reach_m: Float32Array;
  restitution: number;
  friction: number;
  is_straight: number;
  /** Of a rod, from end to end; 0 for others. */
  length_m: Float32Array;
}

/** A number of a threat that is outside of what the library was trained for. */
export interface Outside {
  name: string;
  value: number;
  trained: Float32Array;
}

/** Something that approaches, as it is now. */
export interface Threat {
  position: Vector;
  velocity: Vector;
  radius: number;
  mass_kg: number;
  /** Index in Library.kinds; default 0. */
  kind?: number;
  /** Of a fist or a swung rod: when its stroke starts and how long it lasts; default 0. */
  starts_in_s?: number;
  lasts_s?: number;
  /** Of a rod: unit vector from butt to tip, turn in rad/s, and from `position` to either end. */
  axis?: Vector;
  angular_velocity?: Vector;
  to_butt_m?: number;
  to_tip_m?: number;
}

export interface PerceptionLimits {
  reaction_delay_s: number;
  bearing_noise: number;
  distance_noise: number;
  heading_noise: number;
  speed_noise: number;
  chance_to_fail: number;
}

export interface Clip {
  is_annotated: number;
  name: string;
  kind: string;
  duration_s: number;
  target: number;
  direction: number;
  degree: number;
  onset_s: number;
  peak_s: number;
  end_s: number;
}

/** Outline of a body in the frame of the joint that moves it: a box, or a capsule along Z. */
export interface Outline {
  joint: number;
  is_box: number;
  centre: Float32Array;
  orientation: Float32Array;
  radius: number;
  half_length: number;
  half_extents: Float32Array;
  mass_kg: number;
  centre_of_mass: Float32Array;
}

export interface Pose {
  root_position: Float32Array;
  rotation: Float32Array;
}

export interface JointFrames {
  position: Float32Array;
  orientation: Float32Array;
}

export interface CharacterState {
  phase: number;
  clip: number;
  target: number;
  time_to_impact_s: number;
  position: Float32Array;
  facing: number;
}

export interface Candidate {
  clip: number;
  vote: number;
  expected_cost_ns: number;
}

export interface Foreseen {
  clip: number;
  foreseen: number;
  work_j: number;
  damage_ns: number;
  cost_ns: number;
  contact_s: number;
}

export interface LookAheadResult {
  answer: Answer;
  candidates: Foreseen[];
  tried: number;
  encounters: number;
  chosen: number;
  threats: number;
  ignored: number;
  is_complete: number;
}

export interface Reaction {
  phase: number;
  moved_by: number;
  clip: number;
  contact_s: number;
  ball_position: Float32Array;
  ball_velocity: Float32Array;
  /** Of a rod, from butt to tip; 0 for a ball. */
  ball_axis: Float32Array;
  /** That the ball has passed to the figure so far, world, N s. */
  ball_momentum: Float32Array;
  impulse_ns: Float32Array;
}

/** What a threat does to a character that answers it with a clip. */
export interface Trial {
  clip: number;
  work_j: number;
  damage_ns: number;
  cost_ns: number;
  contact_s: number;
  impulse_ns: Float32Array;
}

/** A character: it perceives, answers, can be hit, and returns to idle. */
export class Character {
  readonly library: Library;
  /** At a time of a stance, an index in Library.stances: 0, the default, is the idle clip. */
  place(x: number, y: number, facing?: number, stance_time_s?: number, stance?: number): void;
  changeStance(stance: number): void;
  limitPerception(limits: PerceptionLimits, seed?: number | bigint): void;
  perceive(...threats: Threat[]): Answer;
  lookAhead(threats: Threat[], options?: { candidates?: number }): LookAheadResult;
  respond(clip: number, time_to_impact_s: number): void;
  update(dt_s: number): void;
  reactTo(ball: Threat): void;
  stopReaction(): void;
  reaction(): Reaction;
  pose(): Pose;
  jointFrames(): JointFrames;
  state(): CharacterState;
  candidates(): Candidate[];
  outsideTraining(threat: Threat): Outside[];
  settle(): void;
  free(): void;
}

/** A scenario as training draws them: a ball, and a character at the origin that faces +X. */
export interface Scenario extends Threat {
  target: number;
  time_to_impact_s: number;
  idle_time_s: number;
}

/** Simulates what clips would do, as training does. */
export class Oracle {
  costs(): { brawn: number; work_weight_ns_per_j: number };
  nearestAnnotation(character: Character, threat: Threat): number | null;
  tryClip(character: Character, threat: Threat, clip: number): Trial | null;
  tryAll(
    character: Character,
    threat: Threat,
  ): { answer: Answer; trials: Trial[]; best: number };
  tryScenario(scenario: Scenario): { answer: Answer; trials: Trial[]; best: number };
  free(): void;
}

/** A pushed motion, as label files have it; vectors in the frame of the character's facing. */
export interface PushExample {
  state_clip: number;
  state_s: number;
  place: number;
  asked: Float32Array | number[];
  response_clip: number;
  turn: number;
  taper: number;
  deformation: Float32Array | number[];
}

/** The motion that is judged, and how well the last estimates agreed with the judge. */
export interface Question {
  estimate: number;
  push_s: number;
  frame_count: number;
  label_count: number;
  compared: number;
  same_side: number;
  mean_error: number;
  is_agreement: number;
}

/** Draws pushed motions, takes a judge's answers, and estimates the next from all so far. */
export class Labelling {
  readonly libraryHash: string;
  add(labels: readonly { example: PushExample; realism: number }[]): void;
  question(): Question;
  example(): PushExample;
  pose(frame: number): Pose;
  judge(realism: number): void;
  skip(): void;
  study(seed: number, number: number): { shown: "good" | "bad" | "recording"; realism: number };
  free(): void;
}

/** Where a crowd walks, and what has happened so far. */
export interface CrowdState {
  characters: number;
  half_side_m: number;
  bumps: number;
  walls: number;
  answered: number;
  physical: number;
  knocked_over: number;
  push_count: number;
}

/** A push that a character has taken: where its chest was, and the velocity that the pushed joint
 * shall reach; answered by physics (1) or a recorded response (0). */
export interface CrowdPush {
  character: number;
  is_physical: number;
  at: Float32Array;
  velocity: Float32Array;
}

/** Characters that walk about in a square, and push each other and are pushed by its walls. */
export class Crowd {
  update(dt_s: number): void;
  state(): CrowdState;
  jointFrames(character: number): JointFrames;
  pushes(): CrowdPush[];
  free(): void;
}

/** A surface that moves with the joints: v' = sum of w (p + R (v - r)), r the joint at rest. */
export interface Skin {
  position: Float32Array;
  normal: Float32Array;
  joint: Uint8Array;
  weight: Float32Array;
  /** Of each covering: skin, hair, eyes, lips, shirt, trousers, shoes. */
  triangles: Uint32Array[];
}

/** A selector with its clips, or clips alone. */
export class Library {
  readonly flinch: Flinch;
  readonly info: {
    clip_count: number;
    idle_clip: number;
    rate_hz: number;
    mass_kg: number;
    kind_count: number;
  };
  readonly skeleton: { offset: Float32Array; tip: Float32Array };
  readonly clips: Clip[];
  readonly kinds: ThreatKind[];
  /** The clips of its stances, the idle clip first. */
  readonly stances: number[];
  readonly outlines: Outline[];
  createCharacter(): Character;
  createOracle(): Oracle;
  createLabelling(seed: number): Labelling;
  createCrowd(seed?: number): Crowd;
  jointFrames(pose: Pose): JointFrames;
  skin(): Skin;
  clipPose(clip: number, time_s: number): Pose;
  drawScenario(seed: number, number: number): Scenario;
  chooseIn(scenario: Scenario, candidates?: number): number;
  nearestIn(scenario: Scenario): number;
  free(): void;
}

/** Flinch, loaded. */
export interface Flinch {
  readonly version: string;
  readonly joints: string[];
  readonly parents: number[];
  readonly bodies: string[];
  readonly targets: string[];
  readonly phases: string[];
  readonly foreseen: string[];
  /** Loads a selector file. Throws FlinchError where it cannot be used. */
  load(bytes: ArrayBuffer | ArrayBufferView): Library;
  /** Loads a selector file, such as one without clips, for the clips of `owner`, which both share
   * from then on. Throws FlinchError for the selector of another library. */
  loadBeside(bytes: ArrayBuffer | ArrayBufferView, owner: Library): Library;
  /** Takes a library's file, which has clips and no selector. */
  take(bytes: ArrayBuffer | ArrayBufferView): Library;
  humanLimits(choices: number): PerceptionLimits;
}

/** Loads Flinch from flinch.wasm: its bytes, a compiled module, a response or its address. */
export function loadFlinch(
  source?:
    | ArrayBuffer
    | ArrayBufferView
    | WebAssembly.Module
    | Response
    | URL
    | string
    | Promise<Response>,
): Promise<Flinch>;

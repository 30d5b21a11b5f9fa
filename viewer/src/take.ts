// SPDX-License-Identifier: MIT
// One character's answer to one throw, simulated as far as anyone has looked and kept, so that
// playing, pausing and scrubbing show the same.
import type { Character, JointFrames, Threat, Trial } from "flinch";
import { atRest, choose, prepared, type Chooser, type Conditions } from "./chooser";
import { kGravity } from "./throw";

export const kRate = 60;
export const kDuration = 3.2; // s: the flight, the answer and the way back
// Physics takes the body this long before the contact that a simulation foresees.
const kAhead = 0.08;
const kRestitution = 0.7;

export interface Frame {
  joints: JointFrames;
  ball: [number, number, number];
  impulses: Float32Array; // on each body so far, N s
  phase: number;
}

export class Take {
  readonly frames: Frame[] = [];
  readonly clip: number;
  readonly trial: Trial | null; // none if the throw misses
  private readonly character: Character;
  private readonly ball: { position: number[]; velocity: number[] };
  private isMet = false;
  private answersAt: number | null = null; // when a clip of ours begins to be answered with

  /** `chosen`: the oracle's clip, which is found elsewhere. */
  constructor(
    readonly chooser: Chooser,
    private readonly conditions: Conditions,
    chosen?: number,
  ) {
    const { selector, kind } = chooser;
    const { threat, delay } = conditions;
    this.character = prepared(selector.library.createCharacter(), delay);
    this.clip = chosen ?? choose(chooser, this.character, conditions);
    this.trial = selector.oracle.tryClip(atRest(selector, delay), threat, this.clip);
    if (kind === "oracle" || kind === "nearest") this.answersAt = delay;
    this.ball = { position: [...toArray(threat.position)], velocity: [...toArray(threat.velocity)] };
    this.record();
  }

  /** The frame shown at `time`, between the two nearest that are kept. */
  at(time: number): { from: Frame; to: Frame; share: number } {
    const exact = Math.min(Math.max(time, 0), kDuration) * kRate;
    const first = Math.floor(exact);
    while (this.frames.length < first + 2) this.advance();
    return { from: this.frames[first]!, to: this.frames[first + 1]!, share: exact - first };
  }

  get threat(): Threat {
    return this.conditions.threat;
  }

  free(): void {
    this.character.free();
  }

  private advance(): void {
    const now = (this.frames.length - 1) / kRate;
    const { threat } = this.conditions;
    if (this.answersAt !== null && now >= this.answersAt) this.answer(now);
    const contact = this.trial?.contact_s ?? Infinity;
    if (!this.isMet && now + 1 / kRate > contact - kAhead) {
      this.isMet = true;
      this.character.reactTo({ ...threat, ...this.ball });
    }
    this.character.update(1 / kRate);
    this.moveBall(1 / kRate);
    this.record();
  }

  /** Answers with the clip that was chosen for the character, as it would with its own. */
  private answer(now: number): void {
    this.answersAt = null;
    const { idle_clip } = this.chooser.selector.library.info;
    const left = this.timeToImpact() - now;
    if (this.clip !== idle_clip && this.trial && left > 0) this.character.respond(this.clip, left);
  }

  /** As a character that stands still predicts it. */
  private timeToImpact(): number {
    const watching = atRest(this.chooser.selector, 0);
    watching.perceive(this.conditions.threat);
    return watching.state().time_to_impact_s;
  }

  private moveBall(dt: number): void {
    const { position, velocity } = this.ball;
    const reaction = this.character.reaction();
    if (this.isMet && reaction.moved_by === 1) {
      position.splice(0, 3, ...reaction.ball_position);
      velocity.splice(0, 3, ...reaction.ball_velocity);
      return;
    }
    const { radius } = this.conditions.threat;
    for (let i = 0; i < 3; ++i) position[i]! += velocity[i]! * dt;
    position[2]! -= (kGravity * dt * dt) / 2;
    velocity[2]! -= kGravity * dt;
    if (position[2]! < radius && velocity[2]! < 0) {
      position[2] = 2 * radius - position[2]!;
      velocity[2]! *= -kRestitution;
    }
  }

  private record(): void {
    const [x, y, z] = this.ball.position as [number, number, number];
    this.frames.push({
      joints: this.character.jointFrames(),
      ball: [x, y, z],
      impulses: this.character.reaction().impulse_ns,
      phase: this.character.state().phase,
    });
  }
}

function toArray(vector: ArrayLike<number>): number[] {
  return Array.from(vector);
}

// SPDX-License-Identifier: MIT
// One character's answer to one throw.
import type { Character, Threat, ThreatKind, Trial } from "flinch";
import { beforeThrow, choose, prepared, type Chooser, type Conditions } from "./chooser";
import { advanced, isSpecial, type FullThreat } from "./kinds";
import { fly, kRate, Recording, type FlyingBall, type Rod } from "./recording";
import { kGravity } from "./throw";

type Vector = [number, number, number];
const kDuration = 3.2; // s: the flight, the answer and the way back
// Physics takes the body this long before the contact that a simulation foresees.
export const kAhead = 0.08;

export class Take extends Recording {
  readonly clip: number;
  readonly trial: Trial | null; // none if the throw misses
  private readonly character: Character;
  private readonly ball: FlyingBall;
  private readonly kind: ThreatKind | undefined;
  private rod: Rod | undefined;
  private isMet = false;
  private foreseen: number | null | undefined; // contact_s_at_rest, once it is known
  private answersAt: number | null = null; // when a clip of ours begins to be answered with

  /** `chosen`: the oracle's clip, which is found elsewhere. */
  constructor(
    readonly chooser: Chooser,
    private readonly conditions: Conditions,
    chosen?: number,
  ) {
    super(kDuration);
    const { selector, kind } = chooser;
    const { threat, delay } = conditions;
    this.character = prepared(selector.library.createCharacter(), conditions);
    this.clip = chosen ?? choose(chooser, this.character, threat);
    this.trial = selector.oracle.tryClip(beforeThrow(selector, conditions), threat, this.clip);
    if (kind === "oracle" || kind === "nearest") this.answersAt = delay;
    this.ball = { position: Array.from(threat.position), velocity: Array.from(threat.velocity) };
    this.kind = selector.library.kinds[threat.kind ?? 0];
    if (isSpecial(this.kind)) this.placeBall(this.kind, 0);
    this.record();
  }

  get threat(): Threat {
    return this.conditions.threat;
  }

  /** When the ball would touch the character if that went on as it is; null if never. Simulated when first
   * asked for. */
  get contact_s_at_rest(): number | null {
    if (this.foreseen === undefined) {
      const { oracle, library } = this.chooser.selector;
      const idle = oracle.tryClip(this.withoutDelay(), this.threat, library.info.idle_clip);
      this.foreseen = idle && Number.isFinite(idle.contact_s) ? idle.contact_s : null;
    }
    return this.foreseen;
  }

  /** Where the ball, or the fist, is then, and how it flies; null for rods, which are no balls. */
  get ballAtRestContact(): { position: Vector; velocity: Vector } | null {
    const t = this.contact_s_at_rest;
    if (t === null || this.rod) return null;
    if (isSpecial(this.kind)) return advanced(this.threat as FullThreat, this.kind, t);
    const [x, y, z] = Array.from(this.threat.position) as Vector;
    const [u, v, w] = Array.from(this.threat.velocity) as Vector;
    return {
      position: [x + u * t, y + v * t, z + w * t - (kGravity * t * t) / 2],
      velocity: [u, v, w - kGravity * t],
    };
  }

  free(): void {
    this.character.free();
  }

  protected advance(): void {
    const now = (this.frames.length - 1) / kRate;
    const { threat } = this.conditions;
    if (this.answersAt !== null && now >= this.answersAt) this.answer(now);
    const contact = this.trial?.contact_s ?? Infinity;
    if (!this.isMet && now + 1 / kRate > contact - kAhead) {
      this.isMet = true;
      this.character.reactTo(
        isSpecial(this.kind) ? advanced(threat as FullThreat, this.kind, now) : { ...threat, ...this.ball },
      );
    }
    this.character.update(1 / kRate);
    this.moveBall(now, 1 / kRate);
    this.record();
  }

  /** Answers with the clip that was chosen for the character, as it would with its own. */
  private answer(now: number): void {
    this.answersAt = null;
    const { idle_clip } = this.chooser.selector.library.info;
    const left = this.timeToImpact() - now;
    if (this.clip !== idle_clip && this.trial && left > 0) this.character.respond(this.clip, left);
  }

  private withoutDelay(): Character {
    return beforeThrow(this.chooser.selector, { ...this.conditions, delay: 0 });
  }

  /** As a character that goes on as it is predicts it. */
  private timeToImpact(): number {
    const watching = this.withoutDelay();
    watching.perceive(this.conditions.threat);
    return watching.state().time_to_impact_s;
  }

  private moveBall(now: number, dt: number): void {
    const reaction = this.character.reaction();
    if (this.isMet && reaction.moved_by === 1) {
      this.ball.position.splice(0, 3, ...reaction.ball_position);
      this.ball.velocity.splice(0, 3, ...reaction.ball_velocity);
      const [x, y, z] = reaction.ball_axis as unknown as [number, number, number];
      if (this.rod) this.rod = { ...this.rod, axis: [x, y, z] };
    } else if (isSpecial(this.kind)) {
      if (!this.isMet) this.placeBall(this.kind, now + dt);
    } else {
      fly(this.ball, this.threat.radius, dt);
    }
  }

  /** Where a threat that does not just fly is then: of a rod its middle. */
  private placeBall(kind: ThreatKind, time: number): void {
    const { position, velocity, axis, to_butt_m, to_tip_m } = advanced(
      this.threat as FullThreat,
      kind,
      time,
    );
    const middle = (to_tip_m - to_butt_m) / 2;
    this.ball.position.splice(0, 3, ...position.map((x, i) => x + middle * axis[i]!));
    this.ball.velocity.splice(0, 3, ...velocity);
    if (to_butt_m + to_tip_m > 0) this.rod = { axis, half_length: (to_butt_m + to_tip_m) / 2 };
  }

  private record(): void {
    const [x, y, z] = this.ball.position as [number, number, number];
    this.frames.push({
      joints: this.character.jointFrames(),
      balls: [{ id: 0, position: [x, y, z], radius: this.threat.radius, ...(this.rod && { rod: this.rod }) }],
      impulses: this.character.reaction().impulse_ns,
    });
  }
}

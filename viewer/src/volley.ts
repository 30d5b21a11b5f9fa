// SPDX-License-Identifier: MIT
// The machine gun: a ball every second, from anywhere, at a character that is still busy with the
// one before.
import type { Character, JointFrames, Pose, Threat } from "flinch";
import { bestTrial, prepared, type Chooser } from "./chooser";
import { fly, kRate, Recording, type FlyingBall } from "./recording";
import { blended } from "./pose_blend";
import { kAhead } from "./take";
import { randomNumbers, randomThrow, threatOf } from "./throw";

const kBalls = 12;
const kPeriod = 1; // s from one ball to the next
const kLast = 2.5; // s that the last ball is watched
const kShown = 3; // balls that are in sight
const kLies = 1.2; // s until a character that was knocked over begins to rise
const kRises = 0.8; // s until it stands
const kKnockedOver = 6; // FLINCH_REACTION_KNOCKED_OVER

export interface VolleyConditions {
  seed: number;
  delay: number;
  brawn: number;
  size: number; // of the balls, as a share of what is drawn
  mass: number; // the same
}

interface Shot extends FlyingBall {
  threat: Threat;
  clip: string;
  contact: number; // s, of the volley
  isMet: boolean;
  damage_ns: number;
}

export class Volley extends Recording {
  readonly shots: Shot[] = [];
  private readonly character: Character;
  private readonly random: () => number;
  /** When it rose after it was knocked over, and the pose in which it had lain. */
  readonly risings: { from: number; pose: Pose }[] = [];
  private risesAt = Infinity;

  constructor(
    readonly chooser: Chooser,
    private readonly conditions: VolleyConditions,
  ) {
    super(kPeriod * (kBalls - 1) + kLast);
    this.character = prepared(chooser.selector.library.createCharacter(), conditions);
    this.random = randomNumbers(conditions.seed);
    this.record();
  }

  /** In words, how the volley goes up to a time. */
  summary(time: number): string {
    const thrown = this.shots.slice(0, Math.floor(time / kPeriod) + 1);
    const last = thrown.at(-1);
    if (!last) return "";
    const met = thrown.filter(({ isMet, contact }) => isMet && contact <= time);
    const damage = met.reduce((sum, { damage_ns }) => sum + damage_ns, 0);
    return `Ball ${thrown.length} of ${kBalls}: ${last.clip.replaceAll("_", " ")}. ${met.length} hit, damage ${damage.toFixed(1)} N s.`;
  }

  free(): void {
    this.character.free();
  }

  protected advance(): void {
    const now = (this.frames.length - 1) / kRate;
    if (this.shots.length < kBalls && now + 1e-6 >= this.shots.length * kPeriod) this.shoot(now);
    for (const shot of this.shots) {
      if (shot.isMet || now + 1 / kRate <= shot.contact - kAhead) continue;
      shot.isMet = true;
      this.character.reactTo({ ...shot.threat, position: shot.position, velocity: shot.velocity });
    }
    this.character.update(1 / kRate);
    this.rise(now);
    this.moveBalls();
    this.record();
  }

  /** Throws the next ball at where the character is now, and lets it answer. */
  private shoot(now: number): void {
    const { position, facing } = this.character.state();
    const { size, mass } = this.conditions;
    const drawn = randomThrow(this.random);
    const thrown = { ...drawn, radius: size * drawn.radius, mass: mass * drawn.mass };
    const threat = moved(threatOf(thrown), position, facing);
    const { library, oracle } = this.chooser.selector;
    const clip = this.answer(threat);
    const trial = oracle.tryClip(this.character, threat, clip);
    this.shots.push({
      threat,
      position: Array.from(threat.position),
      velocity: Array.from(threat.velocity),
      clip: library.clips[clip]!.name,
      contact: now + (trial?.contact_s ?? Infinity),
      isMet: false,
      damage_ns: trial?.damage_ns ?? 0,
    });
  }

  /** The clip that the character answers with. */
  private answer(threat: Threat): number {
    const { character, conditions } = this;
    const { kind, selector } = this.chooser;
    const { library, oracle } = selector;
    const idle = library.info.idle_clip;
    if (kind === "idle") return idle;
    if (kind === "ahead") {
      const { answer, candidates, chosen } = character.lookAhead([threat]);
      return answer === "ok" ? candidates[chosen]!.clip : idle;
    }
    let clip = idle;
    if (kind === "oracle") {
      const { trials } = oracle.tryAll(character, threat);
      clip = bestTrial(trials, oracle, conditions.brawn)?.clip ?? idle;
    } else if (kind === "nearest") {
      clip = oracle.nearestAnnotation(character, threat) ?? idle;
    }
    if (character.perceive(threat) !== "ok") return idle;
    if (kind === "selector") return character.candidates()[0]!.clip;
    const left = character.state().time_to_impact_s;
    if (clip === idle) character.settle();
    else character.respond(clip, left);
    return clip;
  }

  /** A character that lies on the ground stands where it fell, at once for the library, while what
   * is shown rises to it by a blend. */
  private rise(now: number): void {
    if (this.character.reaction().phase !== kKnockedOver) return;
    if (this.risesAt === Infinity) this.risesAt = now + kLies;
    if (now < this.risesAt) return;
    const pose = this.character.pose();
    this.risings.push({ from: now, pose });
    const [x, y] = pose.root_position; // which may be far from where it stood
    this.character.place(x!, y!, this.character.state().facing);
    this.risesAt = Infinity;
  }

  private shownJoints(): JointFrames {
    const now = this.frames.length / kRate;
    const rising = this.risings.at(-1);
    if (!rising || now >= rising.from + kRises) return this.character.jointFrames();
    const pose = blended(rising.pose, this.character.pose(), (now - rising.from) / kRises);
    return this.chooser.selector.library.jointFrames(pose);
  }

  private moveBalls(): void {
    const reaction = this.character.reaction();
    const held = reaction.moved_by === 1 ? this.shots.filter(({ isMet }) => isMet).at(-1) : undefined;
    for (const shot of this.shots) {
      if (shot === held) {
        shot.position.splice(0, 3, ...reaction.ball_position);
        shot.velocity.splice(0, 3, ...reaction.ball_velocity);
      } else {
        fly(shot, shot.threat.radius, 1 / kRate);
      }
    }
  }

  private record(): void {
    const from = Math.max(this.shots.length - kShown, 0);
    this.frames.push({
      joints: this.shownJoints(),
      balls: this.shots.slice(from).map(({ position, threat }, i) => ({
        id: from + i,
        position: [...position] as [number, number, number],
        radius: threat.radius,
      })),
      impulses: this.character.reaction().impulse_ns, // of the last that hit
    });
  }
}

/** A threat to a character at the origin, as one at (x, y) that faces `facing` meets it. */
function moved(threat: Threat, [x, y]: ArrayLike<number> & Iterable<number>, facing: number): Threat {
  const [cosine, sine] = [Math.cos(facing), Math.sin(facing)];
  const turned = ([a, b, c]: number[]) => [cosine * a! - sine * b!, sine * a! + cosine * b!, c!];
  const [px, py, pz] = turned(Array.from(threat.position)) as [number, number, number];
  return { ...threat, position: [px + x!, py + y!, pz], velocity: turned(Array.from(threat.velocity)) };
}

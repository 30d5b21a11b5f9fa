// SPDX-License-Identifier: MIT
// Threats of the kinds that a selector was trained for: punches and bats, beside what is thrown.
import type { Threat, ThreatKind } from "flinch";
import { kGravity, type Throw } from "./throw";

type Vector3 = [number, number, number];

const kFist = 2; // FLINCH_FIST
const kRod = 3; // FLINCH_ROD
const kStrikesAt = 0.8; // share of a rod's length from the butt to the point that strikes
const kGripShare = 0.2; // the grip's speed as a share of that point's
const kFollowThrough = 0.5; // of a swing, as a share of its reach
const kUp: Vector3 = [0, 0, 1];

/** A threat with all that it may have. */
export type FullThreat = Threat & {
  position: Vector3;
  velocity: Vector3;
  starts_in_s: number;
  lasts_s: number;
  axis: Vector3;
  angular_velocity: Vector3;
  to_butt_m: number;
  to_tip_m: number;
};

const plus = (a: Vector3, b: Vector3, share = 1): Vector3 =>
  [0, 1, 2].map((i) => a[i]! + share * b[i]!) as Vector3;
const cross = ([a, b, c]: Vector3, [x, y, z]: Vector3): Vector3 => [
  b * z - c * y,
  c * x - a * z,
  a * y - b * x,
];
const dot = (a: Vector3, b: Vector3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (a: Vector3): Vector3 => {
  const length = Math.hypot(...a);
  return length > 0 ? [a[0] / length, a[1] / length, a[2] / length] : kUp;
};
const middle = (range: ArrayLike<number>) => (range[0]! + range[1]!) / 2;

export function isDriven(kind: ThreatKind | undefined): boolean {
  return kind !== undefined && kind.reach_m[1]! > 0;
}

/** A kind in words, and its usual numbers, as a throw has them. */
export function usual(kind: ThreatKind): Pick<Throw, "speed" | "radius" | "mass"> {
  return { speed: middle(kind.speed_mps), radius: middle(kind.radius), mass: middle(kind.mass_kg) };
}

/** What is thrown straight, driven along a stroke or swung, so that it strikes the throw's aim. */
export function threatOfKind(one: Throw, kind: ThreatKind): FullThreat {
  const angle = (one.azimuth * Math.PI) / 180;
  const reach = isDriven(kind) ? middle(kind.reach_m) : one.speed * one.time;
  const moves = Math.min(reach / one.speed, one.time);
  const rises = isDriven(kind) ? one.from_height - one.aim[2] : 0;
  const along = unit([-Math.cos(angle), -Math.sin(angle), -rises / Math.max(reach, 0.5)]);
  const velocity = along.map((x) => x * one.speed) as Vector3;
  const threat: FullThreat = {
    position: plus(one.aim, velocity, -moves),
    velocity,
    radius: one.radius,
    mass_kg: one.mass,
    kind: one.kind,
    starts_in_s: isDriven(kind) ? one.time - moves : 0,
    lasts_s: isDriven(kind) ? moves : 0,
    axis: [0, 0, 0],
    angular_velocity: [0, 0, 0],
    to_butt_m: 0,
    to_tip_m: 0,
  };
  return kind.shape === kRod ? swung(threat, one, kind, along, moves) : threat;
}

/** The rod that lies across `along` at the impact, to the left, and turns about its grip until then. */
function swung(ball: FullThreat, one: Throw, kind: ThreatKind, along: Vector3, moves: number): FullThreat {
  const length = middle(kind.length_m) - 2 * one.radius;
  const axis = unit(cross(kUp, along));
  const strikes = kStrikesAt * length;
  const rate = ((1 - kGripShare) * one.speed) / strikes;
  const velocity = along.map((x) => kGripShare * one.speed * x) as Vector3;
  const grip = plus(one.aim, axis, -strikes);
  const at_impact: FullThreat = {
    ...ball,
    position: grip,
    velocity,
    starts_in_s: 0,
    lasts_s: moves * (1 + kFollowThrough),
    axis,
    angular_velocity: cross(axis, along).map((x) => rate * x) as Vector3,
    to_tip_m: length,
  };
  return {
    ...at_impact,
    position: plus(grip, velocity, -moves),
    axis: turned(at_impact, -moves),
    starts_in_s: ball.starts_in_s,
  };
}

/** A rod's axis after it has turned for this long. */
function turned({ axis, angular_velocity }: FullThreat, time: number): Vector3 {
  const rate = Math.hypot(...angular_velocity);
  if (rate === 0) return axis;
  const about = unit(angular_velocity);
  const [cosine, sine] = [Math.cos(rate * time), Math.sin(rate * time)];
  const lifted = plus([0, 0, 0], about, dot(about, axis) * (1 - cosine));
  return unit(plus(plus(lifted, axis, cosine), cross(about, axis), sine));
}

/** The threat `time` seconds later. */
export function advanced(threat: FullThreat, kind: ThreatKind, time: number): FullThreat {
  const driven = isDriven(kind);
  const moved = driven ? Math.min(Math.max(time - threat.starts_in_s, 0), threat.lasts_s) : time;
  const falls = !driven && !kind.is_straight ? kGravity : 0;
  const position = plus(threat.position, threat.velocity, moved);
  return {
    ...threat,
    position: plus(position, kUp, -(falls * moved * moved) / 2),
    velocity: plus(threat.velocity, kUp, -falls * moved),
    axis: turned(threat, moved),
    starts_in_s: Math.max(threat.starts_in_s - time, 0),
    lasts_s: threat.lasts_s - (driven ? moved : 0),
  };
}

/** Whether it needs more than a ball in free flight to be drawn. */
export function isSpecial(kind: ThreatKind | undefined): kind is ThreatKind {
  return kind !== undefined && (kind.shape === kFist || kind.shape === kRod || kind.is_straight === 1);
}

// SPDX-License-Identifier: MIT
// A throw as the visitor sets it, and the threat that it is.
import type { Threat, ThreatKind } from "flinch";
import { isSpecial, threatOfKind } from "./kinds";

export const kGravity = 9.81;

/** Angles in degrees, else SI units. The ball flies freely and passes through `aim`. */
export interface Throw {
  azimuth: number; // where it comes from, counter-clockwise from the character's facing
  from_height: number; // of the hand that throws
  aim: [number, number, number]; // world, on the standing figure
  speed: number; // along the ground
  time: number; // to the impact
  radius: number;
  mass: number;
  kind: number; // of those that the selector knows
}

export const kDefaultThrow: Throw = {
  azimuth: 20,
  from_height: 1.6,
  aim: [0.05, 0, 1.55],
  speed: 12,
  time: 0.6,
  radius: 0.105,
  mass: 0.27,
  kind: 0,
};

/** What sliders and links may ask for. */
export const kRanges = {
  azimuth: [-180, 180],
  from_height: [0.1, 3],
  speed: [3, 40],
  time: [0.15, 1.5],
  radius: [0.01, 0.25],
  mass: [0.02, 6],
} as const;
const kAimRange = [
  [-0.6, 0.6],
  [-0.9, 0.9],
  [0.05, 2],
] as const;

export function clamp(value: number, [low, high]: readonly [number, number]): number {
  return Math.min(Math.max(value, low), high);
}

/** The nearest throw within the ranges; numbers that are not finite become the default's. */
export function allowed(wanted: Throw): Throw {
  const result = { ...kDefaultThrow, aim: [...kDefaultThrow.aim] as Throw["aim"] };
  for (const key of Object.keys(kRanges) as (keyof typeof kRanges)[])
    if (Number.isFinite(wanted[key])) result[key] = clamp(wanted[key], kRanges[key]);
  for (let i = 0; i < 3; ++i)
    if (Number.isFinite(wanted.aim[i])) result.aim[i] = clamp(wanted.aim[i]!, kAimRange[i]!);
  if (wanted.kind > 0) result.kind = Math.floor(Math.min(wanted.kind, 15));
  return result;
}

/** Position and velocity at the moment of the throw: from + v t - g t^2 / 2 = aim. Without `kinds`, or
 * where there is no such kind, a ball is thrown. */
export function threatOf(one: Throw, kinds: readonly ThreatKind[] = []): Threat {
  const kind = kinds[one.kind];
  if (isSpecial(kind)) return threatOfKind(one, kind);
  const angle = (one.azimuth * Math.PI) / 180;
  const towards = [-Math.cos(angle), -Math.sin(angle)];
  const distance = one.speed * one.time;
  const [x, y, z] = one.aim;
  const rise = (z - one.from_height) / one.time + (kGravity * one.time) / 2;
  return {
    position: [x - towards[0]! * distance, y - towards[1]! * distance, one.from_height],
    velocity: [towards[0]! * one.speed, towards[1]! * one.speed, rise],
    radius: one.radius,
    mass_kg: one.mass,
    kind: kind ? one.kind : 0,
  };
}

/** Uniform numbers from a seed: mulberry32. */
export function randomNumbers(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let bits = Math.imul(state ^ (state >>> 15), state | 1);
    bits ^= bits + Math.imul(bits ^ (bits >>> 7), bits | 61);
    return ((bits ^ (bits >>> 14)) >>> 0) / 4294967296;
  };
}

/** A throw from anywhere at any part of the body. */
export function randomThrow(random: () => number): Throw {
  const within = (low: number, high: number) => low + (high - low) * random();
  const radius = within(0.05, 0.16);
  return allowed({
    azimuth: within(-180, 180),
    from_height: within(0.6, 2.2),
    aim: [within(-0.05, 0.1), within(-0.2, 0.2), within(0.35, 1.7)],
    speed: within(7, 22),
    time: within(0.35, 1),
    radius,
    mass: within(0.15, 0.6),
    kind: 0,
  });
}

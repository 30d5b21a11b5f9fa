// SPDX-License-Identifier: MIT
import type { Pose } from "flinch";

/** The pose at a share of the way from one to another: the root's place and every joint's rotation
 * on the shortest way, slowly at both ends (3 s^2 - 2 s^3). */
export function blended(from: Pose, to: Pose, share: number): Pose {
  const s = Math.min(Math.max(share, 0), 1);
  const eased = s * s * (3 - 2 * s);
  return {
    root_position: from.root_position.map((value, i) => value + eased * (to.root_position[i]! - value)),
    rotation: rotations(from.rotation, to.rotation, eased),
  };
}

/** Normalised linear interpolation of quaternions, four numbers each. */
function rotations(from: Float32Array, to: Float32Array, share: number): Float32Array {
  const mixed = new Float32Array(from.length);
  for (let at = 0; at < from.length; at += 4) {
    const pairs = [0, 1, 2, 3].map((i) => [from[at + i]!, to[at + i]!] as const);
    const sign = pairs.reduce((dot, [a, b]) => dot + a * b, 0) < 0 ? -1 : 1;
    const sum = pairs.map(([a, b]) => (1 - share) * a + share * sign * b);
    const length = Math.hypot(...sum);
    sum.forEach((value, i) => {
      mixed[at + i] = value / length;
    });
  }
  return mixed;
}

// SPDX-License-Identifier: MIT
// How a chooser answers throws from all around, at all heights: what the threat rose shows.
import { beforeThrow, bestTrial, choose, costOf, type Chooser } from "./chooser";
import { allowed, threatOf, type Throw } from "./throw";

export const kSectors = 24;
export const kHeights = [0.35, 0.65, 0.95, 1.2, 1.42, 1.62]; // m, of the aim

export interface Petal {
  thrown: Throw;
  clip: string;
  kind: string;
  prevented: number; // share of the cost of idling
}
export type Ring = Petal[]; // of one height, for each sector

export interface RoseConditions {
  base: Throw; // with the ball's speed, size, mass and time
  delay: number;
  brawn: number;
}

/** The rings, the lowest height first. */
export function* ringsOf(chooser: Chooser, conditions: RoseConditions): Generator<Ring> {
  for (const height of kHeights)
    yield Array.from({ length: kSectors }, (_, sector) => {
      const azimuth = (((sector * 360) / kSectors + 180) % 360) - 180;
      const aim: Throw["aim"] = [0.02, 0, height];
      return petalOf(chooser, allowed({ ...conditions.base, azimuth, aim }), conditions);
    });
}

function petalOf(chooser: Chooser, thrown: Throw, { delay, brawn }: RoseConditions): Petal {
  const { selector, kind } = chooser;
  const { library, oracle } = selector;
  const threat = threatOf(thrown);
  const best =
    kind === "oracle"
      ? bestTrial(oracle.tryAll(beforeThrow(selector, { delay }), threat).trials, oracle, brawn)
      : null;
  const clip = best?.clip ?? choose(chooser, beforeThrow(selector, { delay }), threat);
  const character = beforeThrow(selector, { delay });
  const idle = oracle.tryClip(character, threat, library.info.idle_clip);
  const own = clip === library.info.idle_clip ? idle : oracle.tryClip(character, threat, clip);
  const cost = idle ? costOf(idle, oracle, brawn) : 0;
  const prevented = own && cost > 0 ? 1 - costOf(own, oracle, brawn) / cost : 0;
  const { name, kind: what } = library.clips[clip]!;
  return { thrown, clip: name, kind: what || "idle", prevented };
}

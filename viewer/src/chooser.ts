// SPDX-License-Identifier: MIT
// Who answers a throw: a selector, one of the baselines, looking ahead, or the oracle.
import type { Character, Flinch, Library, Oracle, Scenario, Threat, Trial } from "flinch";

export type ChooserKind = "selector" | "nearest" | "ahead" | "oracle" | "idle";

/** A selector file, loaded. */
export interface Selector {
  name: string;
  library: Library;
  oracle: Oracle;
  probe: Character; // to ask what would be; see beforeThrow()
}

export interface Chooser {
  kind: ChooserKind;
  name: string;
  about: string;
  selector: Selector;
}

/** How a throw finds a character. */
export interface Start {
  delay: number; // of the reaction, s
  stance?: number; // of those of the library; 0, the idle clip, if there is no such
  time?: number; // s, after which it is at the origin, if it goes on as it is
}

export interface Conditions extends Required<Start> {
  threat: Threat;
  brawn: number; // weight of work against damage, 0 to 1
}

const kLookedAt = 8; // candidates that looking ahead simulates

export function loadSelector(flinch: Flinch, name: string, bytes: Uint8Array): Selector {
  const library = flinch.load(bytes);
  try {
    return { name, library, oracle: library.createOracle(), probe: library.createCharacter() };
  } catch (error) {
    library.free();
    throw error;
  }
}

/** The selectors, at most three, and what they are compared with on the first one's clips. */
export function choosersOf(selectors: readonly Selector[]): Chooser[] {
  const [first] = selectors;
  if (!first) return [];
  const chosen = selectors
    .slice(0, 3)
    .map(
      (selector): Chooser => ({
        kind: "selector",
        name: selector.name,
        about: "the trained selector",
        selector,
      }),
    );
  const others: [ChooserKind, string, string][] = [
    ["ahead", "Look-ahead", `simulates the ${kLookedAt} best clips of ${first.name}`],
    ["oracle", "Oracle", "simulates every clip: the best that is possible"],
    ["idle", "Idle", "goes on as it is"],
    ["nearest", "Nearest", "the clip with the nearest annotation, as games script it"],
  ];
  for (const [kind, name, about] of others) chosen.push({ kind, name, about, selector: first });
  return chosen;
}

export function costOf(trial: Trial, oracle: Oracle, brawn: number): number {
  const { work_weight_ns_per_j } = oracle.costs();
  return (1 - brawn) * trial.damage_ns + brawn * work_weight_ns_per_j * trial.work_j;
}

/** The best trial by the trainer's rule: least cost; within 1 % of it, less work. */
export function bestTrial(trials: readonly Trial[], oracle: Oracle, brawn: number): Trial | null {
  const costs = trials.map((trial) => costOf(trial, oracle, brawn));
  const near = Math.min(...costs) * 1.01;
  let best: Trial | null = null;
  trials.forEach((trial, i) => {
    if (costs[i]! <= near && (!best || trial.work_j < best.work_j)) best = trial;
  });
  return best;
}

/** Puts a character in a stance where it comes to the origin in so much time. */
function approach(character: Character, stance: number, time: number): void {
  character.place(0, 0, 0, 0, stance);
  const from = character.pose().root_position;
  character.update(time);
  const to = character.pose().root_position;
  character.place(from[0]! - to[0]!, from[1]! - to[1]!, 0, 0, stance);
}

/** A character as a throw finds it. */
export function prepared(character: Character, { delay, stance = 0, time = 0 }: Start): Character {
  if (stance > 0 && stance < character.library.stances.length) approach(character, stance, time);
  else character.place(0, 0);
  character.limitPerception({
    reaction_delay_s: delay,
    bearing_noise: 0,
    distance_noise: 0,
    heading_noise: 0,
    speed_noise: 0,
    chance_to_fail: 0,
  });
  return character;
}

/** The selector's probe, as a throw finds a character. */
export function beforeThrow({ probe }: Selector, start: Start): Character {
  return prepared(probe, start);
}

/** The clip that a chooser other than the oracle answers with; the character answers with it. */
export function choose(chooser: Chooser, character: Character, threat: Threat): number {
  const { library, oracle } = chooser.selector;
  switch (chooser.kind) {
    case "selector":
      if (character.perceive(threat) !== "ok") return library.info.idle_clip;
      return character.candidates()[0]!.clip;
    case "ahead": {
      const { answer, candidates, chosen } = character.lookAhead([threat], {
        candidates: kLookedAt,
      });
      return answer === "ok" ? candidates[chosen]!.clip : library.info.idle_clip;
    }
    case "nearest":
      return oracle.nearestAnnotation(character, threat) ?? library.info.idle_clip;
    default:
      return library.info.idle_clip;
  }
}

/** The same in a scenario of training, whose target and time are known. */
export function chooseIn({ kind, selector }: Chooser, scenario: Scenario): number {
  const { library } = selector;
  if (kind === "selector") return library.chooseIn(scenario);
  if (kind === "ahead") return library.chooseIn(scenario, kLookedAt);
  if (kind === "nearest") return library.nearestIn(scenario);
  return library.info.idle_clip;
}

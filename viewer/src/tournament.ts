// SPDX-License-Identifier: MIT
// Seeded throws at all choosers, and how much of what is possible each protects:
//
//   protection = (mean cost of idling - mean cost of the chooser)
//              / (mean cost of idling - mean cost of the oracle)
//
// with the interval of 95 of 100 bootstrap resamples of the throws.
import { atRest, bestTrial, choose, costOf, type Chooser, type Conditions } from "./chooser";
import { randomNumbers, randomThrow, threatOf } from "./throw";

export interface Standing {
  name: string;
  cost_ns: number; // mean
  protection: number;
  low: number;
  high: number;
}

export interface TournamentPlan {
  seed: number;
  throws: number;
  delay: number;
  brawn: number;
}

const kResamples = 400;

/** Plays throw after throw; yields the standings after each that hits an idle character. */
export function* playTournament(choosers: readonly Chooser[], plan: TournamentPlan) {
  const random = randomNumbers(plan.seed);
  const costs: number[][] = choosers.map(() => []); // one per throw
  for (let thrown = 0; thrown < plan.throws; ) {
    const conditions = { ...plan, threat: threatOf(randomThrow(random)) };
    const row = costsOf(choosers, conditions);
    if (!row) continue; // would hit nothing
    row.forEach((cost, i) => costs[i]!.push(cost));
    ++thrown;
    yield { standings: standingsOf(choosers, costs, plan.seed), thrown };
  }
}

/** What a throw costs each chooser; none if it misses. */
function costsOf(choosers: readonly Chooser[], conditions: Conditions): number[] | null {
  const { threat, delay, brawn } = conditions;
  const row: number[] = [];
  for (const chooser of choosers) {
    const { selector, kind } = chooser;
    const { oracle } = selector;
    const clip = choose(chooser, atRest(selector, delay), conditions);
    const character = atRest(selector, delay);
    const trial =
      kind === "oracle"
        ? bestTrial(oracle.tryAll(character, threat).trials, oracle, brawn)
        : oracle.tryClip(character, threat, clip);
    if (!trial) return null;
    row.push(costOf(trial, oracle, brawn));
  }
  return row;
}

function standingsOf(
  choosers: readonly Chooser[],
  costs: readonly number[][],
  seed: number,
): Standing[] {
  const idle = costs[choosers.findIndex(({ kind }) => kind === "idle")]!;
  const best = costs[choosers.findIndex(({ kind }) => kind === "oracle")]!;
  const random = randomNumbers(seed ^ 0x5bd1e995);
  const samples = Array.from({ length: kResamples }, () =>
    idle.map(() => Math.floor(random() * idle.length)),
  );
  const every = idle.map((_, i) => i);
  const protection = (own: readonly number[], of: readonly number[]) => {
    const sum = (values: readonly number[]) => of.reduce((total, i) => total + values[i]!, 0);
    const possible = sum(idle) - sum(best);
    return possible > 0 ? (sum(idle) - sum(own)) / possible : 0;
  };
  return choosers.map(({ name }, i) => {
    const own = costs[i]!;
    const resampled = samples.map((of) => protection(own, of)).sort((a, b) => a - b);
    return {
      name,
      cost_ns: own.reduce((total, cost) => total + cost, 0) / own.length,
      protection: protection(own, every),
      low: resampled[Math.floor(0.025 * kResamples)]!,
      high: resampled[Math.ceil(0.975 * kResamples) - 1]!,
    };
  });
}

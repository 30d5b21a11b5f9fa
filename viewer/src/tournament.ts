// SPDX-License-Identifier: MIT
// The scenarios of training at all choosers, and how much of what is possible each protects:
//
//   protection = (mean cost of idling - mean cost of the chooser)
//              / (mean cost of idling - mean cost of the oracle)
//
// with the interval of 95 of 100 bootstrap resamples of the scenarios. Scenarios, choices and costs
// are those of `flinch simulate` and `flinch compare` for the same seed.
import type { Scenario, Trial } from "flinch";
import { bestTrial, chooseIn, costOf, type Chooser, type Selector } from "./chooser";
import { randomNumbers } from "./throw";

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
  brawn: number;
}

const kResamples = 400;

/** Plays scenario after scenario; yields the standings after each. */
export function* playTournament(
  choosers: readonly Chooser[],
  plan: TournamentPlan,
): Generator<{ standings: Standing[]; thrown: number }> {
  const costs: number[][] = choosers.map(() => []); // one per scenario
  const { library } = choosers[0]!.selector;
  for (let number = 0; number < plan.throws; ++number) {
    const scenario = library.drawScenario(plan.seed, number);
    costsOf(choosers, scenario, plan.brawn).forEach((cost, i) => costs[i]!.push(cost));
    yield { standings: standingsOf(choosers, costs, plan.seed), thrown: number + 1 };
  }
}

/** What a scenario costs each chooser. */
function costsOf(choosers: readonly Chooser[], scenario: Scenario, brawn: number): number[] {
  const known = new Map<Selector, Trial[]>();
  const trialsOf = (selector: Selector): Trial[] => {
    const same = [...known.keys()].find((other) => haveSameClips(other, selector));
    const trials = same ? known.get(same)! : selector.oracle.tryScenario(scenario).trials;
    known.set(selector, trials);
    return trials;
  };
  return choosers.map((chooser) => {
    const { selector, kind } = chooser;
    const trials = trialsOf(selector);
    const clip = kind === "oracle" ? null : chooseIn(chooser, scenario);
    const trial =
      clip === null
        ? bestTrial(trials, selector.oracle, brawn)
        : trials.find((one) => one.clip === clip);
    if (!trial) throw new Error(`${chooser.name} chose a clip that cannot answer`);
    return costOf(trial, choosers[0]!.selector.oracle, brawn);
  });
}

/** Whether clips can be simulated once for both selectors. */
function haveSameClips({ library: a }: Selector, { library: b }: Selector): boolean {
  const same = (i: number) =>
    a.clips[i]!.name === b.clips[i]!.name && a.clips[i]!.duration_s === b.clips[i]!.duration_s;
  return a === b || (a.clips.length === b.clips.length && a.clips.every((_, i) => same(i)));
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

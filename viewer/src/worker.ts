// SPDX-License-Identifier: MIT
// What takes tenths of a second: the oracle's choice, tournaments and roses.
import { loadFlinch, type Trial } from "flinch";
import { beforeThrow, bestTrial, choosersOf, loadSelector, type Conditions, type Selector } from "./chooser";
import { ringsOf, type Ring, type RoseConditions } from "./petals";
import { playTournament, type Standing, type TournamentPlan } from "./tournament";

export interface SelectorFile {
  name: string;
  bytes: Uint8Array;
}
export type Request =
  | { kind: "load"; module: WebAssembly.Module; selectors: SelectorFile[] }
  | { kind: "oracle"; id: number; conditions: Conditions }
  | ({ kind: "tournament"; id: number } & TournamentPlan)
  | { kind: "rose"; id: number; chooser: number; conditions: RoseConditions };
export type Reply =
  | { kind: "oracle"; id: number; best: Trial | null; trials: Trial[]; took_ms: number }
  | { kind: "tournament"; id: number; standings: Standing[]; thrown: number }
  | { kind: "rose"; id: number; ring: Ring };

let selectors: Selector[] = [];
const latest = { tournament: 0, rose: 0 }; // that were asked for
const post = (reply: Reply) => self.postMessage(reply);

async function load({ module, selectors: files }: Extract<Request, { kind: "load" }>) {
  const flinch = await loadFlinch(module);
  selectors = files.map(({ name, bytes }) => loadSelector(flinch, name, bytes));
}

function askOracle({ id, conditions }: Extract<Request, { kind: "oracle" }>) {
  const begin = performance.now();
  const selector = selectors[0]!;
  const { trials } = selector.oracle.tryAll(beforeThrow(selector, conditions), conditions.threat);
  const best = bestTrial(trials, selector.oracle, conditions.brawn);
  post({ kind: "oracle", id, best, trials, took_ms: performance.now() - begin });
}

async function play({ id, ...plan }: Extract<Request, { kind: "tournament" }>) {
  latest.tournament = id;
  for (const { standings, thrown } of playTournament(choosersOf(selectors), plan)) {
    if (latest.tournament !== id) return;
    post({ kind: "tournament", id, standings, thrown });
    await otherRequests();
  }
}

async function pick({ id, chooser, conditions }: Extract<Request, { kind: "rose" }>) {
  latest.rose = id;
  for (const ring of ringsOf(choosersOf(selectors)[chooser]!, conditions)) {
    if (latest.rose !== id) return;
    post({ kind: "rose", id, ring });
    await otherRequests();
  }
}

const otherRequests = () => new Promise((resolve) => setTimeout(resolve));

function answer(request: Exclude<Request, { kind: "load" }>) {
  if (request.kind === "oracle") askOracle(request);
  else if (request.kind === "rose") void pick(request);
  else void play(request);
}

let loaded: Promise<void> = Promise.resolve();
self.onmessage = ({ data }: MessageEvent<Request>) => {
  if (data.kind === "load") loaded = load(data);
  else void loaded.then(() => answer(data));
};

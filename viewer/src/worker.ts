// SPDX-License-Identifier: MIT
// What takes tenths of a second: the oracle's choice, and tournaments.
import { loadFlinch, type Threat, type Trial } from "flinch";
import { atRest, bestTrial, choosersOf, loadSelector, type Selector } from "./chooser";
import { playTournament, type Standing } from "./tournament";

export interface SelectorFile {
  name: string;
  bytes: Uint8Array;
}
export type Request =
  | { kind: "load"; module: WebAssembly.Module; selectors: SelectorFile[] }
  | { kind: "oracle"; id: number; threat: Threat; delay: number; brawn: number }
  | { kind: "tournament"; id: number; seed: number; throws: number; delay: number; brawn: number };
export type Reply =
  | { kind: "oracle"; id: number; best: Trial | null; trials: Trial[]; took_ms: number }
  | { kind: "tournament"; id: number; standings: Standing[]; thrown: number };

let selectors: Selector[] = [];
let current = 0; // the last tournament that was asked for
const post = (reply: Reply) => self.postMessage(reply);

async function load({ module, selectors: files }: Extract<Request, { kind: "load" }>) {
  const flinch = await loadFlinch(module);
  selectors = files.map(({ name, bytes }) => loadSelector(flinch, name, bytes));
}

function askOracle({ id, threat, delay, brawn }: Extract<Request, { kind: "oracle" }>) {
  const begin = performance.now();
  const selector = selectors[0]!;
  const { trials } = selector.oracle.tryAll(atRest(selector, delay), threat);
  const best = bestTrial(trials, selector.oracle, brawn);
  post({ kind: "oracle", id, best, trials, took_ms: performance.now() - begin });
}

async function play(request: Extract<Request, { kind: "tournament" }>) {
  const { id, seed, throws, delay, brawn } = request;
  current = id;
  for (const { standings, thrown } of playTournament(choosersOf(selectors), {
    seed,
    throws,
    delay,
    brawn,
  })) {
    if (current !== id) return;
    post({ kind: "tournament", id, standings, thrown });
    await new Promise((resolve) => setTimeout(resolve)); // lets other requests in
  }
}

let loaded: Promise<void> = Promise.resolve();
self.onmessage = ({ data }: MessageEvent<Request>) => {
  if (data.kind === "load") loaded = load(data);
  else void loaded.then(() => (data.kind === "oracle" ? askOracle(data) : play(data)));
};

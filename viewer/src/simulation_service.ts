// SPDX-License-Identifier: MIT
// Simulations in a worker, so that the page never waits.
import type { Trial } from "flinch";
import type { Conditions } from "./chooser";
import type { Ring, RoseConditions } from "./petals";
import type { Standing, TournamentPlan } from "./tournament";
import FlinchWorker from "./worker?worker&inline";
import type { Reply, Request, SelectorFile } from "./worker";

type Found = (best: Trial | null) => void;
type OracleRequest = Extract<Request, { kind: "oracle" }>;

export class SimulationService {
  private readonly worker = new FlinchWorker();
  private next = 0;
  private found: Found | null = null; // of the request that the worker has
  private waiting: [OracleRequest, Found] | null = null; // the latest that it has not
  private progress: ((standings: Standing[], thrown: number) => void) | null = null;
  private ring: ((ring: Ring) => void) | null = null;
  private rose = 0; // the last that was asked for
  /** How long the oracle took for the throws so far, ms. */
  readonly took_ms: number[] = [];

  constructor(module: WebAssembly.Module, selectors: SelectorFile[]) {
    this.send({ kind: "load", module, selectors });
    this.worker.onmessage = ({ data }: MessageEvent<Reply>) => {
      if (data.kind === "tournament") this.progress?.(data.standings, data.thrown);
      else if (data.kind === "oracle") this.answered(data);
      else if (data.id === this.rose) this.ring?.(data.ring);
    };
  }

  /** Asks for the oracle's choice. Of several questions at once only the last is answered. */
  ask(conditions: Conditions, found: Found): void {
    const request: OracleRequest = { kind: "oracle", id: ++this.next, conditions };
    if (this.found) {
      this.waiting = [request, found];
      return;
    }
    this.found = found;
    this.send(request);
  }

  play(plan: TournamentPlan, progress: (standings: Standing[], thrown: number) => void): void {
    this.progress = progress;
    this.send({ kind: "tournament", id: ++this.next, ...plan });
  }

  /** Asks for the petals of a rose, ring after ring. Ends those of the rose before. */
  pick(chooser: number, conditions: RoseConditions, ring: (ring: Ring) => void): void {
    this.ring = ring;
    this.rose = ++this.next;
    this.send({ kind: "rose", id: this.rose, chooser, conditions });
  }

  /** What was asked for is no longer wanted. */
  stop(): void {
    this.worker.terminate();
  }

  private answered({ best, took_ms }: Extract<Reply, { kind: "oracle" }>): void {
    this.took_ms.push(took_ms);
    const found = this.found!;
    const waiting = this.waiting;
    this.found = this.waiting = null;
    if (waiting) {
      this.found = waiting[1];
      this.send(waiting[0]);
    } else {
      found(best);
    }
  }

  private send(request: Request): void {
    this.worker.postMessage(request);
  }
}

// SPDX-License-Identifier: MIT
// The reports of `flinch compare` and `flinch train-realism`, as report.json and timing.json have
// them (docs/program.md, docs/pushing.md).

export type Number = number | null; // null: not a number
export type Interval = [Number, Number];
export type Row = Record<string, Number | string | Interval>;

export interface Result extends Row {
  name: string;
  accuracy: Number;
  mean_cost: Number;
  regret: Number;
  regret_ci: Interval;
  protection: Number;
  protection_ci: Interval;
}

export interface Timing {
  name: string;
  median_us: number;
  p99_us: number;
  fit_s: number;
}

export interface Origin {
  seed: number;
  scenarios: number;
  distribution: unknown;
  simulation: unknown;
}

/** What every report tells of its origin. */
export interface Source {
  version: string;
  library: string;
  library_hash: string;
}

export interface Report extends Source {
  options: Record<string, unknown>;
  stores: { fitted: Origin; tested: Origin };
  test_store: boolean;
  features: string[];
  clips: string[]; // in the library's order
  scenarios_fitted: number;
  scenarios_tested: number;
  cost_model: {
    brawn: number;
    reference_damage_ns: number[]; // of each kind of threat
    reference_work_j: number;
    vulnerability_name: string;
    vulnerability: Record<string, number>;
  };
  rows: Result[];
  look_ahead: (Result & { candidates: number; encounters: number })[];
  methods: { name: string; parameters: Record<string, string | number>; cross_validated_regret: Number }[];
  sizes: { name: string; file_bytes: number }[];
  groups: Row[];
  directions: Row[];
  confusions: Row[];
  reliability: Row[];
  noise: Row[];
  curves: Row[];
  transfer: Row[];
  ablation: Row[];
  brawn: Row[];
  prevention: Row[];
  timing: Timing[];
}

/** How well a realism model agrees with labels that it was not fitted to. */
export interface Agreement extends Row {
  name: string; // "ours" or "paper": what the model sees
  labels: number; // that it was fitted to, at most
  agreement: Number;
  auc: Number;
}

export interface RealismReport extends Source {
  kind: "realism";
  judge: string;
  is_proxy: boolean;
  realism: string; // the model that the selector got: "ours" or "paper"
  labels: number;
  good: number; // labels above 0.5
  sittings: number;
  chance: Number; // agreement of always saying what most labels say
  baseline_auc: Number; // of the nearest configuration
  rows: Agreement[]; // fitted to all labels
  curve: Agreement[]; // fitted to fewer
}

/** Reads the report that the program has put into the page. Throws if there is none. */
export function embeddedReport(): Report | RealismReport {
  const text = document.getElementById("report")?.textContent;
  if (!text) throw new Error("this page holds no report: --report of flinch compare and train-realism writes one that does");
  return JSON.parse(text) as Report | RealismReport;
}

/** A number as people read it, with so many decimals. */
export function fixed(value: unknown, decimals: number): string {
  return typeof value === "number" ? value.toFixed(decimals).replace("-", "−") : "–";
}

export function interval(value: unknown, decimals: number): string {
  return Array.isArray(value) ? `${fixed(value[0], decimals)} to ${fixed(value[1], decimals)}` : "–";
}

/** Distinct values of a column, in the order in which they occur. */
export function valuesOf(rows: readonly Row[], column: string): string[] {
  return [...new Set(rows.map((row) => String(row[column])))];
}

// SPDX-License-Identifier: MIT
// The charts of a report: for each what it shows, its numbers, and how they are drawn.
import { confusionMatrix } from "./confusion";
import type { Frame } from "./look";
import { bars, heat, intervals, lines, stackedShares, type Drawing } from "./plots";
import { polarMaps } from "./polar";
import { valuesOf, type Report, type Row } from "./report";

export interface Chart<R = Report> {
  id: string; // the name of its SVG file
  title: string;
  about: string;
  is_wide?: boolean;
  /** Values of which a reader picks one, the first unless they do. */
  choices?: (report: R) => readonly string[];
  /** The numbers that are drawn, of the selectors that are shown; none: there is no such chart. */
  rows(report: R, shown: ReadonlySet<string>, choice: string): Row[];
  draw(rows: readonly Row[], frame: Frame, choice: string, report: R): Drawing;
}

const isShown = (shown: ReadonlySet<string>) => (row: Row) => shown.has(String(row.name));

const withInterval = (value: "regret" | "protection") => (report: Report, shown: ReadonlySet<string>) =>
  report.rows
    .filter((row) => row.name !== "oracle" && row[value] !== null)
    .filter(isShown(shown))
    .map((row): Row => ({ name: row.name, [value]: row[value], [`${value}_ci`]: row[`${value}_ci`] }));

/** Each selector alone, if it has a time, and looking ahead at more and more candidates. */
function frontierRows(report: Report, shown: ReadonlySet<string>): Row[] {
  const us = new Map(report.timing.map((one) => [one.name, one.median_us]));
  const point = (name: string, row: Report["rows"][number], candidates: number): Row => ({
    name, candidates, median_us: us.get(row.name) ?? null, protection: row.protection,
    protection_ci: row.protection_ci,
  });
  const ahead = report.look_ahead.map((row) => point(row.name.split("+")[0]!, row, row.candidates));
  const alone = report.rows.filter((row) => us.has(row.name)).map((row) => point(row.name, row, 1));
  return [...alone, ...ahead]
    .filter((row) => Number(row.median_us) > 0 && row.protection !== null)
    .filter(isShown(shown))
    .sort((a, b) => Number(a.candidates) - Number(b.candidates));
}

const ofGroup = (key: "groups" | "prevention") => (report: Report) => valuesOf(report[key], "group");

export const kCharts: readonly Chart[] = [
  {
    id: "protection",
    title: "Protection",
    about: "0 is standing still, 1 the oracle, which simulates every clip. Lines are 95 % intervals.",
    rows: withInterval("protection"),
    draw: (rows, frame) => intervals(rows, "protection", "protection", frame),
  },
  {
    id: "regret",
    title: "Regret",
    about: "Mean cost above the oracle's. Lines are 95 % intervals.",
    rows: withInterval("regret"),
    draw: (rows, frame) => intervals(rows, "regret", "regret, N s", frame),
  },
  {
    id: "frontier",
    title: "What a microsecond buys",
    about: "Each selector alone, and looking ahead: simulating its best candidates and taking the cheapest.",
    is_wide: true,
    rows: frontierRows,
    draw: (rows, frame) =>
      lines({ rows, x: "median_us", y: "protection" }, {
        x_label: "median time to choose, µs", y_label: "protection", logarithmic_x: true,
        towards_one: true, columns: ["name", "candidates", "median_us", "protection"],
      }, frame),
  },
  {
    id: "groups",
    title: "Regret by group, N s",
    about: "Where selectors lose: a darker cell is a larger regret.",
    choices: ofGroup("groups"),
    is_wide: true,
    rows: (report, shown, group) =>
      report.groups.filter((row) => row.group === group && row.name !== "oracle").filter(isShown(shown)),
    draw: (rows, frame) =>
      heat(rows, {
        x: "name", y: "value", value: "regret",
        columns: ["name", "value", "scenarios", "regret", "protection", "mean_cost"],
      }, frame),
  },
  {
    id: "directions",
    title: "Where threats come from",
    about: "Seen from above, the character faces up. Rings are what the ball flies at: the legs inside, then pelvis, trunk and head.",
    is_wide: true,
    choices: () => ["regret", "protection", "mean_cost"],
    rows: (report, shown) => report.directions.filter((row) => row.name !== "oracle").filter(isShown(shown)),
    draw: (rows, frame, value) =>
      polarMaps(rows, { value, label: value.replace("_", " "), ...(value === "protection" ? { most: 1 } : {}) }, frame),
  },
  {
    id: "curves",
    title: "Learning curves",
    about: "The same selectors fitted to fewer scenarios.",
    rows: (report, shown) => report.curves.filter(isShown(shown)),
    draw: (rows, frame) =>
      lines({ rows, x: "scenarios_fitted", y: "protection" }, {
        x_label: "training scenarios", y_label: "protection", logarithmic_x: true,
        columns: ["name", "scenarios_fitted", "protection", "regret"],
      }, frame),
  },
  {
    id: "noise",
    title: "Noise on the features",
    about: "Normal noise whose standard deviation is this share of half a feature's range.",
    rows: (report, shown) => report.noise.filter(isShown(shown)),
    draw: (rows, frame) =>
      lines({ rows, x: "noise", y: "protection" }, {
        x_label: "standard deviation, share of half the range", y_label: "protection",
        columns: ["name", "noise", "protection", "regret"],
      }, frame),
  },
  {
    id: "votes",
    title: "Regret by share of votes",
    about: "Ten bins of equally many scenarios: does a selector know when it is unsure?",
    rows: (report, shown) => report.reliability.filter((row) => row.said === "vote").filter(isShown(shown)),
    draw: (rows, frame) =>
      lines({ rows, x: "mean_said", y: "mean_regret" }, {
        x_label: "share of votes for the choice", y_label: "regret, N s",
        columns: ["name", "mean_said", "mean_regret", "accuracy", "scenarios"],
      }, frame),
  },
  {
    id: "expected_cost",
    title: "Actual cost by expected cost",
    about: "Ten bins of equally many scenarios; on the dashed line expectations come true.",
    rows: (report, shown) =>
      report.reliability.filter((row) => row.said === "expected_cost_ns").filter(isShown(shown)),
    draw: (rows, frame) =>
      lines({ rows, x: "mean_said", y: "mean_cost" }, {
        x_label: "expected cost, N s", y_label: "mean cost, N s", diagonal: true,
        columns: ["name", "mean_said", "mean_cost", "accuracy", "scenarios"],
      }, frame),
  },
  {
    id: "confusion",
    title: "Confusion among clips",
    about: "Which clip was chosen where which was the best. The diagonal is right; beside it the regret counts, which a clip's twin may not cost.",
    is_wide: true,
    choices: (report) => {
      const methods = report.methods.map(({ name }) => name);
      return [...new Set([...methods, ...valuesOf(report.confusions, "name")])];
    },
    rows: (report, _, name) =>
      report.confusions.filter((row) => row.name === name)
        .sort((a, b) => Number(b.scenarios) - Number(a.scenarios)),
    draw: (rows, frame, _, report) => confusionMatrix(rows, report.clips, frame),
  },
  {
    id: "brawn",
    title: "What the oracle does by brawn",
    about: "Brawn is the weight of work against damage: at 0 only damage counts, at 1 only work.",
    is_wide: true,
    rows: (report) => {
      const known = new Set(["brawn", "mean_damage", "mean_work", "other_target", "far_direction", "luck"]);
      return report.brawn.flatMap((row) =>
        Object.entries(row).filter(([key]) => !known.has(key))
          .map(([kind, share]): Row => ({ brawn: row.brawn!, kind, share: share as number,
            mean_damage: row.mean_damage!, mean_work: row.mean_work! })));
    },
    draw: (rows, frame) => stackedShares(rows, { x: "brawn", kind: "kind", share: "share" }, frame),
  },
  {
    id: "prevention",
    title: "What can be prevented at all",
    about: "Share of the cost of standing still that the oracle prevents, over all scenarios of the store.",
    choices: (report) => ofGroup("prevention")(report).filter((group) => group !== "all"),
    rows: (report, _, group) => report.prevention.filter((row) => row.group === group || row.group === "all"),
    draw: (rows, frame) =>
      bars(rows, "value", "prevented",
        ["value", "scenarios", "idle_cost_ns", "oracle_cost_ns", "prevented"], frame),
  },
  {
    id: "transfer",
    title: "Regret when judged by another brawn, N s",
    about: "Fitted for the brawn of the line, judged by that of the column.",
    choices: (report) => valuesOf(report.transfer, "name"),
    rows: (report, _, name) => report.transfer.filter((row) => row.name === name),
    draw: (rows, frame) =>
      heat(rows, {
        x: "judged_brawn", y: "fitted_brawn", value: "regret", x_label: "judged by brawn",
        columns: ["name", "fitted_brawn", "judged_brawn", "regret", "protection"],
      }, frame),
  },
  {
    id: "ablation",
    title: "Regret with other features, N s",
    about: "Every feature set, and every set without one of its groups.",
    is_wide: true,
    rows: (report, shown) => report.ablation.filter(isShown(shown)),
    draw: (rows, frame) =>
      heat(rows, {
        x: "name", y: "features", value: "regret",
        columns: ["name", "features", "feature_count", "regret", "cross_validated_regret", "protection"],
      }, frame),
  },
];

// SPDX-License-Identifier: MIT
// The page of `flinch train-realism --report`: how well realism models agree with labels.
import { element } from "../src/dom";
import type { Chart } from "./charts";
import { figureOf, onScreenChange } from "./figure";
import { lines } from "./plots";
import type { RealismReport, Row } from "./report";
import { fileName, svgFile } from "./svg_file";
import { column, table, words } from "./tables";

const kNames: Record<string, string> = { ours: "ours", paper: "the paper's" };

/** A curve for each model, and a level line for what needs no labels. */
function curveOf(value: "auc" | "agreement", level: string, levelOf: (report: RealismReport) => unknown) {
  return (report: RealismReport): Row[] => {
    const curve = report.curve.map((row): Row => ({ ...row, name: kNames[row.name] ?? row.name }));
    const sizes = [...new Set(report.curve.map((row) => row.labels))];
    return [...curve, ...sizes.map((labels): Row => ({ name: level, labels, [value]: levelOf(report) as number }))];
  };
}

const kCharts: readonly Chart<RealismReport>[] = [
  {
    id: "auc",
    title: "Which of two motions is the better one?",
    about: "Area under the ROC curve: the chance that a good motion has a higher estimate than a bad one. 0.5 is guessing; nearest: of the nearest configuration.",
    rows: curveOf("auc", "nearest", (report) => report.baseline_auc),
    draw: (rows, frame) =>
      lines({ rows, x: "labels", y: "auc" }, {
        x_label: "labels that the model is fitted to", y_label: "AUC", logarithmic_x: true,
        columns: ["name", "labels", "auc"],
      }, frame),
  },
  {
    id: "agreement",
    title: "Is it good?",
    about: "Share of motions for which label and estimate are on the same side of 0.5. Chance says of all motions what most labels say.",
    rows: curveOf("agreement", "chance", (report) => report.chance),
    draw: (rows, frame) =>
      lines({ rows, x: "labels", y: "agreement" }, {
        x_label: "labels that the model is fitted to", y_label: "agreement", logarithmic_x: true,
        columns: ["name", "labels", "agreement"],
      }, frame),
  },
];

export class RealismPage {
  private readonly names = [...Object.values(kNames), "nearest", "chance"];
  private readonly view = { names: this.names, shown: new Set(this.names) };

  constructor(private readonly report: RealismReport) {}

  show(root: HTMLElement): void {
    const { report } = this;
    document.title = `Realism of pushes: ${report.library}`;
    const figures = kCharts.map((chart) => figureOf(chart, report, this.view));
    const redraw = () => figures.forEach(({ draw }) => draw());
    root.append(
      element("header", {},
        element("h1", { textContent: document.title }),
        element("p", { textContent: this.summary() }),
        ...(report.is_proxy ? [element("p", { id: "proxy", textContent: kProxyNotice })] : [])),
      element("section", {}, element("h2", { textContent: "Fitted to all labels but those of one sitting" }),
        table("Agreement with labels that were held out", [
          words("model", "model"), column("agreement", "agreement", 3), column("AUC", "auc", 3),
        ], this.rows())),
      element("section", { className: "charts" }, ...figures.map(({ figure }) => figure)),
    );
    redraw();
    onScreenChange(root, redraw);
  }

  /** Every chart as an SVG file: name and text. */
  files(): { name: string; text: string }[] {
    return kCharts.map((chart) => ({ name: fileName(chart, ""), text: svgFile(this.report, chart, this.view, "") }));
  }

  private rows(): Row[] {
    const { report } = this;
    return [
      ...report.rows.map((row): Row => ({ ...row, model: `${kNames[row.name] ?? row.name}${row.name === report.realism ? ", in the selector" : ""}` })),
      { model: "nearest configuration", agreement: null, auc: report.baseline_auc },
      { model: "chance", agreement: report.chance, auc: 0.5 },
    ];
  }

  private summary(): string {
    const { judge, labels, good, sittings, library, library_hash, version } = this.report;
    return `${labels} labels in ${sittings} sittings, ${good} of them good, judged by ${judge}. ` +
      `Each sitting's labels are estimated from those of the others. Library ${library} (${library_hash}), Flinch ${version}.`;
  }
}

const kProxyNotice =
  "These labels are of a proxy that measures bounds, not of people. The figures say how well its judgement can be " +
  "told beforehand; they prove nothing about how real the motions look.";

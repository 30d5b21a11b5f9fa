// SPDX-License-Identifier: MIT
// The page of a report of `flinch compare`: tables, charts of the selectors that a reader picks, and what made it.
import { element } from "../src/dom";
import { kCharts, type Chart } from "./charts";
import { figureOf, frameOf, onScreenChange } from "./figure";
import { colourOf, type Frame } from "./look";
import { originOf } from "./origin";
import { RealismPage } from "./realism";
import { embeddedReport, type Report } from "./report";
import { fileName, svgFile } from "./svg_file";
import { lookAheadTable, methodsTable, selectorsTable } from "./tables";
import "../src/colours.css";
import "./report.css";

class Page {
  readonly names: string[]; // of all selectors
  readonly shown: Set<string>;
  private readonly redraws: (() => void)[] = [];

  constructor(private readonly report: Report) {
    this.names = report.rows.map(({ name }) => name).filter((name) => name !== "oracle");
    // Methods first: they get the colours that differ most.
    const methods = new Set(report.methods.map(({ name }) => name));
    this.names.sort((a, b) => Number(methods.has(b)) - Number(methods.has(a)));
    this.shown = new Set(this.names);
  }

  show(root: HTMLElement): void {
    const { report } = this;
    document.title = `Selectors of ${report.library}, compared`;
    const charts = kCharts.filter((chart) => chart.rows(report, this.shown, this.firstChoice(chart)).length > 0);
    root.append(
      element("header", {},
        element("h1", { textContent: document.title }),
        element("p", { textContent: this.summary() })),
      element("section", {}, element("h2", { textContent: "All selectors" }), selectorsTable(report)),
      this.legend(),
      element("section", { className: "charts" }, ...charts.map((chart) => this.figure(chart))),
      ...(report.look_ahead.length
        ? [element("section", {}, element("h2", { textContent: "Looking ahead" }), lookAheadTable(report))]
        : []),
      element("section", {}, element("h2", { textContent: "Time and size" }), methodsTable(report)),
      element("section", {}, element("h2", { textContent: "How this was made" }), originOf(report)),
    );
    this.redraw();
    onScreenChange(root, () => this.redraw());
  }

  /** Every chart as an SVG file: name and text. */
  files(): { name: string; text: string }[] {
    return kCharts.flatMap((chart) => {
      const choices = chart.choices?.(this.report) ?? [""];
      return choices
        .filter((choice) => chart.rows(this.report, this.shown, choice).length > 0)
        .map((choice) => ({ name: fileName(chart, choice), text: svgFile(this.report, chart, this, choice) }));
    });
  }

  private redraw(): void {
    for (const one of this.redraws) one();
  }

  private firstChoice(chart: Chart): string {
    return chart.choices?.(this.report)[0] ?? "";
  }

  private frame(width: number): Frame {
    return frameOf(this.names, this.shown, width);
  }

  private summary(): string {
    const { scenarios_fitted, scenarios_tested, test_store, cost_model, features } = this.report;
    return `Fitted to ${scenarios_fitted} scenarios, tested on ${scenarios_tested}${test_store ? " of another store" : " held out"}. ` +
      `Brawn ${cost_model.brawn}, ${features.length} features. Intervals are 95 % bootstrap intervals over the test scenarios.`;
  }

  /** What each selector looks like, and which are shown. */
  private legend(): HTMLElement {
    const boxes = this.names.map((name) => {
      const box = element("input", { type: "checkbox", checked: true });
      box.onchange = () => {
        if (box.checked) this.shown.add(name);
        else this.shown.delete(name);
        this.redraw();
      };
      this.redraws.push(() => box.style.setProperty("accent-color", colourOf(this.frame(1), name)));
      return element("label", {}, box, name);
    });
    return element("fieldset", { id: "selectors" }, element("legend", { textContent: "Show in charts" }), ...boxes);
  }

  private figure(chart: Chart): HTMLElement {
    const { figure, draw } = figureOf(chart, this.report, this);
    this.redraws.push(draw);
    return figure;
  }
}

const root = document.querySelector("main")!;
try {
  const report = embeddedReport();
  const page = "kind" in report ? new RealismPage(report) : new Page(report);
  page.show(root);
  // For scripts/charts, the tests in a browser, and the curious.
  Object.assign(window, { flinchReport: page });
} catch (error) {
  root.append(element("p", { textContent: error instanceof Error ? error.message : String(error) }));
}

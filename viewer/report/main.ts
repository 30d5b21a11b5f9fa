// SPDX-License-Identifier: MIT
// The page of a report: tables, charts of the selectors that a reader picks, and what made it.
import { element } from "../src/dom";
import { kCharts, type Chart } from "./charts";
import { colourOf, kDark, kLight, type Frame } from "./look";
import { originOf } from "./origin";
import { embeddedReport, type Report } from "./report";
import { download, svgFile } from "./svg_file";
import { lookAheadTable, methodsTable, plainTable, selectorsTable } from "./tables";
import "../src/colours.css";
import "./report.css";

const kMinWidth = 260; // px, of a chart
const kMaxWidth = 1000;
const dark = matchMedia("(prefers-color-scheme: dark)");

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
    dark.addEventListener("change", () => this.redraw());
    let width = root.clientWidth;
    new ResizeObserver(() => {
      if (root.clientWidth === width) return;
      width = root.clientWidth;
      this.redraw();
    }).observe(root);
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
    const { names, shown } = this;
    return { names, shown, width: Math.min(width, kMaxWidth), theme: dark.matches ? kDark : kLight };
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
    const { report, shown } = this;
    let choice = this.firstChoice(chart);
    const place = element("div", { className: "drawing", tabIndex: 0 });
    place.role = "img";
    place.ariaLabel = `${chart.title}. ${chart.about} Its numbers stand below.`;
    const numbers = element("details", {}, element("summary", { textContent: "Numbers" }));
    const draw = () => {
      const rows = chart.rows(report, shown, choice);
      const width = Math.max(place.clientWidth, kMinWidth);
      if (rows.length === 0) place.replaceChildren(element("p", { className: "quiet", textContent: "No selector is picked." }));
      else place.replaceChildren(chart.draw(rows, this.frame(width), choice, report));
      fill();
    };
    const fill = () => {
      numbers.querySelector(".scroller")?.remove();
      if (numbers.open) numbers.append(plainTable(chart.title, chart.rows(report, shown, choice)));
    };
    numbers.ontoggle = fill;
    const save = element("button", {
      type: "button", textContent: "Save SVG",
      onclick: () => download(fileName(chart, choice), svgFile(report, chart, this, choice)),
    });
    const tools = element("div", { className: "tools" }, save);
    const choices = chart.choices?.(report) ?? [];
    if (choices.length > 1) {
      const pick = element("select", {}, ...choices.map((one) => element("option", { value: one, textContent: one.replaceAll("_", " ") })));
      pick.ariaLabel = `${chart.title}: what is shown`;
      pick.onchange = () => {
        choice = pick.value;
        draw();
      };
      tools.prepend(pick);
    }
    this.redraws.push(draw);
    return element("figure", { id: chart.id, className: chart.is_wide ? "wide" : "" },
      element("figcaption", {},
        element("div", {}, element("h2", { textContent: chart.title }), tools),
        element("p", { textContent: chart.about })),
      place, numbers);
  }
}

function fileName(chart: Chart, choice: string): string {
  return `${choice ? `${chart.id}_${choice}` : chart.id}.svg`;
}

const root = document.querySelector("main")!;
try {
  const page = new Page(embeddedReport());
  page.show(root);
  // For scripts/charts, the tests in a browser, and the curious.
  Object.assign(window, { flinchReport: page });
} catch (error) {
  root.append(element("p", { textContent: error instanceof Error ? error.message : String(error) }));
}

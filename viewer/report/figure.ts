// SPDX-License-Identifier: MIT
// A chart on the page: its drawing, its numbers, what a reader may pick, and its file.
import { element } from "../src/dom";
import type { Chart } from "./charts";
import { kDark, kLight, type Frame } from "./look";
import type { Source } from "./report";
import { download, fileName, svgFile } from "./svg_file";
import { plainTable } from "./tables";

const kMinWidth = 260; // px, of a chart
const kMaxWidth = 1000;
const dark = matchMedia("(prefers-color-scheme: dark)");

/** What charts that are `width` px wide are drawn with now. */
export function frameOf(names: readonly string[], shown: ReadonlySet<string>, width: number): Frame {
  return { names, shown, width: Math.min(width, kMaxWidth), theme: dark.matches ? kDark : kLight };
}

/** Calls `redraw` when the page gets another width or other colours. */
export function onScreenChange(root: HTMLElement, redraw: () => void): void {
  dark.addEventListener("change", redraw);
  let width = root.clientWidth;
  new ResizeObserver(() => {
    if (root.clientWidth === width) return;
    width = root.clientWidth;
    redraw();
  }).observe(root);
}

/** A figure that is empty until `draw` is called, which draws what is shown then. */
export function figureOf<R extends Source>(
  chart: Chart<R>, report: R, { names, shown }: Pick<Frame, "names" | "shown">,
): { figure: HTMLElement; draw: () => void } {
  const choices = chart.choices?.(report) ?? [];
  let choice = choices[0] ?? "";
  const place = element("div", { className: "drawing", tabIndex: 0 });
  place.role = "img";
  place.ariaLabel = `${chart.title}. ${chart.about} Its numbers stand below.`;
  const numbers = element("details", {}, element("summary", { textContent: "Numbers" }));
  const draw = () => {
    const rows = chart.rows(report, shown, choice);
    const frame = frameOf(names, shown, Math.max(place.clientWidth, kMinWidth));
    if (rows.length === 0) place.replaceChildren(element("p", { className: "quiet", textContent: "No selector is picked." }));
    else place.replaceChildren(chart.draw(rows, frame, choice, report));
    fill();
  };
  const fill = () => {
    numbers.querySelector(".scroller")?.remove();
    if (numbers.open) numbers.append(plainTable(chart.title, chart.rows(report, shown, choice)));
  };
  numbers.ontoggle = fill;
  const save = element("button", {
    type: "button", textContent: "Save SVG",
    onclick: () => download(fileName(chart, choice), svgFile(report, chart, { names, shown }, choice)),
  });
  const tools = element("div", { className: "tools" }, save);
  if (choices.length > 1) {
    const pick = element("select", {}, ...choices.map((one) => element("option", { value: one, textContent: one.replaceAll("_", " ") })));
    pick.ariaLabel = `${chart.title}: what is shown`;
    pick.onchange = () => {
      choice = pick.value;
      draw();
    };
    tools.prepend(pick);
  }
  const figure = element("figure", { id: chart.id, className: chart.is_wide ? "wide" : "" },
    element("figcaption", {},
      element("div", {}, element("h2", { textContent: chart.title }), tools),
      element("p", { textContent: chart.about })),
    place, numbers);
  return { figure, draw };
}

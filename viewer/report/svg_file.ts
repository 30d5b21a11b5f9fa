// SPDX-License-Identifier: MIT
// Charts as files of their own, for papers: light colours, one width, no style from outside.
import type { Chart } from "./charts";
import { kLight, type Frame } from "./look";
import type { Source } from "./report";

const kWidth = 640; // px
const kStyle = ".plot text, .plot tspan { white-space: pre; }";

/** Returns the text of an SVG file, the same for the same report, selectors and choice. */
export function svgFile<R extends Source>(
  report: R, chart: Chart<R>, { names, shown }: Pick<Frame, "names" | "shown">, choice: string,
): string {
  const rows = chart.rows(report, shown, choice);
  const drawing = chart.draw(rows, { names, shown, theme: kLight, width: kWidth }, choice, report);
  const make = (tag: string, text: string) => {
    const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
    made.textContent = text;
    return made;
  };
  const title = choice ? `${chart.title}: ${choice}` : chart.title;
  drawing.prepend(
    make("title", title),
    make("desc", `${chart.about} ${report.library}, ${report.version}.`),
    make("style", kStyle),
  );
  drawing.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  return `${new XMLSerializer().serializeToString(drawing)}\n`;
}

/** The name of a chart's file. */
export function fileName<R>(chart: Chart<R>, choice: string): string {
  return `${choice ? `${chart.id}_${choice}` : chart.id}.svg`;
}

/** Hands a file to the browser's downloads. */
export function download(name: string, text: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

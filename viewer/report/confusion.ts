// SPDX-License-Identifier: MIT
// Which clip a selector chose where which was the best: a cell per pair of clips.
import * as Plot from "@observablehq/plot";
import type { Frame } from "./look";
import { drawn } from "./plots";
import { fixed, type Row } from "./report";

const kLine = 13; // px, of a clip

/** `clips` are all clips in the order of the library, of which those that occur are shown. */
export function confusionMatrix(rows: readonly Row[], clips: readonly string[], frame: Frame): SVGSVGElement {
  const { theme } = frame;
  const occur = new Set(rows.flatMap((row) => [row.label, row.chosen]));
  const domain = clips.filter((clip) => occur.has(clip));
  const room = 14 + 6 * Math.max(...domain.map((clip) => clip.length));
  const size = kLine * domain.length;
  const most = Math.max(...rows.map((row) => row.scenarios as number));
  return drawn({ ...frame, width: room + size + 60 }, {
    height: room + size + 30, marginLeft: room, marginTop: room, marginRight: 60, marginBottom: 30,
    x: { domain, axis: "top", label: null, tickRotate: -90, tickSize: 0 },
    y: { domain, label: null, tickSize: 0 },
    color: { type: "sqrt", domain: [0, most], range: [theme.card, theme.strong] },
    marks: [
      Plot.frame({ stroke: theme.grid, strokeOpacity: 1 }),
      Plot.cell(domain, { x: (clip) => clip, y: (clip) => clip, stroke: theme.grid, inset: 0.5 }),
      Plot.cell(rows as Row[], { x: "chosen", y: "label", fill: "scenarios", inset: 0.5, rx: 2 }),
      Plot.text([`lines: the best clip; columns: the chosen one; strongest: ${most} scenarios`], {
        frameAnchor: "bottom-left", dy: 20, fill: theme.quiet, textAnchor: "start",
      }),
      Plot.tip(rows as Row[], Plot.pointer({
        x: "chosen", y: "label", fill: theme.card, stroke: theme.quiet,
        title: (row: Row) =>
          `best ${row.label}\nchosen ${row.chosen}\n${row.scenarios} scenarios\nmean regret ${fixed(row.mean_regret, 3)} N s`,
      })),
    ],
  });
}

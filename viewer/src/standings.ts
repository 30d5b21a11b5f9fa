// SPDX-License-Identifier: MIT
// The tournament's chart: protection of each chooser with its interval.
import { element, svg } from "./dom";
import type { Standing } from "./tournament";

const kWidths = { narrow: 340, wide: 640 }; // units of the chart; its text has 12
const kNarrow = 480; // px
const kName = 80;
const kRow = 38;

export function drawStandings(root: HTMLElement, standings: readonly Standing[], thrown: number): void {
  const width = root.clientWidth < kNarrow ? kWidths.narrow : kWidths.wide;
  const height = kRow * standings.length + 34;
  const x = (share: number) => kName + Math.min(Math.max(share, -0.15), 1.05) * (width - kName - 60);
  const chart = svg("svg", {
    class: "chart", viewBox: `0 0 ${width} ${height}`, role: "img",
    "aria-label": standings.map(({ name, protection }) => `${name} ${percent(protection)}`).join(", "),
  });
  for (const share of [0, 0.25, 0.5, 0.75, 1]) {
    chart.append(
      svg("line", { class: "axis", x1: x(share), x2: x(share), y1: 4, y2: height - 26 }),
      svg("text", { class: "quiet", x: x(share), y: height - 8, "text-anchor": "middle" }, percent(share)),
    );
  }
  [...standings]
    .sort((a, b) => b.protection - a.protection)
    .forEach(({ name, protection, low, high }, i) => {
      const y = 4 + i * kRow + kRow / 2;
      const length = Math.max(x(protection) - x(0), 0);
      chart.append(
        svg("text", { x: 0, y: y + 4 }, name),
        svg("rect", { class: "bar", x: x(0), y: y - 9, width: length, height: 18, rx: 3 }),
        svg("line", { class: "interval", x1: x(low), x2: x(high), y1: y, y2: y }),
        svg("text", { x: width, y: y + 4, "text-anchor": "end" }, percent(protection)),
      );
    });
  root.replaceChildren(
    chart,
    element("p", {
      className: "legend",
      textContent: `${thrown} throws. 0 % is standing still, 100 % the oracle; the line is the 95 % interval.`,
    }),
  );
}

function percent(share: number): string {
  return `${Math.round(100 * share)} %`;
}

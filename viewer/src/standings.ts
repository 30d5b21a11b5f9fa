// SPDX-License-Identifier: MIT
// The tournament's chart: protection of each chooser with its interval.
import { element, svg } from "./dom";
import type { Standing } from "./tournament";

const kWidths = { narrow: 340, wide: 640 }; // units of the chart; its text has 12
const kNarrow = 480; // px
const kName = 80;
const kRow = 38;
const kRoom = 60; // right of the scale, for the number

/** Where shares stand, from the least of them, or -1 if that is less, to 1; quarters have lines. */
export function scaleOf(standings: readonly Standing[], width: number) {
  const lowest = Math.min(0, ...standings.flatMap(({ protection, low }) => [protection, low]));
  const from = Math.max(-1, Math.floor(4 * lowest) / 4);
  const x = (share: number) => {
    const shown = Math.min(Math.max(share, from), 1.05);
    return kName + ((shown - from) / (1.05 - from)) * (width - kName - kRoom);
  };
  const step = from < -0.5 ? 0.5 : 0.25;
  const ticks = Array.from({ length: Math.round((1 - from) / step) + 1 }, (_, i) => 1 - i * step);
  return { x, ticks: ticks.filter((tick) => tick >= from) };
}

/** The bar from 0 to a share: to the left where that is less. */
export function barOf(protection: number, x: (share: number) => number) {
  const ends = [x(0), x(protection)];
  return { x: Math.min(...ends), width: Math.abs(ends[1]! - ends[0]!) };
}

export function drawStandings(root: HTMLElement, standings: readonly Standing[], thrown: number): void {
  const width = root.clientWidth < kNarrow ? kWidths.narrow : kWidths.wide;
  const height = kRow * standings.length + 34;
  const { x, ticks } = scaleOf(standings, width);
  const chart = svg("svg", {
    class: "chart", viewBox: `0 0 ${width} ${height}`, role: "img",
    "aria-label": standings.map(({ name, protection }) => `${name} ${percent(protection)}`).join(", "),
  });
  for (const share of ticks) {
    chart.append(
      svg("line", { class: "axis", x1: x(share), x2: x(share), y1: 4, y2: height - 26 }),
      svg("text", { class: "quiet", x: x(share), y: height - 8, "text-anchor": "middle" }, percent(share)),
    );
  }
  [...standings]
    .sort((a, b) => b.protection - a.protection)
    .forEach(({ name, protection, low, high }, i) => {
      const y = 4 + i * kRow + kRow / 2;
      chart.append(
        svg("text", { x: 0, y: y + 4 }, name),
        svg("rect", { class: "bar", ...barOf(protection, x), y: y - 9, height: 18, rx: 3 }),
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

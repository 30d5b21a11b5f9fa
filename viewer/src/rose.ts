// SPDX-License-Identifier: MIT
// The threat rose: how a chooser answers throws from all around, at all heights.
import { element, svg } from "./dom";
import { kHeights, kSectors, type Petal, type Ring } from "./petals";
import type { Throw } from "./throw";

const kInner = 46;
const kRing = 27;
const kColours = [
  "#4878d0", "#ee854a", "#6acc64", "#d65f5f", "#956cb4", "#8c613c", "#dc7ec0", "#82c6e2",
];

export type RoseColours = "kind" | "protection";

/** Draws as many rings as are known, from the inside out; a click on a petal throws it. */
export function drawRose(
  root: HTMLElement,
  name: string,
  rings: readonly Ring[],
  colours: RoseColours,
  thrown: (one: Throw) => void,
): void {
  const kinds = [...new Set(rings.flat().map(({ kind }) => kind))].sort();
  const size = 2 * (kInner + kRing * kHeights.length + 34);
  const chart = svg("svg", {
    class: "chart", viewBox: `${-size / 2} ${-size / 2} ${size} ${size}`, role: "group",
    "aria-label": `How ${name} answers throws from all around`,
  });
  const colourOf = ({ kind, prevented }: Petal) =>
    colours === "kind"
      ? kColours[kinds.indexOf(kind) % kColours.length]!
      : `hsl(${Math.round(150 * Math.min(Math.max(prevented, 0), 1))} 55% 48%)`;
  rings.forEach((ring, h) =>
    ring.forEach((petal, sector) => {
      const text = `${Math.round(petal.thrown.azimuth)}°, ${kHeights[h]} m: ${petal.clip} (${petal.kind}), prevents ${Math.round(100 * petal.prevented)} %`;
      const cell = svg("path", {
        class: "cell", d: sectorPath(sector, h), fill: colourOf(petal), tabindex: 0,
        role: "button", "aria-label": text,
      }, svg("title", {}, text));
      const act = () => thrown(petal.thrown);
      cell.addEventListener("click", act);
      cell.addEventListener("keydown", (event) => {
        if ((event as KeyboardEvent).key === "Enter") act();
      });
      chart.append(cell);
    }),
  );
  const edge = size / 2 - 15;
  for (const [text, x, y] of [
    ["front", 0, -edge + 6], ["back", 0, edge + 2], ["left", -edge, 4], ["right", edge, 4],
  ] as const)
    chart.append(svg("text", { x, y, class: "quiet", "text-anchor": "middle" }, text));
  chart.append(
    svg("text", { x: 0, y: -2, "text-anchor": "middle" }, "legs inside"),
    svg("text", { x: 0, y: 13, "text-anchor": "middle" }, "head outside"),
  );
  root.replaceChildren(chart, legendOf(colours, kinds));
}

/** Front is up, the character's left at the left. */
function sectorPath(sector: number, ring: number): string {
  const width = (2 * Math.PI) / kSectors;
  const [from, to] = [(sector - 0.5) * width, (sector + 0.5) * width];
  const [near, far] = [kInner + ring * kRing, kInner + (ring + 1) * kRing];
  const at = (angle: number, radius: number) =>
    `${(-Math.sin(angle) * radius).toFixed(2)} ${(-Math.cos(angle) * radius).toFixed(2)}`;
  return `M${at(from, near)} L${at(from, far)} A${far} ${far} 0 0 0 ${at(to, far)} L${at(to, near)} A${near} ${near} 0 0 1 ${at(from, near)} Z`;
}

function legendOf(colours: RoseColours, kinds: string[]): HTMLElement {
  const entry = (colour: string, text: string) => {
    const mark = svg("svg", { viewBox: "0 0 10 10", "aria-hidden": "true" });
    mark.append(svg("rect", { width: 10, height: 10, rx: 2, fill: colour }));
    return element("span", {}, mark, text);
  };
  const entries =
    colours === "kind"
      ? kinds.map((kind, i) => entry(kColours[i % kColours.length]!, kind))
      : [0, 0.5, 1].map((share) =>
          entry(`hsl(${150 * share} 55% 48%)`, `prevents ${100 * share} %`),
        );
  return element("p", { className: "legend" }, ...entries);
}

// SPDX-License-Identifier: MIT
// Maps of the directions that threats come from, seen from above: the front is at the top, the
// character's left at the left; the rings are targets, the legs inside.
import * as Plot from "@observablehq/plot";
import type { Frame } from "./look";
import { drawn } from "./plots";
import { fixed, valuesOf, type Row } from "./report";

const kTargets = ["legs", "pelvis", "trunk", "head"]; // from the inside out
const kInner = 0.16; // radius of the hole; the outermost ring ends at 1
const kSides = [
  { text: "front", x: 0, y: 1.12 },
  { text: "back", x: 0, y: -1.12 },
  { text: "left", x: -1.18, y: 0 },
  { text: "right", x: 1.2, y: 0 },
];

export interface PolarOptions {
  value: string; // the column that colours show
  label: string;
  most?: number; // the value of the strongest colour; the largest one unless given
}

function radius(target: unknown, share: number): number {
  return kInner + ((1 - kInner) * (kTargets.indexOf(String(target)) + share)) / kTargets.length;
}

function point(azimuth_degrees: number, r: number): { x: number; y: number } {
  const angle = (azimuth_degrees * Math.PI) / 180;
  return { x: -r * Math.sin(angle), y: r * Math.cos(angle) };
}

/** The corners of a sector of a ring, with its arcs in steps of 3 degrees. */
function corners(row: Row, sector_deg: number): { x: number; y: number }[] {
  const from = (row.azimuth_degrees as number) - sector_deg / 2;
  const angles = Array.from({ length: sector_deg / 3 + 1 }, (_, i) => from + 3 * i);
  const outer = angles.map((angle) => point(angle, radius(row.target, 1)));
  const inner = angles.map((angle) => point(angle, radius(row.target, 0)));
  return [...outer, ...inner.reverse()];
}

/** One map per selector. */
export function polarMaps(rows: readonly Row[], options: PolarOptions, frame: Frame): SVGSVGElement {
  const { theme } = frame;
  const names = valuesOf(rows, "name");
  const columns = Math.max(1, Math.min(names.length, Math.floor(frame.width / 165)));
  const facet = (name: string) => {
    const at = names.indexOf(name);
    return { column: at % columns, line: Math.floor(at / columns) };
  };
  const sector_deg = 360 / new Set(rows.map((row) => row.azimuth_degrees)).size;
  const known = rows.filter((row) => row[options.value] !== null);
  const most = options.most ?? Math.max(...known.map((row) => row[options.value] as number), 1e-9);
  const linear = (row: Row) => Math.min(Math.max((row[options.value] as number) / most, 0), 1);
  const share = (row: Row) => (options.most ? linear(row) : Math.sqrt(linear(row))); // the small is seen too
  const outlines = known.flatMap((row, cell) =>
    corners(row, sector_deg).map((corner) => ({ ...facet(String(row.name)), ...corner, cell, share: share(row) })),
  );
  const middles = known.map((row) => ({
    ...row, ...facet(String(row.name)), ...point(row.azimuth_degrees as number, radius(row.target, 0.5)),
  }));
  const titles = names.map((name) => ({ name, ...facet(name) }));
  const sides = titles.flatMap((title) => kSides.map((side) => ({ ...title, ...side })));
  const place = { fx: "column", fy: "line", x: "x", y: "y" } as const;
  return drawn(frame, {
    aspectRatio: 1, margin: 6, marginBottom: 24,
    x: { domain: [-1.4, 1.4], axis: null },
    y: { domain: [-1.2, 1.45], axis: null },
    fx: { axis: null, padding: 0.02 },
    fy: { axis: null, padding: 0.02 },
    color: { type: "linear", domain: [0, 1], range: [theme.card, theme.strong] },
    marks: [
      Plot.line(outlines, {
        ...place, z: "cell", fill: "share", stroke: theme.grid, strokeWidth: 0.75, curve: "linear-closed",
      }),
      Plot.text(titles, { ...place, x: 0, y: 1.36, text: "name", fontWeight: 600, fontSize: 12 } as never),
      Plot.text(sides, { ...place, text: "text", fill: theme.quiet, fontSize: 9 } as never),
      Plot.text([`lightest: 0 or less, strongest: ${fixed(most, 2)} or more`], {
        frameAnchor: "bottom", facet: "super", fill: theme.quiet, dy: 16,
      } as never),
      Plot.tip(middles, Plot.pointer({
        ...place, fill: theme.card, stroke: theme.quiet,
        title: (row: Row) =>
          `${row.name}\n${row.target}, ${row.azimuth_degrees}°\n${options.label} ${fixed(row[options.value], 3)}\n${row.scenarios} scenarios`,
      } as never)),
    ],
  });
}

// SPDX-License-Identifier: MIT
// Names beside lines, where they cover as little as possible.
import * as Plot from "@observablehq/plot";
import type { Row } from "./report";
import { colourOf, type Frame } from "./look";

const kHeight = 13; // px, of a name
const kLetter = 7.5;
const kGap = 8;

export interface Lines {
  rows: readonly Row[];
  x: string;
  y: string;
}

type Scales = { x: (value: never) => number; y: (value: never) => number };
type Size = { width: number; height: number; marginTop: number; marginBottom: number };

/** The names of lines, each beside its last point. */
export function names({ rows, x, y }: Lines, frame: Frame): Plot.Markish {
  const last = new Map(rows.map((row) => [row.name as string, row]));
  const ends = [...last.values()].filter((row) => row[y] !== null);
  const together = ends.every((row) => row[x] === ends[0]![x]);
  const options = {
    x, y, text: "name", textAnchor: "start", fontSize: 11, fontWeight: 600,
    fill: (row: Row) => colourOf(frame, row.name as string),
    stroke: frame.theme.card, strokeWidth: 3,
  } as const;
  const place = (data: Row[], facets: number[][], _: unknown, all: unknown, size: Size) => {
    const scales = all as Scales;
    const at = (row: Row) => ({ x: scales.x(row[x] as never), y: scales.y(row[y] as never) });
    const points = data.map(at);
    const found = together
      ? stacked(points, size.marginTop, size.height - size.marginBottom)
      : besideEnds(data.map((row) => String(row.name)), points, linesOf(rows, at), size);
    return {
      data, facets,
      channels: {
        x: { value: found.map((point) => point.x) },
        y: { value: found.map((point) => point.y) },
      },
    };
  };
  return Plot.text(ends, Plot.initializer(options as never, place as never) as Plot.TextOptions);
}

interface Point {
  x: number;
  y: number;
}

/** Names at the right of points below each other, moved apart where they would overlap. */
function stacked(points: readonly Point[], top: number, bottom: number): Point[] {
  const order = points.map((_, i) => i).sort((a, b) => points[a]!.y - points[b]!.y);
  const y = points.map((point) => point.y);
  let least = top;
  for (const i of order) {
    y[i] = Math.max(y[i]!, least);
    least = y[i]! + kHeight;
  }
  let most = bottom;
  for (const i of order.reverse()) {
    y[i] = Math.min(y[i]!, most);
    most = y[i]! - kHeight;
  }
  return points.map((point, i) => ({ x: point.x + kGap, y: y[i]! }));
}

interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

function overlap(a: Box, b: Box): number {
  const width = Math.min(a.right, b.right) - Math.max(a.left, b.left);
  const height = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
  return Math.max(width, 0) * Math.max(height, 0);
}

function around({ x, y }: Point, half: number): Box {
  return { left: x - half, top: y - half, right: x + half, bottom: y + half };
}

/** Boxes over the points and, in small steps, over the lines between them. */
function linesOf(rows: readonly Row[], at: (row: Row) => Point): Box[] {
  const boxes: Box[] = [];
  const last = new Map<unknown, Point>();
  for (const row of rows) {
    const to = at(row);
    boxes.push(around(to, 5));
    const from = last.get(row.name);
    const steps = from ? Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / 4) : 0;
    for (let step = 1; step < steps; ++step) {
      const share = step / steps;
      boxes.push(around({ x: from!.x + share * (to.x - from!.x), y: from!.y + share * (to.y - from!.y) }, 2));
    }
    last.set(row.name, to);
  }
  return boxes;
}

/** Each name at the free place nearest to its point, or where it covers least. */
function besideEnds(texts: readonly string[], points: readonly Point[], lines: Box[], size: Size): Point[] {
  const taken = [...lines];
  const far = 10000;
  const outside: Box[] = [
    { left: -far, right: far, top: -far, bottom: 4 },
    { left: size.width, right: far, top: 0, bottom: far },
    { left: -far, right: far, top: size.height - size.marginBottom - 2, bottom: far },
  ];
  const covers = (box: Box, others: Box[]) => others.reduce((sum, other) => sum + overlap(box, other), 0);
  return texts.map((text, i) => {
    const { x, y } = points[i]!;
    const width = kLetter * text.length;
    const boxes: Box[] = [];
    for (const down of [0, -1, 1, -2, 2, -3, 3]) {
      const top = y + (down - 0.5) * kHeight;
      const lefts = [x + kGap, x - kGap - width, ...(down ? [x - width / 2] : [])];
      for (const left of lefts) boxes.push({ left, right: left + width, top, bottom: top + kHeight });
    }
    const covered = boxes.map((box) => covers(box, taken) + 100 * covers(box, outside));
    const best = boxes[covered.indexOf(Math.min(...covered))]!;
    taken.push(best);
    return { x: best.left, y: best.top + kHeight / 2 };
  });
}

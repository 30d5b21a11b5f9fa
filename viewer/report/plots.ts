// SPDX-License-Identifier: MIT
// The kinds of charts, drawn by Observable Plot: an SVG each for rows of numbers.
import * as Plot from "@observablehq/plot";
import { names, type Lines } from "./labels";
import { scalesOf, type Frame } from "./look";
import { fixed, valuesOf, type Interval, type Row } from "./report";

export type Drawing = SVGSVGElement;

const kNarrow = 480; // px
const kPlainAxis = { tickSize: 0, labelArrow: "none" } as const;
const kTicksTowardsOne = [-9, -4, -1, 0, 0.5, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 0.998, 0.999];

/** Draws in the theme's colours. The security policy forbids style elements made by scripts, so the
 * style that Plot adds is that of report.css; SVG files get it back (svg_file.ts). */
export function drawn(frame: Frame, options: Plot.PlotOptions): Drawing {
  const { theme, width } = frame;
  const plot = Plot.plot({
    className: "plot", width, ...options,
    style: { color: theme.ink, background: theme.card, fontSize: "11px" },
  }) as Drawing;
  plot.querySelectorAll("style").forEach((style) => style.remove());
  return plot;
}

function textOf(row: Row, columns: readonly string[]): string {
  const value = (column: string) => {
    const found = row[column];
    return typeof found === "number" ? `${column.replaceAll("_", " ")} ${fixed(found, 3)}` : String(found);
  };
  return columns.filter((column) => row[column] !== undefined).map(value).join("\n");
}

function tip(rows: readonly Row[], columns: readonly string[], frame: Frame, place: object): Plot.Markish {
  return Plot.tip(rows as Row[], Plot.pointer({
    ...place, title: (row: Row) => textOf(row, columns), fill: frame.theme.card, stroke: frame.theme.quiet,
  }));
}

/** A dot with its interval per row, one below the other. */
export function intervals(rows: readonly Row[], value: string, label: string, frame: Frame): Drawing {
  const end = (i: 0 | 1) => (row: Row) => (row[`${value}_ci`] as Interval)[i];
  const order = rows.map((row) => row.name);
  const ticks = Math.min(8, frame.width / 90);
  return drawn(frame, {
    ...scalesOf(frame), height: 26 * rows.length + 56, marginLeft: 128, marginRight: 46, marginTop: 6,
    marginBottom: 40,
    x: { label, labelAnchor: "center", ...kPlainAxis, zero: true, ticks },
    y: { domain: order, label: null, tickSize: 0 },
    marks: [
      Plot.gridX({ stroke: frame.theme.grid, strokeOpacity: 1, ticks }),
      Plot.ruleX([0], { stroke: frame.theme.quiet }),
      Plot.ruleY(rows as Row[], { y: "name", x1: end(0), x2: end(1), stroke: "name", strokeWidth: 2 }),
      Plot.dot(rows as Row[], { x: value, y: "name", fill: "name", symbol: "name", r: 5 }),
      Plot.text(rows as Row[], { x: end(1), y: "name", text: (row: Row) => fixed(row[value], 3), dx: 8, textAnchor: "start" }),
      tip(rows, ["name", value], frame, { x: value, y: "name" }),
    ],
  });
}

export interface LineOptions {
  x_label: string;
  y_label: string;
  logarithmic_x?: boolean;
  towards_one?: boolean; // the distance of y from 1 is on a logarithmic scale, if all y are below 1
  diagonal?: boolean;
  columns: readonly string[]; // of the tip
}

/** A line per name. */
export function lines({ rows: all, x, y }: Lines, options: LineOptions, frame: Frame): Drawing {
  const rows = all.filter((row) => row[x] !== null && row[y] !== null);
  const ys = rows.map((row) => row[y] as number);
  const xs = rows.map((row) => row[x] as number);
  const towards_one = options.towards_one === true && ys.every((value) => value < 1);
  const height_of = (value: number) => (towards_one ? 1 - value : value);
  const place = { x, y: (row: Row) => height_of(row[y] as number) };
  const sizes = [...new Set(xs)];
  const few = options.logarithmic_x === true && sizes.length <= 8;
  const narrow = frame.width < kNarrow;
  const together = new Set([...new Map(rows.map((row) => [row.name, row[x]])).values()]).size === 1;
  const ends = [Math.min(...xs), Math.max(...xs)] as const;
  const bounds = [Math.min(...ys), Math.max(...ys)] as const;
  const placed = rows.map((row) => ({ ...row, height: height_of(row[y] as number) }));
  const y_ticks = towards_one
    ? { ticks: kTicksTowardsOne.filter((tick) => tick >= bounds[0] - 0.15 * (1 - bounds[0]) && tick <= bounds[1]).map(height_of), tickFormat: (d: number) => String(Number((1 - d).toPrecision(6))) }
    : {};
  const x_ticks = few && !narrow ? { ticks: sizes, tickFormat: (d: number) => d.toLocaleString("en") }
    : { ticks: Math.max(3, frame.width / 100), ...(options.logarithmic_x ? { tickFormat: (d: number) => (/^[125]/.test(d.toExponential()) ? d.toLocaleString("en") : "") } : {}) };
  return drawn(frame, {
    ...scalesOf(frame), height: narrow ? 280 : 330, marginLeft: 52, marginBottom: 42, marginTop: 24,
    marginRight: together ? 130 : 30,
    insetTop: 6,
    x: { type: options.logarithmic_x ? "log" : "linear" },
    y: { type: towards_one ? "log" : "linear", reverse: towards_one, nice: !towards_one },
    marks: [
      Plot.axisX({ ...x_ticks, ...kPlainAxis, label: options.x_label, labelAnchor: "center" }),
      Plot.axisY({ ...y_ticks, ...kPlainAxis, label: options.y_label }),
      Plot.gridX({ ticks: x_ticks.ticks, stroke: frame.theme.grid, strokeOpacity: 1 }),
      Plot.gridY({ ...(y_ticks.ticks ? { ticks: y_ticks.ticks } : {}), stroke: frame.theme.grid, strokeOpacity: 1 }),
      options.diagonal ? Plot.line([[ends[0], ends[0]], [ends[1], ends[1]]], { stroke: frame.theme.quiet, strokeDasharray: "4 4" }) : null,
      Plot.line(rows as Row[], { ...place, z: "name", stroke: "name", strokeWidth: 2, strokeLinejoin: "round" }),
      Plot.dot(rows as Row[], { ...place, fill: "name", symbol: "name", r: 4 }),
      names({ rows: placed, x, y: "height" }, frame),
      tip(rows, options.columns, frame, place),
    ],
  });
}

export interface HeatOptions {
  x: string;
  y: string;
  value: string;
  x_label?: string;
  columns: readonly string[]; // of the tip
}

/** A table whose cells are the stronger the larger their number is. */
export function heat(rows: readonly Row[], options: HeatOptions, frame: Frame): Drawing {
  const { theme, width } = frame;
  const place = { x: (row: Row) => String(row[options.x]), y: (row: Row) => String(row[options.y]) };
  const columns = valuesOf(rows, options.x);
  const lines = valuesOf(rows, options.y);
  const letters = (texts: readonly string[]) => Math.max(...texts.map((text) => text.length));
  const left = 14 + 6.2 * letters(lines);
  const cell = (width - left) / columns.length;
  const slanted = cell < 6.6 * letters(columns.flatMap((text) => text.split("_")));
  const top = (slanted ? 20 + 5.4 * letters(columns) : 40) + (options.x_label ? 14 : 0);
  const most = Math.max(...rows.map((row) => Number(row[options.value])), 1e-9);
  return drawn(frame, {
    height: 28 * lines.length + top + 8, marginLeft: left, marginRight: slanted ? 30 : 4, marginTop: top,
    marginBottom: 8,
    x: {
      domain: columns, axis: "top", label: options.x_label ?? null, ...kPlainAxis,
      ...(slanted ? { tickRotate: -55 } : { tickFormat: (text: string) => text.replace("_", "\n") }),
    },
    y: { domain: lines, label: null, tickSize: 0 },
    color: { type: "linear", range: [theme.card, theme.heat], domain: [0, most] },
    marks: [
      Plot.cell(rows as Row[], { ...place, fill: options.value, inset: 1, rx: 3 }),
      cell < 32 ? null : Plot.text(rows as Row[], {
        ...place, text: (row: Row) => fixed(row[options.value], cell < 42 ? 2 : 3),
      }),
      tip(rows, options.columns, frame, place),
    ],
  });
}

/** A bar per row, from 0, with its number. */
export function bars(rows: readonly Row[], name: string, value: string, columns: readonly string[], frame: Frame): Drawing {
  const { theme } = frame;
  const place = { x: value, y: name };
  return drawn(frame, {
    height: 26 * rows.length + 16, marginLeft: 100, marginRight: 44, marginTop: 6, marginBottom: 10,
    x: { domain: [0, Math.max(...rows.map((row) => Number(row[value])), 1e-9)], axis: null },
    y: { domain: valuesOf(rows, name), label: null, tickSize: 0 },
    marks: [
      Plot.barX(rows as Row[], { ...place, fill: theme.heat, rx: 3 }),
      Plot.text(rows as Row[], { ...place, text: (row: Row) => fixed(row[value], 3), dx: 6, textAnchor: "start" }),
      tip(rows, columns, frame, place),
    ],
  });
}

/** Shares of kinds, stacked, per value of x. */
export function stackedShares(
  rows: readonly Row[],
  { x, kind, share }: { x: string; kind: string; share: string },
  frame: Frame,
): Drawing {
  const { theme } = frame;
  const kinds = valuesOf(rows, kind);
  const stack = { x, y: share, z: kind };
  const colours = kinds.map((_, i) => theme.colours[i % theme.colours.length]!);
  const title = (row: Row) => textOf(row, [kind, x, share, "mean_damage", "mean_work"]);
  return drawn(frame, {
    height: 300, marginLeft: 48, marginRight: 96, marginBottom: 42, marginTop: 24,
    color: { domain: kinds, range: colours },
    x: { type: "band", label: x, labelAnchor: "center", ...kPlainAxis },
    y: { percent: true, label: "share of choices, %", ...kPlainAxis },
    marks: [
      Plot.barY(rows as Row[], Plot.stackY({ ...stack, fill: kind, insetLeft: 1, insetRight: 1 })),
      ...kinds.map((text, i) => Plot.text([text], {
        frameAnchor: "bottom-right", dx: 12, dy: -18 * i - 8, textAnchor: "start", fontWeight: 600,
        fill: colours[i]!,
      })),
      Plot.tip(rows as Row[], Plot.pointerX(Plot.stackY(
        { ...stack, title, fill: theme.card, stroke: theme.quiet } as never) as never)),
    ],
  });
}

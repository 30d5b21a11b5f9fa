// SPDX-License-Identifier: MIT
// Tables that can be sorted by a click on a column's title.
import { element } from "../src/dom";
import { fixed, interval, type Report, type Row } from "./report";

export interface Column {
  title: string;
  text: (row: Row) => string;
  order?: (row: Row) => number; // sortable by it
}

export function column(title: string, key: string, decimals: number): Column {
  return { title, text: (row) => fixed(row[key], decimals), order: (row) => Number(row[key] ?? NaN) };
}

export function words(title: string, key: string): Column {
  return { title, text: (row) => String(row[key] ?? "") };
}

export function range(key: string, decimals: number): Column {
  return { title: "95 %", text: (row) => interval(row[key], decimals) };
}

/** A table with a caption for readers that do not see it; wide ones scroll. */
export function table(caption: string, columns: readonly Column[], rows: readonly Row[]): HTMLElement {
  const body = element("tbody");
  const heads = columns.map(({ title, order }) => {
    const cell = element("th", { scope: "col" });
    if (!order) cell.textContent = title;
    else cell.append(element("button", { type: "button", textContent: title, onclick: () => sort(cell, order) }));
    return cell;
  });
  const show = (ordered: readonly Row[]) =>
    body.replaceChildren(...ordered.map((row) =>
      element("tr", {}, ...columns.map(({ text }) => element("td", { textContent: text(row) })))));
  const sort = (cell: HTMLElement, order: (row: Row) => number) => {
    const falls = cell.ariaSort === "descending";
    for (const head of heads) head.removeAttribute("aria-sort");
    cell.ariaSort = falls ? "ascending" : "descending";
    const known = (row: Row) => (Number.isNaN(order(row)) ? Infinity : (falls ? 1 : -1) * order(row));
    show([...rows].sort((a, b) => known(a) - known(b)));
  };
  show(rows);
  const made = element("table", {},
    element("caption", { textContent: caption, className: "unseen" }),
    element("thead", {}, element("tr", {}, ...heads)), body);
  const scroller = element("div", { className: "scroller", tabIndex: 0 }, made);
  scroller.role = "region";
  scroller.ariaLabel = caption;
  return scroller;
}

/** Every column of rows as they are in report.json. */
export function plainTable(caption: string, rows: readonly Row[]): HTMLElement {
  const columns = Object.keys(rows[0] ?? {}).map((key): Column => {
    const value = rows[0]![key];
    if (Array.isArray(value)) return { title: key.replace("_ci", ", 95 %"), text: (row) => interval(row[key], 4) };
    if (rows.some((row) => typeof row[key] === "number"))
      return column(key, key, rows.every((row) => row[key] === null || Number.isInteger(row[key])) ? 0 : 4);
    return words(key, key);
  });
  return table(caption, columns, rows);
}

export function selectorsTable(report: Report): HTMLElement {
  return table("All selectors", [
    words("selector", "name"), column("accuracy", "accuracy", 3), column("top 3", "top_three", 3),
    column("cost, N s", "mean_cost", 3), column("damage, N s", "mean_damage", 3),
    column("regret, N s", "regret", 3), range("regret_ci", 3),
    column("protection", "protection", 3), range("protection_ci", 3),
  ], report.rows);
}

export function lookAheadTable(report: Report): HTMLElement {
  const of_name = new Map(report.timing.map((one) => [one.name, one]));
  const rows = report.look_ahead.map((row): Row => ({ ...row, ...of_name.get(row.name) }));
  return table("Looking ahead", [
    words("selector + candidates", "name"), column("accuracy", "accuracy", 3),
    column("cost, N s", "mean_cost", 3), column("regret, N s", "regret", 3),
    column("protection", "protection", 3), range("protection_ci", 3),
    column("simulated", "encounters", 1), column("median, µs", "median_us", 0),
    column("p99, µs", "p99_us", 0),
  ], rows);
}

/** "k 10, vote majority". */
function chosen(parameters: Record<string, string | number>): string {
  const text = (value: string | number) => typeof value === "number" ? String(+value.toPrecision(6)) : value;
  return Object.entries(parameters).map(([name, value]) => `${name} ${text(value)}`).join(", ");
}

export function methodsTable(report: Report): HTMLElement {
  const timing = new Map(report.timing.map((one) => [one.name, one]));
  const bytes = new Map(report.sizes.map((one) => [one.name, one.file_bytes]));
  const rows = report.methods.map(({ parameters, ...row }): Row => ({
    ...row, chosen: chosen(parameters), ...timing.get(row.name), kib: (bytes.get(row.name) ?? 0) / 1024,
  }));
  return table("Time and size", [
    words("selector", "name"), column("median, µs", "median_us", 1), column("p99, µs", "p99_us", 1),
    column("fit, s", "fit_s", 1), column("file, KiB", "kib", 0),
    column("cross-validated regret, N s", "cross_validated_regret", 3), words("chosen", "chosen"),
  ], rows);
}

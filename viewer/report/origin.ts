// SPDX-License-Identifier: MIT
// What made a report: program, options, stores and cost model.
import { element } from "../src/dom";
import type { Origin, Report } from "./report";

function list(entries: readonly (readonly [string, string])[]): HTMLElement {
  return element("dl", {}, ...entries.flatMap(([name, value]) => [
    element("dt", { textContent: name }), element("dd", { textContent: value }),
  ]));
}

function plain(value: unknown): string {
  if (value === null || value === undefined) return "–";
  if (Array.isArray(value)) return value.map(plain).join(", ");
  if (typeof value === "object")
    return Object.entries(value).map(([key, one]) => `${key.replaceAll("_", " ")} ${plain(one)}`).join("; ");
  return typeof value === "boolean" ? (value ? "yes" : "no") : String(value);
}

function store(name: string, origin: Origin): HTMLElement {
  return element("div", {},
    element("h3", { textContent: name }),
    list([
      ["scenarios", String(origin.scenarios)], ["seed", String(origin.seed)],
      ["distribution", plain(origin.distribution)], ["simulation", plain(origin.simulation)],
    ]));
}

export function originOf(report: Report): HTMLElement {
  const { cost_model: model } = report;
  return element("div", { className: "origin" },
    element("div", {},
      element("h3", { textContent: "Program" }),
      list([
        ["version", report.version],
        ["library", `${report.library} (${report.library_hash})`],
        ...Object.entries(report.options).map(([name, value]) => [name, plain(value)] as const),
        ["features", `${report.features.length}: ${report.features.join(", ")}`],
      ])),
    element("div", {},
      element("h3", { textContent: "Cost" }),
      list([
        ["brawn", String(model.brawn)],
        ["reference damage", `${model.reference_damage_ns.map((ns) => ns.toFixed(3)).join(", ")} N s`],
        ["reference work", `${model.reference_work_j.toFixed(1)} J`],
        [`vulnerability (${model.vulnerability_name})`, plain(model.vulnerability)],
      ])),
    store("Fitted to", report.stores.fitted),
    store(report.test_store ? "Tested on another store" : "Tested on every fourth scenario", report.stores.tested));
}

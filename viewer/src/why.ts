// SPDX-License-Identifier: MIT
// Why this clip: the candidates with what the selector expects and what a simulation finds, the
// predicted contact, and where the ball hit.
import type { Flinch, Trial } from "flinch";
import { beforeThrow, costOf, type Chooser, type Conditions } from "./chooser";
import { element } from "./dom";
import type { Take } from "./take";

interface Row {
  clip: number;
  says: string; // the selector: votes or an expected cost
  trial: Trial | null;
}

export function whyThisClip(flinch: Flinch, take: Take, conditions: Conditions): HTMLElement {
  const { chooser } = take;
  const { library } = chooser.selector;
  const { rows, target, time } = considered(chooser, conditions);
  const root = element("div", {}, element("h2", { textContent: "Why this clip" }));
  if (!take.trial) {
    root.append(element("p", { className: "quiet", textContent: "The ball will hit nothing." }));
    return root;
  }
  root.append(
    element("p", {
      className: "quiet",
      textContent: `If it goes on as it is, the threat hits the ${flinch.targets[target]} in ${time.toFixed(2)} s. Costs in N s: as the selector expects them, and simulated.`,
    }),
  );
  if (!rows.some(({ clip }) => clip === take.clip))
    rows.unshift({ clip: take.clip, says: "", trial: take.trial });
  const head = element("tr", {});
  for (const text of ["clip", "selector", "simulated", "work, J"])
    head.append(element("th", { textContent: text, scope: "col" }));
  const body = rows.map(({ clip, says, trial }) => {
    const cells = [
      library.clips[clip]!.name.replaceAll("_", " "),
      says,
      trial ? costOf(trial, chooser.selector.oracle, conditions.brawn).toFixed(2) : "",
      trial ? trial.work_j.toFixed(0) : "",
    ];
    const row = element("tr", { className: clip === take.clip ? "chosen" : "" });
    row.append(...cells.map((textContent) => element("td", { textContent })));
    return row;
  });
  root.append(element("table", {}, element("thead", {}, head), element("tbody", {}, ...body)));
  root.append(bodyMap(flinch, take.trial));
  return root;
}

/** What the chooser's selector considers for a throw. */
function considered(chooser: Chooser, conditions: Conditions) {
  const { selector } = chooser;
  const { threat } = conditions;
  const character = beforeThrow(selector, conditions);
  character.perceive(threat);
  const { target, time_to_impact_s } = character.state();
  const candidates = character.candidates();
  const before = beforeThrow(selector, conditions);
  const rows = candidates.map(({ clip, vote, expected_cost_ns }): Row => {
    const says = Number.isNaN(expected_cost_ns)
      ? `${(100 * vote).toFixed(0)} % votes`
      : expected_cost_ns.toFixed(2);
    return { clip, says, trial: selector.oracle.tryClip(before, threat, clip) };
  });
  return { rows, target, time: time_to_impact_s };
}

/** The impulse on each body that was hit; they add up to the last line. */
function bodyMap(flinch: Flinch, trial: Trial): HTMLElement {
  const root = element("div", {}, element("h2", { textContent: "Where it hits" }));
  const hit = [...trial.impulse_ns]
    .map((impulse, body) => ({ impulse, name: flinch.bodies[body]!.replaceAll("_", " ") }))
    .filter(({ impulse }) => impulse > 0.005)
    .sort((a, b) => b.impulse - a.impulse);
  if (hit.length === 0) {
    root.append(element("p", { className: "quiet", textContent: "Nothing: the ball misses." }));
    return root;
  }
  const most = hit[0]!.impulse;
  const total = hit.reduce((sum, { impulse }) => sum + impulse, 0);
  const bars = element("div", { className: "bars" });
  for (const { name, impulse } of hit)
    bars.append(
      element("span", { textContent: name }),
      element("meter", { value: impulse / most, max: 1, ariaLabel: name }),
      element("span", { textContent: `${impulse.toFixed(2)} N s` }),
    );
  bars.append(
    element("b", { textContent: "together" }),
    element("span"),
    element("b", { textContent: `${total.toFixed(2)} N s` }),
  );
  root.append(
    bars,
    element("p", {
      className: "quiet",
      textContent: `Weighted by how vulnerable each body is: ${trial.damage_ns.toFixed(2)} N s of damage.`,
    }),
  );
  return root;
}

// SPDX-License-Identifier: MIT
import { costOf } from "./chooser";
import { element } from "./dom";
import type { Take } from "./take";

/** Under a figure alone, in words. */
export function showCaption(root: HTMLElement, name: string, text: string): void {
  root.style.gridTemplate = "1fr / 1fr";
  root.replaceChildren(
    element(
      "div",
      { className: "caption" },
      element("b", { textContent: name }),
      element("div", { className: "numbers", textContent: text }),
    ),
  );
}

/** Under each figure its clip, damage, work and cost. */
export function showCaptions(
  root: HTMLElement,
  takes: readonly Take[],
  columns: number,
  brawn: number,
): void {
  const rows = Math.ceil(takes.length / columns);
  root.style.gridTemplate = `repeat(${rows}, 1fr) / repeat(${columns}, minmax(0, 1fr))`;
  const costs = takes.map(({ trial, chooser }) =>
    trial ? costOf(trial, chooser.selector.oracle, brawn) : 0,
  );
  const least = Math.min(...costs);
  const made = takes.map(({ chooser, clip, trial }, i) => {
    const { name, kind } = chooser.selector.library.clips[clip]!;
    const isBest = takes.length > 1 && trial !== null && costs[i]! <= least * 1.01;
    const numbers = trial
      ? `cost ${costs[i]!.toFixed(2)} · damage ${trial.damage_ns.toFixed(2)} N s · work ${trial.work_j.toFixed(0)} J`
      : "the ball hits nothing";
    const caption = element(
      "div",
      { className: isBest ? "caption best" : "caption", title: chooser.about },
      element("b", { textContent: chooser.name }),
      element("div", { className: "clip", textContent: kind ? `${name.replaceAll("_", " ")} (${kind})` : name }),
      element("div", { className: "numbers", textContent: numbers }),
    );
    return caption;
  });
  root.replaceChildren(...made);
}

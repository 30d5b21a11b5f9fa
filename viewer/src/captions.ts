// SPDX-License-Identifier: MIT
import type { Clip, Trial } from "flinch";
import { costOf } from "./chooser";
import { element } from "./dom";
import type { Take } from "./take";

/** Under a figure alone, in words. Called for every frame. */
export function showCaption(root: HTMLElement, name: string, text: string): void {
  if (root.textContent === name + text) return;
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
    const isBest = takes.length > 1 && trial !== null && costs[i]! <= least * 1.01;
    const caption = element(
      "div",
      { className: isBest ? "caption best" : "caption", title: chooser.about },
      element("b", { textContent: chooser.name }),
      element("div", { className: "clip", textContent: titleOf(chooser.selector.library.clips[clip]!) }),
      element("div", { className: "numbers" }, ...(trial ? numbersOf(trial, costs[i]!) : ["the ball hits nothing"])),
    );
    return caption;
  });
  root.replaceChildren(...made);
}

/** Where there is little room units alone tell them apart. */
function numbersOf(trial: Trial, cost: number): (string | Node)[] {
  const label = (text: string) => element("span", { className: "more", textContent: text });
  return [
    `cost ${cost.toFixed(2)} · `,
    label("damage "),
    `${trial.damage_ns.toFixed(2)} N s · `,
    label("work "),
    `${trial.work_j.toFixed(0)} J`,
  ];
}

/** Its name, and its kind where the name does not begin with that. */
function titleOf({ name, kind }: Clip): string {
  const words = name.replaceAll("_", " ");
  return kind && !words.startsWith(kind) ? `${words} (${kind})` : words;
}

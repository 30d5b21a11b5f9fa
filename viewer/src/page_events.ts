// SPDX-License-Identifier: MIT
// What happens to the page as a whole: the system's colours, the window's size, links, keys, files.
import { byId } from "./dom";

export interface PageActs {
  painted: (scheme: "light" | "dark") => void;
  resized: (width: number, height: number) => void;
  linked: () => void;
  files: (files: Iterable<File>) => void;
  /** Takes a key before `keys` do; whether it did. */
  pressed: (event: KeyboardEvent) => boolean;
}

export function connectPage(acts: PageActs, keys: Record<string, () => void>): void {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const paint = () => acts.painted(dark.matches ? "dark" : "light");
  dark.addEventListener("change", paint);
  paint();
  new ResizeObserver((entries) => {
    const { width, height } = entries.at(-1)!.contentRect;
    acts.resized(width, height);
  }).observe(byId("canvas"));
  addEventListener("hashchange", acts.linked);
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (acts.pressed(event)) {
      event.preventDefault();
      return;
    }
    if (event.target instanceof Element && event.target.closest("input, select, button")) return;
    const act = keys[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
  addEventListener("dragover", (event) => {
    event.preventDefault();
    document.body.classList.add("drop");
  });
  addEventListener("dragleave", () => document.body.classList.remove("drop"));
  addEventListener("drop", (event) => {
    event.preventDefault();
    document.body.classList.remove("drop");
    acts.files(event.dataTransfer?.files ?? []);
  });
}

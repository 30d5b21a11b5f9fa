// SPDX-License-Identifier: MIT
// Elements in one expression. The page has no style attributes, which its security policy forbids.

type Child = Node | string;

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  properties: Partial<HTMLElementTagNameMap[K]> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

export function svg(tag: string, attributes: Record<string, string | number>, ...children: Child[]) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  made.append(...children);
  return made;
}

export function byId<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page lacks #${id}`);
  return found as T;
}

/** Changes a text, if it says something else. */
export function setText(node: Text, text: string): void {
  if (node.data !== text) node.data = text;
}

export function button(text: string, act: () => void, className = ""): HTMLButtonElement {
  return element("button", { type: "button", textContent: text, onclick: act, className });
}

export interface SliderOptions {
  label: string;
  unit: string;
  range: readonly [number, number];
  step: number;
  digits: number;
  scale?: number; // from the value to what is shown
}

/** A labelled slider; `set` shows another value. */
export function slider(options: SliderOptions, changed: (value: number) => void) {
  const { label, unit, range, step, digits, scale = 1 } = options;
  const output = element("output");
  const input = element("input", { type: "range" });
  input.min = String(range[0] * scale);
  input.max = String(range[1] * scale);
  input.step = String(step);
  const show = () => {
    output.textContent = `${Number(input.value).toFixed(digits)} ${unit}`.trim();
  };
  input.oninput = () => {
    show();
    changed(Number(input.value) / scale);
  };
  return {
    root: element("label", { className: "slider" }, label, output, input),
    set(value: number) {
      input.value = String(value * scale);
      show();
    },
  };
}

// SPDX-License-Identifier: MIT
// What the panel says of the crowd.
import { kPushColours } from "./crowd_figures";
import { button, element, svg } from "./dom";

export function crowdPanel(another: () => void): HTMLElement {
  return element(
    "div",
    { id: "crowd", hidden: true },
    element("h2", { textContent: "Twenty who push each other" }),
    element("p", {
      className: "quiet",
      textContent:
        "They walk about by the motion graph of the first selector's library and do not look where they go. Who bumps into another or into a wall is pushed away.",
    }),
    element(
      "div",
      { className: "legend" },
      sample(kPushColours.recorded, "a recorded response answers"),
      sample(kPushColours.physical, "physics answers: no response would look real"),
    ),
    element("div", { className: "buttons" }, button("Another crowd", another, "main")),
    element("p", { className: "quiet", textContent: "The seed in the address gives the same crowd again." }),
  );
}

function sample(colour: number, text: string): HTMLElement {
  const fill = `#${colour.toString(16).padStart(6, "0")}`;
  const mark = svg("svg", { viewBox: "0 0 1 1" }, svg("rect", { width: 1, height: 1, fill }));
  return element("span", {}, mark, text);
}

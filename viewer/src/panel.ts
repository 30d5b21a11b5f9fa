// SPDX-License-Identifier: MIT
// The settings.
import type { ThreatKind } from "flinch";
import type { Chooser } from "./chooser";
import type { ClipEditor } from "./clip_editor";
import { crowdPanel } from "./crowd_panel";
import { button, byId, element, slider } from "./dom";
import { usual } from "./kinds";
import type { View } from "./link";
import type { RoseColours } from "./rose";
import { allowed, kRanges, type Throw } from "./throw";

export interface PanelActs {
  thrown: () => void;
  set: (change: Partial<View>) => void;
  random: () => void;
  disagreeing: () => void;
  files: (files: Iterable<File>) => void;
  redraw: () => void;
}

type Slid = keyof typeof kRanges;
const kSliders: [Slid, string, string, number, number, number][] = [
  // what, label, unit, step, digits, from the value to what is shown
  ["speed", "Speed", "m/s", 0.5, 1, 1],
  ["radius", "Size", "cm across", 1, 0, 200],
  ["mass", "Mass", "kg", 0.01, 2, 1],
  ["time", "Time to impact", "s", 0.01, 2, 1],
  ["azimuth", "From", "°", 1, 0, 1],
];

export class Panel {
  roseColours: RoseColours = "kind";
  showsOverlay = false;
  private view!: View;
  private kinds: readonly ThreatKind[] = [];
  private readonly sliders: [Slid, ReturnType<typeof slider>][];
  private readonly brawn: ReturnType<typeof slider>;
  private readonly delay: ReturnType<typeof slider>;
  private readonly who = element("select", { className: "choice", ariaLabel: "Who answers" });
  private readonly about = element("p", { className: "quiet" });
  private readonly why = element("div", { id: "why" });
  private readonly ball = element("div");
  private readonly kind = element("select", { className: "choice", ariaLabel: "Kind of threat" });
  private readonly stance = element("select", { className: "choice", ariaLabel: "Stance" });
  private readonly overlay = element("label", { className: "quiet" });
  private readonly throwing = element("div"); // all that is about throws
  private readonly crowd = crowdPanel(() => this.acts.random());
  private readonly rose = element("select", { className: "choice", ariaLabel: "Colours of the rose" });

  constructor(
    private readonly acts: PanelActs,
    private readonly clips: ClipEditor,
    private readonly judging: Record<"label" | "study", { root: HTMLElement }>,
  ) {
    this.sliders = kSliders.map(([key, label, unit, step, digits, scale]) => [
      key,
      slider({ label, unit, range: kRanges[key], step, digits, scale }, (value) =>
        this.acts.set({ thrown: { ...this.view.thrown, [key]: value } as Throw }),
      ),
    ]);
    this.brawn = slider(
      { label: "Brawn: work against damage", unit: "", range: [0, 1], step: 0.05, digits: 2 },
      (brawn) => this.acts.set({ brawn }),
    );
    this.delay = slider(
      { label: "Reaction delay", unit: "ms", range: [0, 0.4], step: 10, digits: 0, scale: 1000 },
      (delay) => this.acts.set({ delay }),
    );
    this.kind.onchange = () => {
      const kind = this.kind.selectedIndex;
      const own = usual(this.kinds[kind]!);
      this.acts.set({ thrown: allowed({ ...this.view.thrown, ...own, kind }) });
    };
    this.stance.onchange = () => this.acts.set({ stance: this.stance.selectedIndex });
    this.who.onchange = () => this.acts.set({ figure: this.who.selectedIndex });
    this.rose.append(
      element("option", { value: "kind", textContent: "Colour: kind of clip" }),
      element("option", { value: "protection", textContent: "Colour: what it prevents" }),
    );
    this.rose.onchange = () => {
      this.roseColours = this.rose.value as RoseColours;
      this.acts.redraw();
    };
    this.build();
  }

  private build(): void {
    const overlay = element("input", { type: "checkbox" });
    overlay.onchange = () => {
      this.showsOverlay = overlay.checked;
      this.acts.set({});
    };
    this.overlay.append(overlay, " Show balance and predicted contact");
    const file = element("input", { type: "file", accept: ".flinch", multiple: true, hidden: true });
    file.onchange = () => this.acts.files(file.files ?? []);
    this.ball.append(
      element("h2", { textContent: "The threat" }),
      this.kind,
      ...this.sliders.map(([, made]) => made.root),
    );
    this.throwing.append(
      element(
        "div",
        { className: "buttons" },
        button("Throw", () => this.acts.thrown(), "main"),
        button("Random throw", () => this.acts.random()),
        button("Next disagreement", () => this.acts.disagreeing()),
      ),
      this.who,
      this.rose,
      this.about,
      this.why,
      this.ball,
      element("h2", { textContent: "The character" }),
      this.stance,
      this.delay.root,
      this.brawn.root,
      element("p", {
        className: "quiet",
        textContent:
          "Brawn weighs costs and the oracle's choice here; selectors keep what they were trained with.",
      }),
      this.overlay,
    );
    byId("panel").append(
      this.clips.root,
      this.crowd,
      this.judging.label.root,
      this.judging.study.root,
      this.throwing,
      element("h2", { textContent: "Selectors" }),
      element(
        "div",
        { className: "buttons" },
        button("Open selector…", () => file.click()),
        file,
      ),
      element("p", {
        className: "quiet",
        textContent:
          "Keys: space plays, ← → scrub, T throws again, N throws at random, X finds a disagreement, A D turn.",
      }),
    );
  }

  show(view: View, choosers: readonly Chooser[], brawn: number): void {
    this.view = view;
    this.kinds = choosers[0]?.selector.library.kinds ?? [];
    this.kind.replaceChildren(
      ...this.kinds.map(({ name }) => element("option", { textContent: name.replaceAll("_", " ") })),
    );
    this.kind.selectedIndex = Math.min(view.thrown.kind, this.kinds.length - 1);
    const { clips = [], stances = [] } = choosers[0]?.selector.library ?? {};
    this.stance.replaceChildren(
      ...stances.map((clip) => element("option", { textContent: clips[clip]!.name.replaceAll("_", " ") })),
    );
    this.stance.selectedIndex = view.stance;
    // The other views throw balls of their own, at an idle character.
    const isSet = ["one", "compare"].includes(view.mode);
    this.kind.hidden = this.kinds.length < 2 || !isSet;
    this.stance.hidden = stances.length < 2 || !isSet;
    for (const [key, made] of this.sliders) made.set(view.thrown[key]);
    this.brawn.set(brawn);
    this.delay.set(view.delay);
    this.who.replaceChildren(
      ...choosers.map(({ name }) => element("option", { textContent: name })),
    );
    this.who.selectedIndex = view.figure;
    this.ball.hidden = view.mode === "volley" || view.mode === "tournament"; // which draw theirs
    this.throwing.hidden = ["crowd", "clips", "label", "study"].includes(view.mode);
    this.crowd.hidden = view.mode !== "crowd";
    this.judging.label.root.hidden = view.mode !== "label";
    this.judging.study.root.hidden = view.mode !== "study";
    this.clips.root.hidden = view.mode !== "clips";
    this.who.hidden = view.mode === "compare" || view.mode === "tournament";
    this.rose.hidden = view.mode !== "rose";
    this.overlay.hidden = view.mode !== "one";
    this.about.hidden = this.who.hidden;
    this.about.textContent = choosers[view.figure]?.about ?? "";
  }

  showWhy(content: HTMLElement | null): void {
    this.why.replaceChildren(...(content ? [content] : []));
  }
}

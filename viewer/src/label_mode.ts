// SPDX-License-Identifier: MIT
// Judging pushed motions: what is shown, the estimate, and the answers (Arikan, Forsyth and O'Brien
// 2005, section 5.1).
import type { Labelling, Library } from "flinch";
import { AnswerStore } from "./answer_store";
import { button, element, slider } from "./dom";
import { saveFile } from "./files";
import { Judge } from "./judge";
import { headerOf, labelsOf, lineOf, linesOf } from "./label_file";
import { LabelRecording } from "./label_recording";
import { showMessage } from "./message";

export interface LabelActs {
  /** Another motion is to be shown. */
  shown: (recording: LabelRecording) => void;
}

export class LabelMode {
  /** For the panel. */
  readonly root = element("div", { id: "labelling", hidden: true });
  private library: Library | null = null;
  private labelling: Labelling | null = null;
  private store: AnswerStore | null = null;
  private answer = 0.5; // of the slider
  private readonly sitting = new Date().toISOString();
  private readonly judge = new Judge();
  private readonly estimate = element("meter", { min: 0, max: 1, ariaLabel: "Estimate" });
  private readonly estimateText = element("output");
  private readonly slider = slider(
    { label: "How real does it look?", unit: "", range: [0, 1], step: 0.01, digits: 2 },
    (answer) => (this.answer = answer),
  );
  private readonly state = element("p", { className: "quiet", role: "status" });
  private readonly kept = element("p", { className: "quiet" });

  constructor(private readonly acts: LabelActs) {
    const open = element("input", { type: "file", accept: ".flinchlabels", hidden: true });
    open.onchange = () => {
      for (const file of open.files ?? []) void file.text().then((text) => this.merge(text));
      open.value = "";
    };
    this.root.append(
      element("h2", { textContent: "Is this how a person moves?" }),
      element("label", { className: "slider" }, "Estimate", this.estimateText, this.estimate),
      this.slider.root,
      element(
        "div",
        { className: "buttons" },
        button("Answer", () => this.take(this.answer), "main"),
        button("Skip", () => this.skip()),
      ),
      this.state,
      element("h2", { textContent: "Labels" }),
      this.judge.root,
      this.kept,
      element(
        "div",
        { className: "buttons" },
        button("Save labels", () => this.save()),
        button("Open labels…", () => open.click()),
        open,
      ),
      element("p", {
        className: "quiet",
        textContent:
          "Keys: 0 to 9 answer from 0 (not at all) to 1 (a recording), Enter takes the slider, S skips, space plays again. The arrow is the push.",
      }),
    );
  }

  /** Begins, or goes on, with a library. Throws FlinchError for one without pushes. */
  show(library: Library): void {
    if (this.library !== library) {
      this.labelling?.free();
      this.labelling = null;
      // Motions of another sitting are others: they are drawn by its time.
      this.labelling = library.createLabelling(Date.now() >>> 0);
      this.library = library;
      this.store = new AnswerStore(`flinch labels ${this.labelling.libraryHash}`);
      try {
        this.labelling.add(labelsOf(library, this.store.lines()));
      } catch (error) {
        showMessage(error);
      }
    }
    this.judge.show();
    this.update();
  }

  /** Whether a key means something here. */
  pressed({ key }: KeyboardEvent): boolean {
    if (this.judge.isTyping || !this.labelling) return false;
    if (/^[0-9]$/.test(key)) this.take(Number(key) / 9);
    else if (key === "Enter") this.take(this.answer);
    else if (key === "s" || key === "S") this.skip();
    else return false;
    return true;
  }

  private take(realism: number): void {
    const judge = this.judge.name;
    const { library, labelling, store } = this;
    if (!judge || !library || !labelling || !store) return;
    const label = { judge, sitting: `${judge} ${this.sitting}`, realism, example: labelling.example() };
    store.add(lineOf(library, label));
    labelling.judge(realism);
    this.update();
  }

  private skip(): void {
    this.labelling?.skip();
    this.update();
  }

  private update(): void {
    const { library, labelling, store } = this;
    if (!library || !labelling || !store) return;
    const { estimate, compared, same_side, mean_error, is_agreement, label_count } = labelling.question();
    const isKnown = estimate >= 0;
    this.estimate.value = isKnown ? estimate : 0;
    this.estimateText.textContent = isKnown ? estimate.toFixed(2) : "after 11 labels";
    this.answer = isKnown ? Math.round(estimate * 100) / 100 : 0.5;
    this.slider.set(this.answer);
    const agreement =
      compared === 0
        ? "No estimate has been compared yet."
        : `Of your last ${compared} answers ${Math.round(100 * same_side)} % were on the estimate's side of 0.5; it was off by ${mean_error.toFixed(2)}.`;
    this.state.textContent = is_agreement
      ? `${agreement} Estimate and judge agree: you may stop.`
      : agreement;
    this.state.classList.toggle("agree", Boolean(is_agreement));
    this.kept.textContent = store.place(label_count, "labels");
    this.acts.shown(new LabelRecording(library, labelling));
  }

  private save(): void {
    const { labelling, store } = this;
    if (!labelling || !store) return;
    const lines = [headerOf(labelling.libraryHash), ...store.lines()];
    saveFile("labels.flinchlabels", `${lines.join("\n")}\n`);
  }

  /** Adds the labels of a file, except for those that are here. */
  private merge(text: string): void {
    const { library, labelling, store } = this;
    if (!library || !labelling || !store) return;
    try {
      const known = new Set(store.lines());
      const lines = linesOf(text, labelling.libraryHash).filter((line) => !known.has(line));
      const labels = labelsOf(library, lines);
      labelling.add(labels);
      for (const line of lines) store.add(line);
      this.update();
    } catch (error) {
      showMessage(error);
    }
  }
}

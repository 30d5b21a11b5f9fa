// SPDX-License-Identifier: MIT
// The test of Arikan, Forsyth and O'Brien 2005, section 6: a judge sees pushed motions that the
// selector estimates to look real, others that it does not, and recordings, and says of each whether
// it is a recording. What was shown stands in the file of answers alone.
import type { Labelling, Library } from "flinch";
import { AnswerStore } from "./answer_store";
import { button, element } from "./dom";
import { saveFile } from "./files";
import { Judge } from "./judge";
import { motionOf } from "./label_file";
import type { LabelActs } from "./label_mode";
import { LabelRecording } from "./label_recording";

const kFormat = "flinch study 1";
const kKeys: Record<string, Answer> = { y: "yes", u: "unsure", n: "no" };
type Answer = "yes" | "unsure" | "no";

export class StudyMode {
  /** For the panel. */
  readonly root = element("div", { id: "study", hidden: true });
  private library: Library | null = null;
  private labelling: Labelling | null = null;
  private store: AnswerStore | null = null;
  private asked: ReturnType<Labelling["study"]> | null = null;
  private number = 0; // of the motion
  private readonly seed = Date.now() >>> 0;
  private readonly sitting = new Date().toISOString();
  private readonly judge = new Judge();
  private readonly kept = element("p", { className: "quiet", role: "status" });

  constructor(private readonly acts: LabelActs) {
    this.root.append(
      element("h2", { textContent: "Is this a recording of a person?" }),
      element(
        "div",
        { className: "buttons" },
        button("Yes", () => this.take("yes"), "main"),
        button("Unsure", () => this.take("unsure")),
        button("No", () => this.take("no")),
      ),
      this.judge.root,
      this.kept,
      element("div", { className: "buttons" }, button("Save answers", () => this.save())),
      element("p", {
        className: "quiet",
        textContent: "Keys: Y, U and N answer, space plays again. The arrow is the push.",
      }),
    );
  }

  /** Begins, or goes on, with a library. Throws FlinchError for a selector without a realism model. */
  show(library: Library): void {
    if (this.library !== library) {
      this.labelling?.free();
      this.labelling = library.createLabelling(this.seed);
      this.library = library;
      this.store = new AnswerStore(`flinch study ${this.labelling.libraryHash}`);
    }
    this.judge.show();
    this.next();
  }

  /** Whether a key means something here. */
  pressed({ key }: KeyboardEvent): boolean {
    const answer = kKeys[key.toLowerCase()];
    if (this.judge.isTyping || !this.labelling || !answer) return false;
    this.take(answer);
    return true;
  }

  private take(answer: Answer): void {
    const judge = this.judge.name;
    const { library, labelling, store, asked, sitting } = this;
    if (!judge || !library || !labelling || !store || !asked) return;
    const motion = motionOf(library, labelling.example());
    store.add(JSON.stringify({ judge, sitting: `${judge} ${sitting}`, ...asked, answer, ...motion }));
    this.next();
  }

  private next(): void {
    const { library, labelling, store } = this;
    if (!library || !labelling || !store) return;
    this.asked = labelling.study(this.seed, this.number++);
    this.kept.textContent = store.place(store.lines().length, "answers");
    this.acts.shown(new LabelRecording(library, labelling));
  }

  private save(): void {
    const { labelling, store } = this;
    if (!labelling || !store) return;
    const header = JSON.stringify({ format: kFormat, library: labelling.libraryHash });
    saveFile("answers.flinchstudy", `${[header, ...store.lines()].join("\n")}\n`);
  }
}

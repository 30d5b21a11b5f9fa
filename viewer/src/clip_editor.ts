// SPDX-License-Identifier: MIT
// The clips of a library on a timeline: onset, peak and end can be dragged, and the lines for a
// manifest copied.
import type { Clip, Library } from "flinch";
import { button, byId, element } from "./dom";

const kMarks = ["onset", "peak", "end"] as const;
type Mark = (typeof kMarks)[number];
type Times = Record<Mark, number>;
const kStep = 1 / 60; // s: marks are on frames of 60 Hz, and differ by at least one
const kDegrees = ["mild", "exaggerated"]; // FLINCH_MILD, FLINCH_EXAGGERATED

export interface ClipEditorActs {
  chosen: (clip: number) => void;
  seek: (time: number) => void;
}

export class ClipEditor {
  /** For the panel: which clip, and its lines for a manifest. */
  readonly root = element("div", { id: "clip-editor", hidden: true });
  private readonly which = element("select", { className: "choice", ariaLabel: "Clip" });
  private readonly about = element("p", { className: "quiet" });
  private readonly lines = element("pre", { ariaLabel: "Lines for a manifest" });
  private readonly timeline = byId("timeline");
  private readonly playhead = element("div", { className: "playhead" });
  private readonly marks: Record<Mark, HTMLElement>;
  private readonly edited = new Map<string, Times>(); // by the clip's name
  private shown: { library: Library; clip: Clip } | null = null;

  constructor(private readonly acts: ClipEditorActs) {
    this.which.onchange = () => this.acts.chosen(this.which.selectedIndex);
    const copy = button("Copy", () => void navigator.clipboard.writeText(this.toml));
    const reset = button("As it was", () => this.reset());
    this.root.append(
      this.which,
      this.about,
      element("h2", { textContent: "For a manifest" }),
      this.lines,
      element("div", { className: "buttons" }, copy, reset),
      element("p", {
        className: "quiet",
        textContent:
          "Seconds from the clip's start: add the clip's start in its file. Drag the marks on the timeline, or move them by the arrow keys.",
      }),
    );
    this.marks = { onset: this.markOf("onset"), peak: this.markOf("peak"), end: this.markOf("end") };
    this.timeline.append(this.playhead, ...Object.values(this.marks));
    this.timeline.addEventListener("pointerdown", (event) => {
      if (event.target === this.timeline) this.acts.seek(this.timeAt(event));
    });
  }

  show(library: Library, index: number): void {
    const clip = library.clips[index]!;
    if (this.shown?.library !== library)
      this.which.replaceChildren(
        ...library.clips.map(({ name }) =>
          element("option", { textContent: name.replaceAll("_", " ") }),
        ),
      );
    this.shown = { library, clip };
    this.which.selectedIndex = index;
    const { targets } = library.flinch;
    this.about.textContent = clip.is_annotated
      ? `${clip.kind || "clip"}, protects the ${targets[clip.target]} from ${degreesOf(clip)}°, ${kDegrees[clip.degree]}, ${clip.duration_s.toFixed(2)} s`
      : `${clip.kind || "no annotation"}, ${clip.duration_s.toFixed(2)} s`;
    this.update();
  }

  showTime(time: number): void {
    if (this.shown) this.playhead.style.left = this.placeOf(time);
  }

  /** The lines of the manifest for the shown clip. */
  get toml(): string {
    const { library, clip } = this.shown!;
    const times = this.times;
    const lines = ["[[clip]]", `name = ${JSON.stringify(clip.name)}`];
    if (clip.kind) lines.push(`kind = ${JSON.stringify(clip.kind)}`);
    if (clip.is_annotated)
      lines.push(
        `target = "${library.flinch.targets[clip.target]}"`,
        `direction = ${degreesOf(clip)}`,
        `degree = "${kDegrees[clip.degree]}"`,
        ...kMarks.map((mark) => `${mark} = ${times[mark].toFixed(3)}`),
      );
    return `${lines.join("\n")}\n`;
  }

  private get times(): Times {
    const { clip } = this.shown!;
    const { onset_s: onset, peak_s: peak, end_s: end } = clip;
    return this.edited.get(clip.name) ?? { onset, peak, end };
  }

  private markOf(mark: Mark): HTMLElement {
    const made = element("button", { type: "button", className: `mark ${mark}`, ariaLabel: mark });
    made.setAttribute("role", "slider");
    made.append(element("span", { textContent: mark }));
    made.addEventListener("pointerdown", (event) => made.setPointerCapture(event.pointerId));
    made.addEventListener("pointermove", (event) => {
      if (made.hasPointerCapture(event.pointerId)) this.move(mark, this.timeAt(event));
    });
    made.addEventListener("keydown", ({ key }) => {
      const steps = { ArrowLeft: -1, ArrowRight: 1 }[key];
      if (steps) this.move(mark, this.times[mark] + steps * kStep);
    });
    return made;
  }

  /** Moves a mark as far as the others and the clip's ends allow, and shows the pose there. */
  private move(mark: Mark, wanted: number): void {
    const { clip } = this.shown!;
    const times = { ...this.times };
    const low = { onset: 0, peak: times.onset + kStep, end: times.peak }[mark];
    const high = { onset: times.peak - kStep, peak: times.end, end: clip.duration_s }[mark];
    times[mark] = Math.min(Math.max(Math.round(wanted / kStep) * kStep, low), high);
    this.edited.set(clip.name, times);
    this.update();
    this.acts.seek(times[mark]);
  }

  private reset(): void {
    this.edited.delete(this.shown!.clip.name);
    this.update();
  }

  private update(): void {
    const { clip } = this.shown!;
    const { times } = this;
    for (const mark of kMarks) {
      const made = this.marks[mark];
      made.hidden = !clip.is_annotated;
      made.style.left = this.placeOf(times[mark]);
      made.ariaValueNow = times[mark].toFixed(3);
      made.ariaValueMin = "0";
      made.ariaValueMax = clip.duration_s.toFixed(3);
      made.title = `${mark}: ${times[mark].toFixed(3)} s`;
    }
    this.lines.textContent = this.toml;
  }

  private placeOf(time: number): string {
    return `${(100 * time) / this.shown!.clip.duration_s}%`;
  }

  private timeAt({ clientX }: PointerEvent): number {
    const { left, width } = this.timeline.getBoundingClientRect();
    const share = Math.min(Math.max((clientX - left) / width, 0), 1);
    return share * this.shown!.clip.duration_s;
  }
}

function degreesOf({ direction }: Clip): number {
  return Math.round((direction * 180) / Math.PI);
}

// SPDX-License-Identifier: MIT
// The time of the playback.
import { button, element, setText } from "./dom";

const kPaces = [1, 0.5, 0.25, 0.1];

export class Player {
  time = 0;
  pace = 1;
  isPlaying = false;
  private duration = 1; // s, of what is shown
  readonly root: HTMLElement[];
  private last = 0;
  private readonly playing = new Text("Play"); // of the button
  private readonly play = button("", () => this.toggle(), "main");
  private readonly scrub = element("input", { type: "range", ariaLabel: "Time" });
  private readonly shownTime = new Text();
  private readonly output = element("output", {}, this.shownTime);
  private readonly paces = element("select", { ariaLabel: "Speed of the playback" });

  constructor(private readonly changed: () => void) {
    Object.assign(this.scrub, { min: "0", step: "0.001" });
    this.scrub.oninput = () => {
      this.isPlaying = false;
      this.seek(Number(this.scrub.value));
    };
    for (const pace of kPaces)
      this.paces.append(element("option", { value: String(pace), textContent: `${pace} ×` }));
    this.paces.onchange = () => {
      this.pace = Number(this.paces.value);
      this.changed();
    };
    this.play.append(this.playing);
    this.root = [this.play, this.scrub, this.output, this.paces];
  }

  /** What is shown lasts so long. */
  setDuration(duration: number): void {
    this.duration = duration;
    this.scrub.max = String(duration);
    this.time = Math.min(this.time, duration);
    this.show();
  }

  seek(time: number): void {
    this.time = Math.min(Math.max(time, 0), this.duration);
    this.show();
    this.changed();
  }

  setPace(pace: number): void {
    this.pace = kPaces.reduce((a, b) => (Math.abs(b - pace) < Math.abs(a - pace) ? b : a));
    this.show();
  }

  start(): void {
    this.seek(0);
    this.resume();
  }

  resume(): void {
    if (this.time >= this.duration) this.time = 0;
    this.isPlaying = true;
    this.last = 0;
    this.show();
    this.changed();
  }

  pause(): void {
    this.isPlaying = false;
    this.show();
    this.changed();
  }

  toggle(): void {
    if (this.isPlaying) this.pause();
    else this.resume();
  }

  /** Advances to the browser's time `now_ms`; whether anything moves. */
  tick(now_ms: number): boolean {
    if (!this.isPlaying) return false;
    // A hidden page gives one long frame, which must not end the playback.
    const dt = this.last > 0 ? Math.min((now_ms - this.last) / 1000, 0.1) : 0;
    this.last = now_ms;
    this.time = Math.min(this.time + dt * this.pace, this.duration);
    if (this.time >= this.duration) {
      this.isPlaying = false;
      this.changed();
    }
    this.show();
    return true;
  }

  /** Called for every frame: what has not changed is not written, nor are nodes made anew. */
  private show(): void {
    this.scrub.value = String(this.time);
    setText(this.shownTime, `${this.time.toFixed(2)} s`);
    setText(this.playing, this.isPlaying ? "Pause" : "Play");
    const pace = String(this.pace);
    if (this.paces.value !== pace) this.paces.value = pace;
  }
}

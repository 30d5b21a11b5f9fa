// SPDX-License-Identifier: MIT
// A clip of a library, as it was recorded or authored.
import type { Library } from "flinch";
import { kRate, Recording } from "./recording";

export class ClipRecording extends Recording {
  private readonly untouched: Float32Array;

  constructor(
    readonly library: Library,
    readonly clip: number,
  ) {
    super(library.clips[clip]!.duration_s);
    this.untouched = new Float32Array(library.outlines.length);
    this.advance();
  }

  free(): void {}

  protected advance(): void {
    const pose = this.library.clipPose(this.clip, this.frames.length / kRate);
    const joints = this.library.jointFrames(pose);
    this.frames.push({ joints, balls: [], impulses: this.untouched });
  }
}

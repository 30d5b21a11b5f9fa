// SPDX-License-Identifier: MIT
// A pushed motion that is judged.
import type { Labelling, Library } from "flinch";
import { Quaternion, Vector3 } from "three";
import { kRate, Recording } from "./recording";

const kArrowLength = 0.35; // m
const kShown_s = 0.25; // after the push

export class LabelRecording extends Recording {
  private readonly untouched: Float32Array;
  private readonly count: number;
  private readonly push_s: number;
  private readonly arrow: Vector3[];

  constructor(
    readonly library: Library,
    readonly labelling: Labelling,
  ) {
    const { frame_count, push_s } = labelling.question();
    super((frame_count - 1) / kRate);
    this.count = frame_count;
    this.push_s = push_s;
    this.untouched = new Float32Array(library.outlines.length);
    while (this.frames.length <= frame_count) this.advance(); // before the next question
    this.arrow = this.pushArrow();
  }

  free(): void {}

  /** A line that ends at the pushed joint and goes the way of the push, while it comes. */
  arrowAt(time: number): Vector3[] {
    return time >= this.push_s - 0.1 && time < this.push_s + kShown_s ? this.arrow : [];
  }

  protected advance(): void {
    const pose = this.labelling.pose(Math.min(this.frames.length, this.count - 1));
    const joints = this.library.jointFrames(pose);
    this.frames.push({ joints, balls: [], impulses: this.untouched });
  }

  private pushArrow(): Vector3[] {
    const { place, asked } = this.labelling.example();
    const { joints } = this.frames[Math.round(this.push_s * kRate)]!;
    const joint = new Vector3().fromArray(joints.position, 3 * place);
    const [w, x, y, z] = joints.orientation; // of the pelvis, which comes first
    const forward = new Vector3(1, 0, 0).applyQuaternion(new Quaternion(x, y, z, w));
    const facing = Math.atan2(forward.y, forward.x);
    const way = new Vector3(asked[0], asked[1], 0)
      .normalize()
      .applyAxisAngle(new Vector3(0, 0, 1), facing);
    const from = joint.clone().addScaledVector(way, -kArrowLength);
    const barb = (side: number) =>
      joint.clone().addScaledVector(way, -0.08).addScaledVector(new Vector3(-way.y, way.x, 0), side * 0.05);
    return [from, joint, barb(1), joint, barb(-1)];
  }
}

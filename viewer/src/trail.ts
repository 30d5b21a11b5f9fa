// SPDX-License-Identifier: MIT
// The path of a ball so far, as a line that grows from frame to frame.
import { BufferAttribute, BufferGeometry, Line, LineBasicMaterial, type Vector3 } from "three";
import { kRate, type Recording } from "./recording";

const kMostPoints = 4 * kRate;

export class Trail {
  readonly line: Line<BufferGeometry, LineBasicMaterial>;
  private readonly path = new BufferAttribute(new Float32Array(3 * (kMostPoints + 1)), 3);
  private ball = -1;
  private first = 0; // the frame in which the path begins
  private known = 0; // points that are as recorded; the one after them was where the ball had come

  constructor(
    private readonly recording: Recording,
    material: LineBasicMaterial,
  ) {
    this.line = new Line(new BufferGeometry().setAttribute("position", this.path), material);
    this.line.frustumCulled = false;
  }

  /** Shows the path of a ball up to this frame, and from there to `end`. */
  show(ball: number, frame: number, end: Vector3): void {
    if (ball !== this.ball) this.begin(ball, frame);
    const count = Math.min(frame - this.first + 1, kMostPoints);
    const changed = Math.min(this.known, count);
    for (let i = changed; i < count; ++i) this.path.setXYZ(i, ...this.placeIn(this.first + i)!);
    this.path.setXYZ(count, end.x, end.y, end.z);
    this.known = count;
    this.path.clearUpdateRanges();
    this.path.addUpdateRange(3 * changed, 3 * (count + 1 - changed));
    this.path.needsUpdate = true;
    this.line.geometry.setDrawRange(0, count + 1);
  }

  dispose(): void {
    this.line.geometry.dispose();
  }

  private begin(ball: number, frame: number): void {
    this.ball = ball;
    this.first = frame;
    this.known = 0;
    while (this.first > 0 && this.placeIn(this.first - 1)) --this.first;
  }

  private placeIn(frame: number): [number, number, number] | undefined {
    return this.recording.frames[frame]!.balls.find(({ id }) => id === this.ball)?.position;
  }
}

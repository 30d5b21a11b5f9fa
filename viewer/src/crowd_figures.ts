// SPDX-License-Identifier: MIT
// The figures of a crowd, the square in which they walk, and an arrow on the ground for each push.
import type { JointFrames, Library } from "flinch";
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Quaternion,
  RingGeometry,
  Vector3,
} from "three";
import type { CrowdRecording } from "./crowd_recording";
import { Figure, type Drawn } from "./figure";

/** Colours of arrows: the push is answered by a recorded response, or by physics. */
export const kPushColours = { recorded: 0xd0342c, physical: 0x2f6fd0 };
const kMostArrows = 40; // every character twice
const kEdge = 0.07; // m, width of the square's line
const kOnFloor = 0.004; // m
const kGap = 0.22; // m from a character's middle to its arrow
const kUp = new Vector3(0, 0, 1);

export class CrowdFigures implements Drawn {
  readonly mesh = new Group();
  private readonly figures: Figure[];
  private readonly square: Mesh<RingGeometry, MeshBasicMaterial>;
  private readonly arrows: InstancedMesh<BufferGeometry, MeshBasicMaterial>;
  private readonly matrix = new Matrix4();

  constructor(library: Library, count: number, half_side: number) {
    this.figures = Array.from({ length: count }, (_, i) => new Figure(library, shirtOf(i)));
    const corner = Math.SQRT2 * half_side;
    this.square = new Mesh(
      new RingGeometry(corner, corner + Math.SQRT2 * kEdge, 4, 1, Math.PI / 4),
      new MeshBasicMaterial({ color: kPushColours.recorded }),
    );
    this.square.position.z = kOnFloor;
    this.arrows = new InstancedMesh(arrow(), new MeshBasicMaterial(), kMostArrows);
    this.arrows.frustumCulled = false;
    this.arrows.count = 0;
    this.mesh.add(this.square, this.arrows, ...this.figures.map(({ mesh }) => mesh));
  }

  show(from: JointFrames, to: JointFrames, share: number): void {
    this.figures.forEach((figure, i) => figure.show(from, to, share, i));
  }

  glow(): void {} // no ball hits them

  /** The pushes that are seen at a time. */
  showPushes(recording: CrowdRecording, time: number): void {
    const shown = recording.pushesAt(time).slice(-kMostArrows);
    shown.forEach(({ push, share }, i) => {
      const [x, y] = push.velocity as unknown as [number, number];
      const speed = Math.hypot(x, y);
      const turn = new Quaternion().setFromAxisAngle(kUp, Math.atan2(y, x));
      const from = new Vector3(push.at[0], push.at[1], 2 * kOnFloor);
      from.add(new Vector3(kGap * (x / speed), kGap * (y / speed), 0));
      const length = share * (0.35 + 0.45 * speed);
      this.arrows.setMatrixAt(i, this.matrix.compose(from, turn, new Vector3(length, share, 1)));
      this.arrows.setColorAt(i, new Color(push.is_physical ? kPushColours.physical : kPushColours.recorded));
    });
    this.arrows.count = shown.length;
    this.arrows.instanceMatrix.needsUpdate = true;
    if (this.arrows.instanceColor) this.arrows.instanceColor.needsUpdate = true;
  }

  /** How many arrows are seen. */
  get arrowCount(): number {
    return this.arrows.count;
  }

  dispose(): void {
    for (const figure of this.figures) figure.dispose();
    for (const { geometry, material } of [this.square, this.arrows]) {
      geometry.dispose();
      material.dispose();
    }
    this.arrows.dispose();
  }
}

/** Colours that go round by the golden angle, so that no two neighbours are alike. */
function shirtOf(index: number): number {
  return new Color().setHSL((0.58 + 0.381966 * index) % 1, 0.42, index % 2 ? 0.52 : 0.4).getHex();
}

/** A flat arrow of unit length along X. */
function arrow(): BufferGeometry {
  const corners = [0, 0.07, 0, -0.07, 0.62, -0.07, 0.62, 0.07, 0.62, -0.19, 1, 0, 0.62, 0.19];
  const positions = new Float32Array(corners.length / 2 * 3);
  for (let i = 0; i < corners.length / 2; ++i) positions.set(corners.slice(2 * i, 2 * i + 2), 3 * i);
  return new BufferGeometry()
    .setAttribute("position", new BufferAttribute(positions, 3))
    .setIndex([0, 1, 2, 0, 2, 3, 4, 5, 6]);
}

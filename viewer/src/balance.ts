// SPDX-License-Identifier: MIT
// Where a figure stands and where its weight is.
import type { JointFrames, Library } from "flinch";
import { Quaternion, Vector3 } from "three";

const kOnGround = 0.03; // m: corners of the feet below this bear weight

function placed(frames: JointFrames, joint: number, local: Vector3): Vector3 {
  const [w, x, y, z] = frames.orientation.subarray(4 * joint, 4 * joint + 4);
  return local
    .applyQuaternion(new Quaternion(x, y, z, w))
    .add(new Vector3().fromArray(frames.position, 3 * joint));
}

export function centreOfMass(library: Library, frames: JointFrames): Vector3 {
  const sum = new Vector3();
  let mass = 0;
  for (const outline of library.outlines) {
    const centre = placed(frames, outline.joint, new Vector3(...outline.centre_of_mass));
    sum.addScaledVector(centre, outline.mass_kg);
    mass += outline.mass_kg;
  }
  return sum.divideScalar(mass);
}

/** The convex hull, on the ground, of the soles' corners that touch it; closed. */
export function supportPolygon(library: Library, frames: JointFrames): Vector3[] {
  const corners: Vector3[] = [];
  for (const body of [13, 16]) {
    const foot = library.outlines[body]!;
    const [x, y, z] = foot.half_extents as unknown as [number, number, number];
    const [w, i, j, k] = foot.orientation;
    for (const [a, b] of [[1, 1], [1, -1], [-1, 1], [-1, -1]] as const) {
      const local = new Vector3(a * x, b * y, -z)
        .applyQuaternion(new Quaternion(i, j, k, w))
        .add(new Vector3(...foot.centre));
      const corner = placed(frames, foot.joint, local);
      if (corner.z < kOnGround) corners.push(corner.setZ(0.006));
    }
  }
  return hullOf(corners);
}

/** Andrew's monotone chain. */
function hullOf(points: Vector3[]): Vector3[] {
  if (points.length < 3) return [];
  const sorted = [...points].sort((a, b) => a.x - b.x || a.y - b.y);
  const half = (ordered: Vector3[]) => {
    const chain: Vector3[] = [];
    for (const point of ordered) {
      while (chain.length > 1 && !isLeft(chain.at(-2)!, chain.at(-1)!, point)) chain.pop();
      chain.push(point);
    }
    return chain.slice(0, -1);
  };
  const hull = [...half(sorted), ...half(sorted.reverse())];
  return [...hull, hull[0]!];
}

function isLeft(a: Vector3, b: Vector3, c: Vector3): boolean {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
}

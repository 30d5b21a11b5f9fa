// SPDX-License-Identifier: MIT
// A figure: a surface that moves with the joints, and lights up where a ball has hit.
import type { JointFrames, Library } from "flinch";
import {
  Bone,
  BufferAttribute,
  BufferGeometry,
  Color,
  Matrix4,
  MeshStandardMaterial,
  Quaternion,
  Skeleton,
  SkinnedMesh,
  Sphere,
  Uint16BufferAttribute,
  Vector3,
} from "three";

const kGlow = new Color(0xff4a1c);
const kFullGlow_ns = 2.5; // an impulse that lights a body fully
const kHair = 0x3a2a20;
const kSkin = 0xe0ad8d;
const kEyes = 0x22262e;
const kLips = 0xb5705f;
const kShoes = 0x2c3038;
const kOne = new Vector3(1, 1, 1);

export class Figure {
  readonly mesh: SkinnedMesh<BufferGeometry, MeshStandardMaterial>;
  private readonly bones: Bone[];
  private readonly plain: Float32Array; // colours without glow
  private readonly bodyOf: Uint8Array; // for each vertex
  private glowing: Float32Array | null = null;

  constructor(library: Library, colour: number) {
    const skin = library.skin();
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(skin.position, 3));
    geometry.setAttribute("normal", new BufferAttribute(skin.normal, 3));
    geometry.setAttribute("skinIndex", new Uint16BufferAttribute(skin.joint, 4));
    geometry.setAttribute("skinWeight", new BufferAttribute(skin.weight, 4));
    geometry.setIndex(skin.triangles.flatMap((corners) => Array.from(corners)));
    this.plain = coloursOf(skin.triangles, skin.position.length / 3, new Color(colour));
    geometry.setAttribute("color", new BufferAttribute(this.plain.slice(), 3));
    const bodies = bodyOfJoints(library);
    this.bodyOf = Uint8Array.from({ length: skin.joint.length / 4 }, (_, v) => bodies[skin.joint[4 * v]!]!);
    this.bones = bodies.map(() => {
      const bone = new Bone();
      bone.matrixAutoUpdate = false;
      return bone;
    });
    const rest = restPositions(library);
    const inverses = rest.map((position) => new Matrix4().setPosition(position.negate()));
    const material = new MeshStandardMaterial({ vertexColors: true, roughness: 0.8 });
    this.mesh = new SkinnedMesh(geometry, material);
    for (const bone of this.bones) this.mesh.add(bone);
    this.mesh.bind(new Skeleton(this.bones, inverses), new Matrix4());
    this.mesh.castShadow = this.mesh.receiveShadow = true;
    this.mesh.frustumCulled = false;
    this.mesh.boundingSphere = new Sphere(new Vector3(0, 0, 1), 4); // wherever it moves
  }

  /** Shows a pose between two recorded ones. */
  show(from: JointFrames, to: JointFrames, share: number): void {
    this.bones.forEach((bone, joint) => {
      const orientation = quaternionOf(from.orientation, joint).slerp(
        quaternionOf(to.orientation, joint),
        share,
      );
      const position = vectorOf(from.position, joint).lerp(vectorOf(to.position, joint), share);
      bone.matrix.compose(position, orientation, kOne);
      bone.matrixWorldNeedsUpdate = true;
    });
  }

  /** Lights the bodies that were hit: impulses in N s. */
  glow(impulses: Float32Array): void {
    if (impulses === this.glowing) return;
    this.glowing = impulses;
    const share = Array.from(impulses, (impulse) => 0.9 * Math.sqrt(Math.min(impulse / kFullGlow_ns, 1)));
    const colours = this.mesh.geometry.attributes.color as BufferAttribute;
    const glow = kGlow.toArray();
    for (let i = 0; i < this.plain.length; ++i) {
      const lit = share[this.bodyOf[Math.floor(i / 3)]!]!;
      colours.array[i] = this.plain[i]! + lit * (glow[i % 3]! - this.plain[i]!);
    }
    colours.needsUpdate = true;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.mesh.skeleton.dispose();
  }
}

/** A colour for each vertex, of what covers it. */
function coloursOf(triangles: Uint32Array[], count: number, shirt: Color): Float32Array {
  const trousers = shirt.clone().multiplyScalar(0.35);
  const coverings = [kSkin, kHair, kEyes, kLips, shirt, trousers, kShoes].map((of) =>
    new Color(of).toArray(),
  );
  const colours = new Float32Array(3 * count);
  triangles.forEach((corners, covering) => {
    for (const vertex of corners) colours.set(coverings[covering]!, 3 * vertex);
  });
  return colours;
}

/** The body that moves with each joint: that of the joint, or of the nearest parent that has one. */
function bodyOfJoints({ outlines, flinch }: Library): number[] {
  const own = new Map(outlines.map(({ joint }, body) => [joint, body]));
  return flinch.joints.map((_, joint) => {
    let at = joint;
    while (!own.has(at)) at = flinch.parents[at]!;
    return own.get(at)!;
  });
}

/** Joints in the rest pose, where every frame is parallel to the world's. */
function restPositions({ skeleton, flinch }: Library): Vector3[] {
  const positions: Vector3[] = [];
  flinch.parents.forEach((parent, joint) => {
    const offset = vectorOf(skeleton.offset, joint);
    positions.push(parent < 0 ? offset : offset.add(positions[parent]!));
  });
  return positions;
}

function vectorOf(values: Float32Array, joint: number): Vector3 {
  return new Vector3().fromArray(values, 3 * joint);
}

function quaternionOf(values: Float32Array, joint: number): Quaternion {
  const [w, x, y, z] = values.subarray(4 * joint, 4 * joint + 4);
  return new Quaternion(x, y, z, w);
}

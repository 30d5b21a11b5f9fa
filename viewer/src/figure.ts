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
  type Object3D,
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

/** What a cell of the stage draws of a recording. */
export interface Drawn {
  readonly mesh: Object3D;
  /** Shows what is between two recorded frames. */
  show(from: JointFrames, to: JointFrames, share: number): void;
  /** Lights the bodies that were hit: impulses in N s. */
  glow(impulses: Float32Array): void;
  dispose(): void;
}

export class Figure implements Drawn {
  readonly mesh: SkinnedMesh<BufferGeometry, MeshStandardMaterial>;
  private readonly bones: Bone[];
  private readonly plain: Float32Array; // colours without glow
  private readonly verticesOf: number[][]; // of each body
  private readonly lit: Float32Array; // share of the glow on each body
  // Of one joint, while its matrix is composed: nothing is allocated for a frame.
  private readonly position = new Vector3();
  private readonly nextPosition = new Vector3();
  private readonly orientation = new Quaternion();
  private readonly nextOrientation = new Quaternion();

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
    this.verticesOf = library.outlines.map(() => []);
    for (let v = 0; v < skin.joint.length / 4; ++v)
      this.verticesOf[bodies[skin.joint[4 * v]!]!]!.push(v);
    this.lit = new Float32Array(this.verticesOf.length);
    // Bones stand beside the scene: their matrices are the world's, and nobody else walks over them.
    this.bones = bodies.map(() => new Bone());
    const rest = restPositions(library);
    const inverses = rest.map((position) => new Matrix4().setPosition(position.negate()));
    const material = new MeshStandardMaterial({ vertexColors: true, roughness: 0.8 });
    this.mesh = new SkinnedMesh(geometry, material);
    this.mesh.bind(new Skeleton(this.bones, inverses), new Matrix4());
    this.mesh.castShadow = this.mesh.receiveShadow = true;
    this.mesh.frustumCulled = false;
    this.mesh.boundingSphere = new Sphere(new Vector3(0, 0, 1), 4); // wherever it moves
  }

  /** Shows a pose between two recorded ones, of figure `number` where they hold several, one after the
   * other. */
  show(from: JointFrames, to: JointFrames, share: number, number = 0): void {
    const { position, nextPosition, orientation, nextOrientation } = this;
    this.bones.forEach(({ matrixWorld }, bone) => {
      const joint = number * this.bones.length + bone;
      setQuaternion(orientation, from.orientation, joint);
      setQuaternion(nextOrientation, to.orientation, joint);
      position.fromArray(from.position, 3 * joint);
      nextPosition.fromArray(to.position, 3 * joint);
      matrixWorld.compose(
        position.lerp(nextPosition, share),
        orientation.slerp(nextOrientation, share),
        kOne,
      );
    });
  }

  /** Lights the bodies that were hit: impulses in N s. Most frames change no body, which costs
   * nothing then. */
  glow(impulses: Float32Array): void {
    impulses.forEach((impulse, body) => {
      const share = Math.fround(0.9 * Math.sqrt(Math.min(impulse / kFullGlow_ns, 1)));
      if (share !== this.lit[body]) this.light(body, share);
    });
  }

  private light(body: number, share: number): void {
    this.lit[body] = share;
    const colours = this.mesh.geometry.attributes.color as BufferAttribute;
    const glow = kGlow.toArray();
    for (const vertex of this.verticesOf[body]!)
      for (let i = 0; i < 3; ++i) {
        const plain = this.plain[3 * vertex + i]!;
        colours.array[3 * vertex + i] = plain + share * (glow[i]! - plain);
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
    const offset = new Vector3().fromArray(skeleton.offset, 3 * joint);
    positions.push(parent < 0 ? offset : offset.add(positions[parent]!));
  });
  return positions;
}

function setQuaternion(quaternion: Quaternion, values: Float32Array, joint: number): void {
  const at = 4 * joint;
  quaternion.set(values[at + 1]!, values[at + 2]!, values[at + 3]!, values[at]!);
}

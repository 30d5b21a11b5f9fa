// SPDX-License-Identifier: MIT
// The drawing: ground, light, shadow, one cell for each figure, all seen by one camera.
import {
  AmbientLight,
  BufferGeometry,
  CapsuleGeometry,
  CircleGeometry,
  Color,
  DirectionalLight,
  Fog,
  GridHelper,
  Group,
  HemisphereLight,
  Line,
  LineBasicMaterial,
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  Raycaster,
  Scene,
  ShadowMaterial,
  SphereGeometry,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import type { Drawn } from "./figure";
import type { OverlayLine } from "./overlay";
import type { Ball, Frame, Recording } from "./recording";
import { Trail } from "./trail";

const kMostBalls = 3;
const kShift = 0.1; // of a cell's height
const kClear = 3.4; // m behind the origin, from where things fade into the fog
const kMist = 14; // m on which they do
const kLit = 2.5; // m around the origin: where one figure moves
const kAlongRod = new Vector3(0, 1, 0); // of three.js's capsule

export interface Palette {
  ground: number;
  fog: number;
  grid: number;
  ball: number;
}
export const kPalettes: Record<"light" | "dark", Palette> = {
  light: { ground: 0xe9edf2, fog: 0xe9edf2, grid: 0xc9d1db, ball: 0xe2702a },
  dark: { ground: 0x171b22, fog: 0x171b22, grid: 0x2b323d, ball: 0xff9a4d },
};

/** What one cell of the stage shows. */
export interface Cell {
  recording: Recording;
  figure: Drawn;
}

export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(38, 1, 0.05, 60);
  private readonly renderer: WebGLRenderer;
  private readonly sun = new DirectionalLight(0xffffff, 2.4);
  private readonly ground: Mesh<CircleGeometry, MeshStandardMaterial>;
  private readonly shadow: Mesh<CircleGeometry, ShadowMaterial>;
  private readonly balls: Mesh<BufferGeometry, MeshStandardMaterial>[];
  private readonly sphere = new SphereGeometry(1, 32, 20);
  private rod: CapsuleGeometry | null = null; // of the last length
  private readonly trails: Trail[] = []; // of the cells
  private readonly trailMaterial = new LineBasicMaterial();
  private readonly aim = new Line(new BufferGeometry(), new LineBasicMaterial());
  private readonly overlay = new Group();
  private readonly fog = new Fog(0);
  private grid = new GridHelper(24, 24);
  private readonly raycaster = new Raycaster();
  private readonly next = new Vector3(); // of a ball, while its place is found
  private size = { width: 0, height: 0 }; // CSS pixels
  private drawn = { width: 0, height: 0, ratio: 0 }; // of the drawing buffer
  cells: Cell[] = [];
  columns = 1;

  constructor(readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.shadowMap.enabled = true;
    this.camera.up.set(0, 0, 1);
    this.ground = new Mesh(new CircleGeometry(30, 64), new MeshStandardMaterial({ roughness: 1 }));
    this.shadow = new Mesh(new CircleGeometry(30, 64), new ShadowMaterial({ opacity: 0.22 }));
    this.shadow.receiveShadow = true;
    this.shadow.position.z = 0.002;
    const leather = new MeshStandardMaterial({ roughness: 0.5 });
    this.balls = Array.from({ length: kMostBalls }, () => new Mesh<BufferGeometry, MeshStandardMaterial>(this.sphere, leather));
    for (const ball of this.balls) ball.castShadow = true;
    this.sun.position.set(3, 2.5, 6);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(1024, 1024);
    this.sun.shadow.radius = 4;
    this.scene.add(
      new HemisphereLight(0xffffff, 0x9aa4b0, 1.1),
      new AmbientLight(0xffffff, 0.35),
      this.sun,
      this.ground,
      this.shadow,
      ...this.balls,
      this.aim,
      this.overlay,
    );
    this.aim.frustumCulled = false;
    this.aim.visible = false;
  }

  paint(palette: Palette): void {
    this.scene.background = new Color(palette.fog);
    this.scene.fog = this.fog;
    this.fog.color.set(palette.fog);
    this.ground.material.color.set(palette.ground);
    this.balls[0]!.material.color.set(palette.ball);
    this.trailMaterial.color.set(palette.ball);
    this.aim.material.color.set(palette.ball);
    this.scene.remove(this.grid);
    this.grid.dispose();
    this.grid = new GridHelper(24, 24, palette.grid, palette.grid);
    this.grid.rotation.x = Math.PI / 2;
    this.grid.position.z = 0.001;
    this.scene.add(this.grid);
  }

  /** Replaces what the cells show, which moves within `reach` m of the origin. */
  setCells(cells: Cell[], columns: number, reach = kLit): void {
    const frustum = this.sun.shadow.camera;
    frustum.left = frustum.bottom = -reach;
    frustum.right = frustum.top = reach;
    frustum.updateProjectionMatrix();
    for (const { figure } of this.cells) this.scene.remove(figure.mesh);
    for (const trail of this.trails.splice(0)) {
      this.scene.remove(trail.line);
      trail.dispose();
    }
    this.cells = cells;
    this.columns = columns;
    for (const { figure, recording } of cells) {
      const trail = new Trail(recording, this.trailMaterial);
      this.trails.push(trail);
      this.scene.add(figure.mesh, trail.line);
    }
  }

  /** Puts the camera around the figure: degrees, degrees, metres. */
  look([azimuth, elevation, distance]: readonly [number, number, number]): void {
    const turn = (azimuth * Math.PI) / 180;
    const rise = (elevation * Math.PI) / 180;
    const target = new Vector3(0, 0, 0.95);
    const level = Math.cos(rise) * distance;
    this.camera.position
      .set(Math.cos(turn) * level, Math.sin(turn) * level, Math.sin(rise) * distance)
      .add(target);
    this.camera.position.z = Math.max(this.camera.position.z, 0.1);
    this.camera.lookAt(target);
    this.fog.near = distance + kClear;
    this.fog.far = this.fog.near + kMist;
  }

  /** Shows the path of a throw that is being aimed; none for no points. */
  showAim(points: readonly Vector3[]): void {
    this.aim.visible = points.length > 1;
    if (!this.aim.visible) return;
    this.aim.geometry.dispose();
    this.aim.geometry = new BufferGeometry().setFromPoints([...points]);
  }

  /** Lines over the figures: the support polygon and the like. */
  showOverlay(lines: readonly OverlayLine[]): void {
    for (const line of this.overlay.children as Line[]) line.geometry.dispose();
    this.overlay.clear();
    for (const { points, colour } of lines)
      this.overlay.add(
        new Line(
          new BufferGeometry().setFromPoints(points),
          new LineBasicMaterial({ color: colour, depthTest: false, transparent: true }),
        ),
      );
  }

  /** Where a point of the canvas (CSS pixels) meets a figure. */
  pick(x: number, y: number): Vector3 | null {
    const [cell, local] = this.cellAt(x, y);
    if (!cell) return null;
    this.raycaster.setFromCamera(local, this.camera);
    return this.raycaster.intersectObject(cell.figure.mesh, true)[0]?.point ?? null;
  }

  /** The canvas has this size now, CSS pixels. To read it of the canvas for every frame would make the
   * browser lay the page out within the script. */
  resize(width: number, height: number): void {
    this.size = { width, height };
  }

  get isNarrow(): boolean {
    return this.size.width < this.size.height;
  }

  /** Draws all cells at this time of the playback. */
  draw(time: number): void {
    const { width, height } = this.size;
    if (width === 0 || height === 0) return;
    this.fitBuffer();
    this.renderer.setScissorTest(true);
    const [across, down] = [width / this.columns, height / this.rows];
    this.camera.aspect = across / down;
    this.camera.fov = this.camera.aspect < 0.8 ? 46 : 38;
    // Several figures stand higher in their cells, above their captions.
    const shift = this.cells.length > 1 ? kShift * down : 0;
    this.camera.setViewOffset(across, down, 0, shift, across, down);
    this.cells.forEach((_, i) => {
      const left = (i % this.columns) * across;
      const bottom = height - (Math.floor(i / this.columns) + 1) * down;
      this.renderer.setViewport(left, bottom, across, down);
      this.renderer.setScissor(left, bottom, across, down);
      this.prepare(i, time);
      this.renderer.render(this.scene, this.camera);
    });
  }

  /** Gives the drawing buffer the canvas's size. */
  private fitBuffer(): void {
    const { width, height } = this.size;
    const ratio = Math.min(window.devicePixelRatio, 2);
    const { drawn } = this;
    if (drawn.width === width && drawn.height === height && drawn.ratio === ratio) return;
    this.drawn = { width, height, ratio };
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
  }

  private get rows(): number {
    return Math.max(1, Math.ceil(this.cells.length / this.columns));
  }

  private cellAt(x: number, y: number): [Cell | undefined, Vector2] {
    const across = this.size.width / this.columns;
    const down = this.size.height / this.rows;
    const [column, row] = [Math.floor(x / across), Math.floor(y / down)];
    const local = new Vector2(
      2 * (x / across - column) - 1,
      1 - 2 * (y / down - row),
    );
    return [this.cells[row * this.columns + column], local];
  }

  /** Makes the scene that of one cell. */
  private prepare(index: number, time: number): void {
    this.cells.forEach(({ figure }, i) => {
      figure.mesh.visible = i === index;
      this.trails[i]!.line.visible = i === index;
    });
    const { recording, figure } = this.cells[index]!;
    const { from, to, share, number } = recording.at(time);
    figure.show(from.joints, to.joints, share);
    figure.glow(to.impulses);
    this.drawBalls(from, to, share);
    const trail = this.trails[index]!;
    const latest = from.balls.at(-1);
    if (latest) trail.show(latest.id, number, this.balls[0]!.position);
    else trail.line.visible = false;
  }

  /** Gives a ball's mesh the shape of a sphere or, along its axis, of a rod. */
  private shape(mesh: Mesh, { rod, radius }: Ball): void {
    if (!rod) {
      mesh.geometry = this.sphere;
      return;
    }
    const length = (2 * rod.half_length) / radius;
    if (this.rod?.parameters.length !== length) {
      this.rod?.dispose();
      this.rod = new CapsuleGeometry(1, length, 8, 24);
    }
    mesh.geometry = this.rod;
    mesh.quaternion.setFromUnitVectors(kAlongRod, this.next.fromArray(rod.axis));
  }

  private drawBalls(from: Frame, to: Frame, share: number): void {
    this.balls.forEach((mesh, i) => {
      const ball = from.balls[from.balls.length - 1 - i]; // the latest first
      mesh.visible = ball !== undefined;
      if (!ball) return;
      const next = to.balls.find(({ id }) => id === ball.id) ?? ball;
      mesh.scale.setScalar(ball.radius);
      this.shape(mesh, ball);
      mesh.position.fromArray(ball.position).lerp(this.next.fromArray(next.position), share);
    });
  }
}

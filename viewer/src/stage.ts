// SPDX-License-Identifier: MIT
// The drawing: ground, light, shadow, one cell for each figure, all seen by one camera.
import {
  AmbientLight,
  BufferAttribute,
  BufferGeometry,
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
import { Figure } from "./figure";
import { kRate, type Ball, type Frame, type Recording } from "./recording";

const kMostBalls = 3;
const kShift = 0.1; // of a cell's height
const kMostTrail = 4 * kRate; // frames

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
  figure: Figure;
}

export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(38, 1, 0.05, 60);
  private readonly renderer: WebGLRenderer;
  private readonly sun = new DirectionalLight(0xffffff, 2.4);
  private readonly ground: Mesh<CircleGeometry, MeshStandardMaterial>;
  private readonly shadow: Mesh<CircleGeometry, ShadowMaterial>;
  private readonly balls: Mesh<SphereGeometry, MeshStandardMaterial>[];
  private readonly trail = new Line(new BufferGeometry(), new LineBasicMaterial());
  private readonly aim = new Line(new BufferGeometry(), new LineBasicMaterial());
  private readonly overlay = new Group();
  private grid = new GridHelper(24, 24);
  private readonly raycaster = new Raycaster();
  cells: Cell[] = [];
  columns = 1;

  constructor(readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.shadowMap.enabled = true;
    this.camera.up.set(0, 0, 1);
    this.ground = new Mesh(new CircleGeometry(30, 64), new MeshStandardMaterial({ roughness: 1 }));
    this.shadow = new Mesh(new CircleGeometry(30, 64), new ShadowMaterial({ opacity: 0.22 }));
    this.shadow.receiveShadow = true;
    this.shadow.position.z = 0.002;
    const sphere = new SphereGeometry(1, 32, 20);
    const leather = new MeshStandardMaterial({ roughness: 0.5 });
    this.balls = Array.from({ length: kMostBalls }, () => new Mesh(sphere, leather));
    for (const ball of this.balls) ball.castShadow = true;
    this.sun.position.set(3, 2.5, 6);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(1024, 1024);
    this.sun.shadow.radius = 4;
    const frustum = this.sun.shadow.camera;
    frustum.left = frustum.bottom = -2.5;
    frustum.right = frustum.top = 2.5;
    this.scene.add(
      new HemisphereLight(0xffffff, 0x9aa4b0, 1.1),
      new AmbientLight(0xffffff, 0.35),
      this.sun,
      this.ground,
      this.shadow,
      ...this.balls,
      this.trail,
      this.aim,
      this.overlay,
    );
    this.trail.geometry.setAttribute(
      "position",
      new BufferAttribute(new Float32Array(3 * (kMostTrail + 1)), 3),
    );
    this.trail.frustumCulled = this.aim.frustumCulled = false;
    this.aim.visible = false;
  }

  paint(palette: Palette): void {
    this.scene.background = new Color(palette.fog);
    this.scene.fog = new Fog(palette.fog, 8, 22);
    this.ground.material.color.set(palette.ground);
    this.balls[0]!.material.color.set(palette.ball);
    this.trail.material.color.set(palette.ball);
    this.aim.material.color.set(palette.ball);
    this.scene.remove(this.grid);
    this.grid.dispose();
    this.grid = new GridHelper(24, 24, palette.grid, palette.grid);
    this.grid.rotation.x = Math.PI / 2;
    this.grid.position.z = 0.001;
    this.scene.add(this.grid);
  }

  /** Replaces what the cells show. */
  setCells(cells: Cell[], columns: number): void {
    for (const { figure } of this.cells) this.scene.remove(figure.mesh);
    this.cells = cells;
    this.columns = columns;
    for (const { figure } of cells) this.scene.add(figure.mesh);
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
  }

  /** Shows the path of a throw that is being aimed; none for no points. */
  showAim(points: readonly Vector3[]): void {
    this.aim.visible = points.length > 1;
    if (!this.aim.visible) return;
    this.aim.geometry.dispose();
    this.aim.geometry = new BufferGeometry().setFromPoints([...points]);
  }

  /** Lines over the figures: the support polygon and the like. */
  showOverlay(lines: { points: Vector3[]; colour: number }[]): void {
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

  /** Draws all cells at this time of the playback. */
  draw(time: number): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    const ratio = Math.min(window.devicePixelRatio, 2);
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
    const size = this.renderer.getSize(new Vector2());
    if (size.x !== width || size.y !== height) this.renderer.setSize(width, height, false);
    this.renderer.setScissorTest(true);
    const [across, down] = [width / this.columns, height / this.rows];
    this.camera.aspect = across / down;
    this.camera.fov = this.camera.aspect < 0.8 ? 46 : 38;
    // Several figures stand higher in their cells, above their captions.
    const shift = this.cells.length > 1 ? kShift * down : 0;
    this.camera.setViewOffset(across, down, 0, shift, across, down);
    this.camera.updateProjectionMatrix();
    this.cells.forEach((cell, i) => {
      const left = (i % this.columns) * across;
      const bottom = height - (Math.floor(i / this.columns) + 1) * down;
      this.renderer.setViewport(left, bottom, across, down);
      this.renderer.setScissor(left, bottom, across, down);
      this.prepare(cell, time);
      this.renderer.render(this.scene, this.camera);
    });
  }

  private get rows(): number {
    return Math.max(1, Math.ceil(this.cells.length / this.columns));
  }

  private cellAt(x: number, y: number): [Cell | undefined, Vector2] {
    const across = this.canvas.clientWidth / this.columns;
    const down = this.canvas.clientHeight / this.rows;
    const [column, row] = [Math.floor(x / across), Math.floor(y / down)];
    const local = new Vector2(
      2 * (x / across - column) - 1,
      1 - 2 * (y / down - row),
    );
    return [this.cells[row * this.columns + column], local];
  }

  private prepare({ recording, figure }: Cell, time: number): void {
    for (const other of this.cells) other.figure.mesh.visible = other.figure === figure;
    const { from, to, share } = recording.at(time);
    figure.show(from.joints, to.joints, share);
    figure.glow(to.impulses);
    this.drawBalls(from, to, share);
    this.drawTrail(recording, from, time);
  }

  private drawBalls(from: Frame, to: Frame, share: number): void {
    this.balls.forEach((mesh, i) => {
      const ball = from.balls[from.balls.length - 1 - i]; // the latest first
      mesh.visible = ball !== undefined;
      if (!ball) return;
      const next = to.balls.find(({ id }) => id === ball.id) ?? ball;
      mesh.scale.setScalar(ball.radius);
      mesh.position.fromArray(ball.position).lerp(new Vector3(...next.position), share);
    });
  }

  /** The latest ball's path so far. */
  private drawTrail({ frames }: Recording, { balls }: Frame, time: number): void {
    const latest = balls.at(-1);
    this.trail.visible = latest !== undefined;
    if (!latest) return;
    const isLatest = ({ id }: Ball) => id === latest.id;
    const path = this.trail.geometry.attributes.position as BufferAttribute;
    let points = 0;
    path.setXYZ(points++, ...this.balls[0]!.position.toArray());
    for (let i = Math.floor(Math.max(time, 0) * kRate); i >= 0 && points < kMostTrail; --i) {
      const ball = frames[i]!.balls.find(isLatest);
      if (!ball) break;
      path.setXYZ(points++, ...ball.position);
    }
    path.needsUpdate = true;
    this.trail.geometry.setDrawRange(0, points);
  }
}

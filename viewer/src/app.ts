// SPDX-License-Identifier: MIT
// The page: what is shown, and what changes it.
import type { Flinch, ThreatKind } from "flinch";
import { connectAim } from "./aim";
import { showCaption, showCaptions } from "./captions";
import { beforeThrow, choose, choosersOf, loadSelector, type Chooser, type Conditions, type Selector } from "./chooser";
import { ClipEditor } from "./clip_editor";
import { ClipRecording } from "./clip_recording";
import { CrowdFigures } from "./crowd_figures";
import { CrowdRecording } from "./crowd_recording";
import { button, byId } from "./dom";
import { Figure, type Drawn } from "./figure";
import { shortName } from "./files";
import { LabelMode } from "./label_mode";
import { LabelRecording } from "./label_recording";
import { cameraOf, kDefaultView, linkOf, viewOf, type Mode, type View } from "./link";
import { showMessage } from "./message";
import { overlayOf } from "./overlay";
import { connectPage } from "./page_events";
import { Panel } from "./panel";
import { Player } from "./player";
import type { Ring } from "./petals";
import type { Recording } from "./recording";
import { drawRose } from "./rose";
import { SimulationService } from "./simulation_service";
import { kPalettes, Stage } from "./stage";
import { drawStandings } from "./standings";
import { StudyMode } from "./study_mode";
import { Take } from "./take";
import { kDefaultThrow, randomNumbers, randomThrow, threatOf, type Throw } from "./throw";
import { Volley } from "./volley";
import { whyThisClip } from "./why";
import type { SelectorFile } from "./worker";

const kModeNames: Record<Mode, string> = {
  one: "Throw",
  compare: "Compare",
  volley: "Machine gun",
  crowd: "Crowd",
  clips: "Clips",
  rose: "Rose",
  tournament: "Tournament",
  label: "Label",
  study: "Recording?",
};
const kColours = [0x3f6fb5, 0x2f8f6b, 0x8a5bb0, 0xb5803a, 0xb04a5a, 0x557085, 0x7a7f88];
const kMostCompared = 6;
const kMostBytes = 64 * 1024 * 1024;
const kTournamentThrows = 200;

export class App {
  readonly stage = new Stage(byId<HTMLCanvasElement>("canvas"));
  readonly player = new Player(() => this.changed());
  readonly panel: Panel;
  view: View = structuredClone(kDefaultView);
  selectors: Selector[] = [];
  choosers: Chooser[] = [];
  takes: Take[] = []; // of the throw that is shown, one for each figure
  alone: Volley | CrowdRecording | ClipRecording | LabelRecording | null = null; // what is shown instead
  service: SimulationService | null = null;
  /** Times of the last frames that were drawn: script time, ms. */
  readonly frame_ms: number[] = [];
  private files: SelectorFile[] = [];
  private readonly figures = new Map<Chooser, Figure>();
  crowdFigures: CrowdFigures | null = null; // made once
  private tournament: SimulationService | null = null; // while one is shown
  private isStale = true; // something is to be drawn
  private linkTimer = 0;
  private shown = 0; // counts throws, so that late answers of the oracle are dropped
  private whyTimer = 0;
  private rose: { of: string; rings: Ring[] } | null = null; // the last that was asked for
  private readonly clips = new ClipEditor({
    chosen: (clip) => {
      this.set({ clip });
      this.player.start();
    },
    seek: (time) => {
      this.player.pause();
      this.player.seek(time);
    },
  });
  private readonly judged = {
    shown: (recording: LabelRecording) => {
      this.showAlone(recording, this.figureOf(this.choosers[0]!));
      this.player.start();
    },
  };
  private readonly judging = { label: new LabelMode(this.judged), study: new StudyMode(this.judged) };
  private readonly isStill = matchMedia("(prefers-reduced-motion: reduce)");

  constructor(
    private readonly flinch: Flinch,
    private readonly module: WebAssembly.Module,
  ) {
    const acts = {
      thrown: () => this.throwBall(),
      set: (change: Partial<View>) => this.set(change),
      random: () => this.throwRandom(),
      disagreeing: () => this.throwDisagreeing(),
      files: (files: Iterable<File>) => void this.openFiles(files),
      redraw: () => this.showPage(),
    };
    this.panel = new Panel(acts, this.clips, this.judging);
    byId("transport").append(...this.player.root);
    for (const [mode, name] of Object.entries(kModeNames) as [Mode, string][]) {
      const made = button(name, () => this.showMode(mode));
      made.dataset.mode = mode;
      byId("modes").append(made);
    }
    connectAim(this.stage, {
      view: () => this.view,
      canAim: () => this.takes.length > 0,
      turned: (camera) => this.set({ camera }),
      aimed: (thrown) => this.aim(thrown),
      thrown: (thrown) => {
        this.view.thrown = thrown;
        this.throwBall();
      },
    });
    connectPage(
      {
        painted: (scheme) => {
          this.stage.paint(kPalettes[scheme]);
          this.isStale = true;
        },
        resized: (width, height) => {
          this.stage.resize(width, height);
          if (this.takes.length > 0) this.showCells();
          this.isStale = true;
        },
        linked: () => {
          if (location.hash !== linkOf(this.view)) this.restore();
        },
        files: (files) => void this.openFiles(files),
        pressed: (event) => this.judgingNow?.pressed(event) ?? false,
      },
      this.keys,
    );
  }

  /** Adds a selector from its file; throws FlinchError where it cannot be used. */
  addSelector(file: SelectorFile): void {
    try {
      const name = shortName(file.name);
      this.selectors.push(loadSelector(this.flinch, name, file.bytes));
      this.files.push({ name, bytes: file.bytes });
    } catch (error) {
      throw new Error(`${file.name}: ${(error as Error).message}`);
    }
    this.choosers = choosersOf(this.selectors);
    for (const figure of this.figures.values()) figure.dispose();
    this.figures.clear();
    this.crowdFigures?.dispose();
    this.crowdFigures = null;
    this.stage.setCells([], 1);
    this.service?.stop();
    this.service = null;
    this.rose = null;
  }

  start(): void {
    this.restore();
    requestAnimationFrame((now) => this.frame(now));
    if (this.selectors.length === 0)
      showMessage("Drop selector files (.flinch) onto the page, or make it with them: flinch view.");
  }

  /** Shows what the link says. */
  private restore(): void {
    const stances = this.selectors[0]?.library.stances.length ?? 1;
    this.view = viewOf(location.hash, this.choosers.length, this.clipCount, stances);
    this.player.setPace(this.view.pace);
    this.player.time = this.view.time;
    this.showPage();
    this.player.isPlaying = false;
    this.player.seek(this.view.time);
  }

  private get clipCount(): number {
    return this.selectors[0]?.library.clips.length ?? 0;
  }

  get conditions(): Conditions {
    const { thrown, delay, stance } = this.view;
    const threat = threatOf(thrown, this.kinds);
    return { threat, delay, stance, time: thrown.time, brawn: this.brawn };
  }

  /** What the first selector was trained for. */
  private get kinds(): readonly ThreatKind[] {
    return this.selectors[0]?.library.kinds ?? [];
  }

  /** How costs are weighed: as the first selector was trained, unless the visitor says otherwise. */
  get brawn(): number {
    const own = this.selectors[0]?.oracle.costs().brawn ?? 0.5;
    return this.view.brawn < 0 ? own : this.view.brawn;
  }

  /** Changes what is shown, without throwing. */
  set(change: Partial<View>): void {
    const isOnlyCamera = Object.keys(change).every((key) => key === "camera");
    Object.assign(this.view, change);
    if (isOnlyCamera) this.stage.look(this.view.camera);
    else this.showPage();
    this.changed();
  }

  /** Goes over to another view. A crowd is seen from farther away. */
  private showMode(mode: Mode): void {
    const { mode: before, camera } = this.view;
    const isAlike = (mode === "crowd") === (before === "crowd");
    this.set({ mode, camera: isAlike ? camera : cameraOf(mode) });
    if (mode === "crowd" && !this.isStill.matches) this.player.start();
  }

  throwBall(): void {
    byId("hint").hidden = true;
    if (!["one", "compare", "volley"].includes(this.view.mode)) this.view.mode = "one";
    this.showPage();
    if (this.isStill.matches) this.player.seek(Math.max(this.view.thrown.time - 0.05, 0));
    else this.player.start();
  }

  throwRandom(): void {
    this.view.seed = (this.view.seed + 1) >>> 0;
    if (this.view.mode === "crowd") {
      this.showMode("crowd");
      return;
    }
    this.view.thrown = randomThrow(randomNumbers(this.view.seed));
    this.throwBall();
  }

  /** Throws the next seeded ball on which the selectors choose different clips. */
  throwDisagreeing(): void {
    const asked = this.choosers.filter(({ kind }) => kind === "selector" || kind === "ahead");
    for (let tries = 0; tries < 300; ++tries) {
      this.view.seed = (this.view.seed + 1) >>> 0;
      const thrown = randomThrow(randomNumbers(this.view.seed));
      const conditions = { ...this.conditions, threat: threatOf(thrown), time: thrown.time };
      const names = asked.map((chooser) => {
        const { selector } = chooser;
        const clip = choose(chooser, beforeThrow(selector, conditions), conditions.threat);
        return selector.library.clips[clip]!.name;
      });
      if (new Set(names).size < 2) continue;
      this.view.thrown = thrown;
      this.throwBall();
      return;
    }
    showMessage("No disagreement in 300 throws.");
  }

  async openFiles(files: Iterable<File>): Promise<void> {
    for (const file of files) {
      try {
        if (file.size > kMostBytes) throw new Error(`${file.name} is larger than 64 MiB.`);
        byId("message").hidden = true;
        this.addSelector({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) });
      } catch (error) {
        showMessage(error);
      }
    }
    this.showPage();
  }

  /** What keys do. */
  private get keys(): Record<string, () => void> {
    const turn = (by: number) => {
      const [azimuth, elevation, distance] = this.view.camera;
      this.set({ camera: [azimuth + by, elevation, distance] });
    };
    const scrub = (by: number) => {
      this.player.pause();
      this.player.seek(this.player.time + by);
    };
    return {
      " ": () => this.player.toggle(),
      ArrowLeft: () => scrub(-1 / 30),
      ArrowRight: () => scrub(1 / 30),
      a: () => turn(-5),
      d: () => turn(5),
      t: () => this.throwBall(),
      n: () => this.throwRandom(),
      x: () => this.throwDisagreeing(),
    };
  }

  /** While dragging: the throw is shown, not simulated. */
  private aim(thrown: Throw): void {
    this.view.thrown = thrown;
    this.panel.show(this.view, this.choosers, this.brawn);
    this.isStale = true;
  }

  /** Makes everything anew for the view. */
  private showPage(): void {
    const { mode, figure, camera } = this.view;
    document.body.className = mode;
    for (const made of byId("modes").querySelectorAll("button")) {
      made.ariaPressed = String(made.dataset.mode === mode);
      if (made.dataset.mode === mode) made.scrollIntoView({ block: "nearest", inline: "nearest" });
    }
    const isStaged = mode !== "rose" && mode !== "tournament";
    byId("stage").hidden = !isStaged;
    byId("transport").hidden = !isStaged;
    byId("full").hidden = isStaged;
    byId("timeline").hidden = mode !== "clips";
    this.panel.show(this.view, this.choosers, this.brawn);
    this.tournament?.stop();
    this.tournament = null;
    if (this.choosers.length === 0) return;
    if (!isStaged) {
      this.showFull();
      return;
    }
    const chooser = this.choosers[figure]!;
    this.alone?.free();
    this.alone = null;
    if (mode === "volley") {
      const { seed, delay, thrown } = this.view;
      const size = thrown.radius / kDefaultThrow.radius;
      const mass = thrown.mass / kDefaultThrow.mass;
      const volley = new Volley(chooser, { seed, delay, brawn: this.brawn, size, mass });
      this.showAlone(volley, this.figureOf(chooser));
    } else if (mode === "crowd") {
      this.showCrowd();
    } else if (mode === "clips") {
      const [first] = this.choosers as [Chooser];
      const { library } = first.selector;
      this.clips.show(library, this.view.clip);
      this.showAlone(new ClipRecording(library, this.view.clip), this.figureOf(first));
    } else if (this.judgingNow) {
      this.showJudging(this.judgingNow);
    } else {
      this.showTakes(mode === "one" ? [chooser] : this.choosers.slice(0, kMostCompared));
    }
    this.stage.look(camera);
  }

  /** What the judge of pushed motions works with, if anything. */
  private get judgingNow(): LabelMode | StudyMode | null {
    const { mode } = this.view;
    return mode === "label" || mode === "study" ? this.judging[mode] : null;
  }

  /** Shows motions of the first selector's library to a judge. */
  private showJudging(judging: LabelMode | StudyMode): void {
    try {
      judging.show(this.choosers[0]!.selector.library);
    } catch (error) {
      showMessage(error);
    }
  }

  /** Shows a crowd of the first selector's library. */
  private showCrowd(): void {
    try {
      const recording = new CrowdRecording(this.choosers[0]!.selector.library, this.view.seed);
      const { characters, half_side_m } = recording.stateAt(0);
      this.crowdFigures ??= new CrowdFigures(recording.library, characters, half_side_m);
      this.showAlone(recording, this.crowdFigures, Math.SQRT2 * half_side_m);
    } catch (error) {
      showMessage(error);
    }
  }

  /** What the cells show. */
  private get recordings(): readonly Recording[] {
    return this.alone ? [this.alone] : this.takes;
  }

  /** Shows what answers no single throw. */
  private showAlone(recording: NonNullable<App["alone"]>, drawn: Drawn, reach?: number): void {
    ++this.shown;
    for (const take of this.takes) take.free();
    this.takes = [];
    this.alone = recording;
    this.player.setDuration(recording.duration);
    this.stage.setCells([{ recording, figure: drawn }], 1, reach);
    this.panel.showWhy(null);
    this.isStale = true;
  }

  private showTakes(shown: readonly Chooser[]): void {
    const throwNumber = ++this.shown;
    for (const take of this.takes) take.free();
    const { idle_clip } = shown[0]!.selector.library.info;
    this.takes = shown.map(
      (chooser) =>
        new Take(chooser, this.conditions, chooser.kind === "oracle" ? idle_clip : undefined),
    );
    this.player.setDuration(this.takes[0]!.duration);
    this.showCells();
    const oracle = shown.findIndex(({ kind }) => kind === "oracle");
    if (oracle < 0) return;
    this.workers().ask(this.conditions, (best) => {
      if (throwNumber !== this.shown || !best) return;
      this.takes[oracle]!.free();
      this.takes[oracle] = new Take(shown[oracle]!, this.conditions, best.clip);
      this.showCells();
    });
  }

  private showCells(): void {
    const count = this.takes.length;
    const columns = count === 1 ? 1 : this.stage.isNarrow ? 2 : 3;
    this.stage.setCells(
      this.takes.map((take) => ({ recording: take, figure: this.figureOf(take.chooser) })),
      columns,
    );
    showCaptions(byId("captions"), this.takes, columns, this.brawn);
    clearTimeout(this.whyTimer);
    this.whyTimer = window.setTimeout(() => this.showWhy(), 60);
    this.isStale = true;
  }

  /** The figure of a chooser, made once. */
  private figureOf(chooser: Chooser): Figure {
    let figure = this.figures.get(chooser);
    if (!figure) {
      figure = new Figure(chooser.selector.library, kColours[this.choosers.indexOf(chooser)]!);
      this.figures.set(chooser, figure);
    }
    return figure;
  }

  private showWhy(): void {
    const [take] = this.takes;
    if (this.view.mode === "one" && take)
      this.panel.showWhy(whyThisClip(this.flinch, take, this.conditions));
    else this.panel.showWhy(null);
  }

  private showFull(): void {
    this.panel.showWhy(null);
    if (this.view.mode === "rose") {
      this.showRose();
      return;
    }
    const root = byId("full");
    const { brawn } = this;
    root.replaceChildren();
    this.tournament = new SimulationService(this.module, this.files);
    this.tournament.play(
      { seed: this.view.seed, throws: kTournamentThrows, brawn },
      (standings, count) => drawStandings(root, standings, count),
    );
  }

  /** Asks for the rose unless it is the last one, and shows what is known of it. */
  private showRose(): void {
    const { figure, thrown: base, delay } = this.view;
    const conditions = { base, delay, brawn: this.brawn };
    const { speed, time, radius, mass, from_height } = base;
    const of = JSON.stringify([figure, speed, time, radius, mass, from_height, delay, this.brawn]);
    if (this.rose?.of !== of) {
      const rose = { of, rings: [] as Ring[] };
      this.rose = rose;
      this.workers().pick(figure, conditions, (ring) => {
        rose.rings.push(ring);
        if (this.view.mode === "rose" && this.rose === rose) this.drawRose();
      });
    }
    this.drawRose();
  }

  private drawRose(): void {
    const { name } = this.choosers[this.view.figure]!;
    drawRose(byId("full"), name, this.rose!.rings, this.panel.roseColours, (one) => {
      this.view.thrown = one;
      this.throwBall();
    });
  }

  private workers(): SimulationService {
    this.service ??= new SimulationService(this.module, this.files);
    return this.service;
  }

  private changed(): void {
    this.isStale = true;
    this.view.time = this.player.time;
    this.view.pace = this.player.pace;
    clearTimeout(this.linkTimer);
    this.linkTimer = window.setTimeout(() => history.replaceState(null, "", linkOf(this.view)), 150);
  }

  private frame(now: number): void {
    const begin = performance.now();
    const isMoving = this.player.tick(now);
    if ((isMoving || this.isStale) && this.recordings.length > 0 && !byId("stage").hidden) {
      this.isStale = false;
      this.showOverlay();
      this.stage.draw(this.player.time);
      this.showAloneCaption();
      this.frame_ms.push(performance.now() - begin);
      if (this.frame_ms.length > 600) this.frame_ms.shift();
    }
    requestAnimationFrame((next) => this.frame(next));
  }

  private showAloneCaption(): void {
    const { alone } = this;
    const { time } = this.player;
    if (alone instanceof Volley) {
      showCaption(byId("captions"), alone.chooser.name, alone.summary(time));
    } else if (alone instanceof CrowdRecording) {
      showCaption(byId("captions"), `Crowd ${alone.seed}`, alone.summary(time));
    } else if (alone instanceof LabelRecording) {
      byId("captions").replaceChildren();
    } else if (alone) {
      this.clips.showTime(time);
      const { name } = alone.library.clips[alone.clip]!;
      showCaption(byId("captions"), name.replaceAll("_", " "), `${time.toFixed(2)} s`);
    }
  }

  private showOverlay(): void {
    const [take] = this.takes;
    if (this.alone instanceof LabelRecording) {
      const points = this.alone.arrowAt(this.player.time);
      this.stage.showOverlay(points.length > 0 ? [{ points, colour: 0xd0504a }] : []);
      return;
    }
    if (this.alone instanceof CrowdRecording)
      this.crowdFigures!.showPushes(this.alone, this.player.time);
    const isWanted = take && this.view.mode === "one" && this.panel.showsOverlay;
    this.stage.showOverlay(isWanted ? overlayOf(take, this.player.time) : []);
  }
}

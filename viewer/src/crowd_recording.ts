// SPDX-License-Identifier: MIT
// Twenty characters that walk about in a square and push each other (Arikan, Forsyth and O'Brien
// 2005, figure 7): what examples/crowd.cpp records.
import type { Crowd, CrowdPush, CrowdState, JointFrames, Library } from "flinch";
import { kRate, Recording } from "./recording";

const kDuration = 60; // s
const kShown = 0.6; // s that the arrow of a push is seen

/** A push, and since when it is seen, s. */
export interface TimedPush extends CrowdPush {
  time: number;
}

export class CrowdRecording extends Recording {
  readonly pushes: TimedPush[] = []; // by time
  private readonly states: CrowdState[] = []; // one per frame
  private readonly crowd: Crowd;
  private readonly untouched = new Float32Array(0);

  constructor(
    readonly library: Library,
    readonly seed: number,
  ) {
    super(kDuration);
    this.crowd = library.createCrowd(seed);
    this.record();
  }

  /** How many there are, in which square, and what has happened up to a time. */
  stateAt(time: number): CrowdState {
    return this.states[this.at(time).number]!;
  }

  /** In words, what has happened up to a time. */
  summary(time: number): string {
    const { bumps, walls, answered, physical, knocked_over } = this.stateAt(time);
    return `${bumps} bumps, ${walls} touches of a wall; ${answered} pushes answered by recordings, ${physical} by physics, ${knocked_over} knocked over.`;
  }

  /** The pushes that are seen at a time, and how much of their arrows is still to be seen. */
  pushesAt(time: number): { push: TimedPush; share: number }[] {
    return this.pushes
      .filter((push) => push.time <= time && time < push.time + kShown)
      .map((push) => ({ push, share: Math.min((push.time + kShown - time) / (kShown / 3), 1) }));
  }

  free(): void {
    this.crowd.free();
  }

  protected advance(): void {
    this.crowd.update(1 / kRate);
    const time = this.frames.length / kRate;
    for (const push of this.crowd.pushes()) this.pushes.push({ ...push, time });
    this.record();
  }

  /** The joints of all characters stand in a frame one character after the other. */
  private record(): void {
    const state = this.crowd.state();
    const all = Array.from({ length: state.characters }, (_, i) => this.crowd.jointFrames(i));
    this.states.push(state);
    this.frames.push({ joints: joined(all), balls: [], impulses: this.untouched });
  }
}

function joined(all: readonly JointFrames[]): JointFrames {
  const of = (numbers: (one: JointFrames) => Float32Array) => {
    const length = numbers(all[0]!).length;
    const made = new Float32Array(all.length * length);
    all.forEach((one, i) => made.set(numbers(one), i * length));
    return made;
  };
  return { position: of(({ position }) => position), orientation: of(({ orientation }) => orientation) };
}

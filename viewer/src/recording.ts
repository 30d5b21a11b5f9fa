// SPDX-License-Identifier: MIT
// What a figure does and the balls about it, simulated as far as anyone has looked and kept, so that
// playing, pausing and scrubbing show the same.
import type { JointFrames } from "flinch";
import { kGravity } from "./throw";

export const kRate = 60;
const kRestitution = 0.7; // of balls and ground

export interface Ball {
  id: number; // the same from frame to frame
  position: [number, number, number];
  radius: number;
  rod?: Rod; // drawn out along its axis
}

/** A rod: unit axis, and half of the distance of its round ends. */
export interface Rod {
  axis: [number, number, number];
  half_length: number;
}

export interface Frame {
  joints: JointFrames;
  balls: readonly Ball[]; // the latest last
  impulses: Float32Array; // on each body so far, N s
}

export abstract class Recording {
  readonly frames: Frame[] = [];

  constructor(readonly duration: number) {}

  /** What is shown at `time`: between frame `number` and the next, at a share of the way. */
  at(time: number): { from: Frame; to: Frame; share: number; number: number } {
    const exact = Math.min(Math.max(time, 0), this.duration) * kRate;
    const number = Math.floor(exact);
    while (this.frames.length < number + 2) this.advance();
    return {
      from: this.frames[number]!,
      to: this.frames[number + 1]!,
      share: exact - number,
      number,
    };
  }

  abstract free(): void;
  /** Adds the next frame. */
  protected abstract advance(): void;
}

/** A ball in free flight. */
export interface FlyingBall {
  position: number[];
  velocity: number[];
}

/** Moves a ball by `dt`: free flight, and off the ground. */
export function fly({ position, velocity }: FlyingBall, radius: number, dt: number): void {
  for (let i = 0; i < 3; ++i) position[i]! += velocity[i]! * dt;
  position[2]! -= (kGravity * dt * dt) / 2;
  velocity[2]! -= kGravity * dt;
  if (position[2]! < radius && velocity[2]! < 0) {
    position[2] = 2 * radius - position[2]!;
    velocity[2]! *= -kRestitution;
  }
}

// SPDX-License-Identifier: MIT
// What is drawn over a figure: where it stands, where its weight is, and where the ball would hit.
import { Vector3 } from "three";
import { centreOfMass, supportPolygon } from "./balance";
import type { Take } from "./take";

export interface OverlayLine {
  points: Vector3[];
  colour: number;
}

const kSupport = 0x2f9e6e;
const kWeight = 0xd0504a;
const kContact = 0xd9a21b;
const kOnFloor_m = 0.006;

export function overlayOf(take: Take, time: number): OverlayLine[] {
  const { library } = take.chooser.selector;
  const { joints } = take.at(time).from;
  const centre = centreOfMass(library, joints);
  const lines = [
    { points: supportPolygon(library, joints), colour: kSupport },
    { points: [centre, new Vector3(centre.x, centre.y, kOnFloor_m)], colour: kWeight },
  ];
  for (const points of contactCircles(take)) lines.push({ points, colour: kContact });
  return lines;
}

/** The ball where it would touch the character if that stood still: two great circles, one of them
 * across its way; none if it would miss. */
function contactCircles({ threat, ballAtRestContact: ball }: Take): Vector3[][] {
  if (!ball) return [];
  const centre = new Vector3(...ball.position);
  const along = new Vector3(...ball.velocity).normalize();
  const level = new Vector3(-along.y, along.x, 0).normalize();
  const upright = along.clone().cross(level);
  return [upright, along].map((second) => circle(centre, level, second, threat.radius));
}

function circle(centre: Vector3, first: Vector3, second: Vector3, radius: number): Vector3[] {
  const kParts = 48;
  return Array.from({ length: kParts + 1 }, (_, i) => {
    const angle = (2 * Math.PI * i) / kParts;
    return centre
      .clone()
      .addScaledVector(first, radius * Math.cos(angle))
      .addScaledVector(second, radius * Math.sin(angle));
  });
}

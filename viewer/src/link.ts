// SPDX-License-Identifier: MIT
// What is shown, as the part of the address after #, and back. Whatever a link says, the result is
// something that can be shown.
import { allowed, clamp, kDefaultThrow, type Throw } from "./throw";

export type Mode = "one" | "compare" | "volley" | "crowd" | "clips" | "rose" | "tournament" | "label" | "study";
const kModes: readonly Mode[] = ["one", "compare", "volley", "crowd", "clips", "rose", "tournament", "label", "study"];

export interface View {
  mode: Mode;
  thrown: Throw;
  stance: number; // that the character is in when it perceives the throw
  figure: number; // which chooser is shown alone
  clip: number; // which clip `clips` shows
  brawn: number; // weighs work against damage in what is shown and in the oracle's choice
  delay: number; // of the reaction, s
  time: number; // of the playback, s
  pace: number; // of the playback, seconds per second
  camera: [number, number, number]; // azimuth, elevation (degrees), distance (m)
  seed: number; // of the next throw, the volley, the crowd and the tournament
}

export const kDefaultView: View = {
  mode: "one",
  thrown: kDefaultThrow,
  stance: 0,
  figure: 0,
  clip: 0,
  brawn: -1, // the selector's own
  delay: 0,
  time: 0,
  pace: 1,
  camera: [35, 12, 4.6],
  seed: 1,
};

/** From where a view is seen that was not turned yet. */
export function cameraOf(mode: Mode): View["camera"] {
  return mode === "crowd" ? [20, 33, 14.5] : [...kDefaultView.camera];
}

const rounded = (value: number) => String(Number(value.toFixed(3)));

export function linkOf(view: View): string {
  const { thrown } = view;
  const parts = {
    view: view.mode,
    from: [thrown.azimuth, thrown.from_height].map(rounded).join(","),
    aim: thrown.aim.map(rounded).join(","),
    ball: [thrown.speed, thrown.time, thrown.radius, thrown.mass, thrown.kind].map(rounded).join(","),
    stance: String(view.stance),
    who: String(view.figure),
    clip: String(view.clip),
    brawn: rounded(view.brawn),
    delay: rounded(view.delay),
    t: rounded(view.time),
    pace: rounded(view.pace),
    camera: view.camera.map(rounded).join(","),
    seed: String(view.seed),
  };
  return "#" + Object.entries(parts).map(([key, value]) => `${key}=${value}`).join("&");
}

/** Reads a link for a page with this many choosers, clips and stances. */
export function viewOf(link: string, choosers: number, clips: number, stances: number): View {
  const parts = new Map(
    link
      .replace(/^#/, "")
      .slice(0, 2000)
      .split("&")
      .map((part) => part.split("=") as [string, string]),
  );
  const numbers = (key: string, count: number) => {
    const read = (parts.get(key) ?? "").split(",").map((text) => (text ? Number(text) : NaN));
    return Array.from({ length: count }, (_, i) => read[i] ?? NaN);
  };
  const number = (key: string, fallback: number, low: number, high: number) => {
    const [value] = numbers(key, 1);
    return Number.isFinite(value) ? clamp(value!, [low, high]) : fallback;
  };
  const [azimuth, from_height] = numbers("from", 2) as [number, number];
  const [speed, time, radius, mass, kind] = numbers("ball", 5) as [number, number, number, number, number];
  const [turn, elevation, distance] = numbers("camera", 3) as [number, number, number];
  const named = parts.get("view") as Mode;
  const mode = kModes.includes(named) ? named : kDefaultView.mode;
  const camera = cameraOf(mode);
  if (Number.isFinite(turn)) camera[0] = turn % 360;
  if (Number.isFinite(elevation)) camera[1] = clamp(elevation, [-5, 89]);
  if (Number.isFinite(distance)) camera[2] = clamp(distance, [1, 15]);
  return {
    mode,
    thrown: allowed({
      azimuth,
      from_height,
      aim: numbers("aim", 3) as Throw["aim"],
      speed,
      time,
      radius,
      mass,
      kind,
    }),
    stance: Math.floor(number("stance", 0, 0, Math.max(stances - 1, 0))),
    figure: Math.floor(number("who", 0, 0, Math.max(choosers - 1, 0))),
    clip: Math.floor(number("clip", 0, 0, Math.max(clips - 1, 0))),
    brawn: number("brawn", kDefaultView.brawn, -1, 1),
    delay: number("delay", 0, 0, 0.4),
    time: number("t", 0, 0, 60),
    pace: number("pace", 1, 0.05, 1),
    camera,
    seed: Math.floor(number("seed", 1, 0, 4294967295)),
  };
}

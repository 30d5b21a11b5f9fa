// SPDX-License-Identifier: MIT
// Label files as `flinch label` writes and reads them: a line of JSON that names the library, then
// one line per label (docs/pushing.md).
import type { Library, PushExample } from "flinch";

/** A judgement of one pushed motion. */
export interface Label {
  judge: string;
  sitting: string;
  realism: number;
  example: PushExample;
}

const kFormat = "flinch labels 1";
const kSides: Record<string, string> = {
  left_upper_arm: "left_shoulder",
  right_upper_arm: "right_shoulder",
};

const placeName = (joint: string) => kSides[joint] ?? joint;

export function headerOf(libraryHash: string): string {
  return JSON.stringify({ format: kFormat, library: libraryHash });
}

/** A motion as lines of files name it. */
export function motionOf({ clips, flinch }: Library, example: PushExample) {
  return {
    state: clips[example.state_clip]!.name,
    state_s: example.state_s,
    place: placeName(flinch.joints[example.place]!),
    asked_mps: Array.from(example.asked),
    response: clips[example.response_clip]!.name,
    turn: example.turn,
    taper: example.taper,
    deformation_mps: Array.from(example.deformation),
  };
}

export function lineOf(library: Library, label: Label): string {
  const { judge, sitting, realism, example } = label;
  return JSON.stringify({ judge, sitting, realism, ...motionOf(library, example) });
}

/** The label in a line. Throws Error that says what is wrong with it. */
function labelOf({ clips, flinch }: Library, line: string): Label {
  const read = JSON.parse(line) as Record<string, unknown>;
  const number = (value: unknown) => {
    if (typeof value !== "number" || !Number.isFinite(value)) throw new Error("a number is missing");
    return value;
  };
  const text = (key: string) => {
    const value = read[key];
    if (typeof value !== "string") throw new Error(`"${key}" is missing`);
    return value;
  };
  const vector = (key: string) => {
    const value = read[key];
    if (!Array.isArray(value) || value.length !== 3) throw new Error(`"${key}" is missing`);
    return value.map(number);
  };
  const indexOf = (key: string, names: readonly string[]) => {
    const index = names.indexOf(text(key));
    if (index < 0) throw new Error(`the library has no ${key} "${text(key)}"`);
    return index;
  };
  const names = clips.map(({ name }) => name);
  return {
    judge: text("judge"),
    sitting: text("sitting"),
    realism: number(read.realism),
    example: {
      state_clip: indexOf("state", names),
      state_s: number(read.state_s),
      place: indexOf("place", flinch.joints.map(placeName)),
      asked: vector("asked_mps"),
      response_clip: indexOf("response", names),
      turn: number(read.turn),
      taper: number(read.taper),
      deformation: vector("deformation_mps"),
    },
  };
}

/** The lines of labels of this library, as they stand in a file. Throws Error for another library's
 * and for a file that is cut short or holds anything else. */
export function linesOf(text: string, libraryHash: string): string[] {
  const header = headerOf(libraryHash);
  const lines = text.split("\n");
  if (!lines[0]!.startsWith('{"format":"flinch labels')) throw new Error("this is no label file");
  if (lines[0] !== header) throw new Error("these labels are of another library");
  if (lines.pop() !== "")
    throw new Error(`line ${lines.length + 1} is cut short; delete it, those before it are whole`);
  return lines.filter((line) => line !== header);
}

export function labelsOf(library: Library, lines: readonly string[]): Label[] {
  return lines.map((line, i) => {
    try {
      return labelOf(library, line);
    } catch (error) {
      throw new Error(`label ${i + 1}: ${(error as Error).message}`);
    }
  });
}

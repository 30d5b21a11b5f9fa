// SPDX-License-Identifier: MIT
// Answers as they are kept in the browser: each at once, for every library apart, so that a page
// that is closed loses none.

export class AnswerStore {
  /** Whether the browser keeps what is added; some do not for files of the disk. */
  isKept = true;
  private unkept: string[] = [];

  /** `key` names the kind of answers and the library. */
  constructor(private readonly key: string) {}

  /** All lines: those of earlier sittings, and of other windows. */
  lines(): string[] {
    return [...this.kept(), ...this.unkept];
  }

  /** Says where `count` of them are kept; `what` names them. */
  place(count: number, what: string): string {
    return this.isKept
      ? `${count} ${what}, kept in this browser.`
      : `${count} ${what}. This browser keeps none: save them before you close the page.`;
  }

  /** Adds lines, except for those that are there; returns how many were new. */
  add(lines: readonly string[]): number {
    const known = new Set(this.lines());
    const fresh = lines.filter((line) => !known.has(line));
    try {
      localStorage.setItem(this.key, [...this.kept(), ...fresh].join("\n"));
    } catch {
      this.isKept = false;
      this.unkept.push(...fresh);
    }
    return fresh.length;
  }

  private kept(): string[] {
    try {
      return (localStorage.getItem(this.key) ?? "").split("\n").filter(Boolean);
    } catch {
      this.isKept = false;
      return [];
    }
  }
}

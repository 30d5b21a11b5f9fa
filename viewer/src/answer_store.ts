// SPDX-License-Identifier: MIT
// Answers as they are kept in the browser: each at once, for every library apart, so that a page
// that is closed loses none. Each has a key of its own: windows that answer at the same time would
// write over each other's where all stood under one, since a window sees another's writes late.

export class AnswerStore {
  /** Whether the browser keeps what is added; some do not for files of the disk. */
  isKept = true;
  private unkept: string[] = [];
  private added = 0;
  private readonly window = crypto.getRandomValues(new Uint32Array(2)).join("");

  /** `name` tells the kind of answers and the library. */
  constructor(private readonly name: string) {}

  /** All lines in the order of their times: those of earlier sittings, and of other windows. */
  lines(): string[] {
    return [...this.kept(), ...this.unkept];
  }

  /** Says where `count` of them are kept; `what` names them. */
  place(count: number, what: string): string {
    return this.isKept
      ? `${count} ${what}, kept in this browser.`
      : `${count} ${what}. This browser keeps none: save them before you close the page.`;
  }

  add(line: string): void {
    const order = `${Date.now()} ${String(this.added++).padStart(6, "0")}`;
    try {
      localStorage.setItem(`${this.name} ${order} ${this.window}`, line);
    } catch {
      this.isKept = false;
      this.unkept.push(line);
    }
  }

  private kept(): string[] {
    try {
      const keys = Object.keys(localStorage).filter((key) => key.startsWith(`${this.name} `));
      return keys.sort().map((key) => localStorage.getItem(key) ?? "");
    } catch {
      this.isKept = false;
      return [];
    }
  }
}

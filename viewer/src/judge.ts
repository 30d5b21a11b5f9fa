// SPDX-License-Identifier: MIT
// Who judges: a name that the browser remembers.
import { element } from "./dom";
import { showMessage } from "./message";

const kKey = "flinch judge";

export class Judge {
  private readonly input = element("input", { type: "text", ariaLabel: "Judge", maxLength: 60 });
  readonly root = element("label", { className: "quiet" }, "Judge ", this.input);

  constructor() {
    this.input.placeholder = "your name";
    this.input.onchange = () => {
      try {
        localStorage.setItem(kKey, this.input.value.trim());
      } catch {
        // It is asked for again the next time.
      }
    };
  }

  /** Shows the name that was given last, on any view. */
  show(): void {
    try {
      this.input.value ||= localStorage.getItem(kKey) ?? "";
    } catch {
      // This browser keeps nothing.
    }
  }

  get isTyping(): boolean {
    return document.activeElement === this.input;
  }

  /** The name; none where it is still to be given, which is then asked for. */
  get name(): string | null {
    const name = this.input.value.trim();
    if (name && !name.startsWith("proxy")) return name;
    showMessage("Say first who judges, below; files name every judge.");
    this.input.focus();
    return null;
  }
}

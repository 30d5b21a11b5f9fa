// SPDX-License-Identifier: MIT
import { byId } from "./dom";

/** Tells in one line what went wrong; a click takes it away. */
export function showMessage(error: unknown): void {
  const message = byId("message");
  message.textContent = error instanceof Error ? error.message : String(error);
  message.hidden = false;
  message.onclick = () => {
    message.hidden = true;
  };
}

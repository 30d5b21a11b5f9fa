// SPDX-License-Identifier: MIT
import { loadFlinch } from "flinch";
import { App } from "./app";
import { byId } from "./dom";
import { embeddedModule, embeddedSelectors } from "./files";
import { showMessage } from "./message";
import "./colours.css";
import "./page.css";

async function start(): Promise<void> {
  const module = await embeddedModule();
  const flinch = await loadFlinch(module);
  const app = new App(flinch, module);
  for (const file of embeddedSelectors()) app.addSelector(file);
  app.start();
  // For the tests in a browser, and for the curious.
  Object.assign(window, { flinchPage: app });
}

start().catch((error: unknown) => {
  byId("stage").hidden = true;
  showMessage(error);
});

// SPDX-License-Identifier: MIT
// What the page carries, in base64: flinch.wasm, compressed, and selectors.
import type { SelectorFile } from "./worker";

function bytesOf(element: Element): Uint8Array {
  const text = atob((element.textContent ?? "").trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

function unzipped(bytes: Uint8Array): Promise<ArrayBuffer> {
  const stream = new Blob([bytes as BlobPart]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

export async function embeddedModule(): Promise<WebAssembly.Module> {
  const element = document.getElementById("flinch-wasm");
  if (!element) throw new Error("This page was built without flinch.wasm: build it again with scripts/page.");
  if (typeof WebAssembly === "undefined")
    throw new Error("This browser cannot run WebAssembly, or it is switched off: the page needs it.");
  return WebAssembly.compile(await unzipped(bytesOf(element))).catch((error: Error) => {
    throw new Error(`This browser does not run WebAssembly here: ${error.message}`);
  });
}

export function embeddedSelectors(): SelectorFile[] {
  return [...document.querySelectorAll<HTMLElement>("script[data-selector]")].map((element) => ({
    name: element.dataset.selector!,
    bytes: bytesOf(element),
  }));
}

/** The name of a selector file without its ending. */
export function shortName(file: string): string {
  return file.replace(/^.*[/\\]/, "").replace(/\.flinch$/, "");
}

/** Hands a file of lines to the browser's downloads. */
export function saveFile(name: string, text: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "application/jsonl" }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

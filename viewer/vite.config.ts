// SPDX-License-Identifier: MIT
// One page that needs no server: script, style and flinch.wasm are in it. Its security policy names
// the hashes of the script and the style, so that nothing else runs; selectors are data.
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { defineConfig, type Plugin } from "vite";

const packageFolder = resolve(process.env.FLINCH_PACKAGE ?? "../build/release/bindings/js/flinch");

function onePage(): Plugin {
  const hash = (text: string) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
  return {
    name: "one-page",
    enforce: "post",
    generateBundle(_, bundle) {
      const page = bundle["index.html"];
      if (page?.type !== "asset") throw new Error("no index.html");
      let script = "";
      let style = "";
      for (const [name, part] of Object.entries(bundle)) {
        if (name === "index.html") continue;
        if (part.type === "chunk") script += part.code;
        else if (name.endsWith(".css")) style += String(part.source);
        else if (!name.endsWith(".wasm")) // that of the package, which the page carries as data
          throw new Error(`${name} would be a file beside the page`);
        delete bundle[name];
      }
      script = script.replaceAll("</script", "<\\/script").trim();
      style = style.trim();
      const wasm = readFileSync(resolve(packageFolder, "flinch.wasm")).toString("base64");
      const policy = [
        "default-src 'none'",
        `script-src ${hash(script)} 'wasm-unsafe-eval'`,
        `style-src ${hash(style)}`,
        "worker-src blob:",
        "img-src data:",
        "base-uri 'none'",
        "form-action 'none'",
      ].join("; ");
      page.source = String(page.source)
        .replace(/<script type="module"[^>]*><\/script>/, "")
        .replace(/<link rel="stylesheet"[^>]*>/, "")
        .replace(
          '<meta charset="utf-8" />',
          () =>
            `<meta charset="utf-8" />\n    <meta http-equiv="Content-Security-Policy" content="${policy}" />`,
        )
        .replace("</head>", () => `<style>${style}</style>\n  </head>`)
        .replace(
          "</body>",
          () =>
            `<script id="flinch-wasm" type="application/octet-stream">${wasm}</script>\n` +
            `<!-- selectors -->\n<script type="module">${script}</script>\n  </body>`,
        );
    },
  };
}

export default defineConfig({
  base: "./",
  resolve: { alias: { flinch: resolve(packageFolder, "flinch.js") } },
  build: {
    target: "es2022",
    assetsInlineLimit: 0,
    modulePreload: false,
    outDir: process.env.FLINCH_PAGE_FOLDER ?? "../build/page",
    emptyOutDir: false,
    chunkSizeWarningLimit: 2000,
    rollupOptions: { external: [/^node:/] }, // of the package, for Node alone
  },
  worker: { format: "iife" }, // a module from a blob does not load from file://
  plugins: [onePage()],
});

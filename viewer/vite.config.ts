// SPDX-License-Identifier: MIT
// Two pages that need no server, a file each: index.html, on which to throw balls, and, with
// `--mode report`, report.html, the page of `flinch compare --report`. Script and style are in them;
// their security policies name the hashes of both, so that nothing else runs. Selectors, reports and
// flinch.wasm are data.
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { gzipSync } from "node:zlib";
import { defineConfig, type Plugin } from "vite";

const packageFolder = resolve(process.env.FLINCH_PACKAGE ?? "../build/release/bindings/js/flinch");

interface PageKind {
  file: string;
  script_sources: string; // that the policy allows beside the page's own script
  data: () => string; // stands before the script; a comment there is where the program puts more
}

const kPages: Record<string, PageKind> = {
  production: {
    file: "index.html",
    script_sources: " 'wasm-unsafe-eval'",
    data: () => {
      // A server that compresses the page compresses bytes better before they are base64.
      const wasm = gzipSync(readFileSync(resolve(packageFolder, "flinch.wasm")), { level: 9 });
      return `<script id="flinch-wasm" type="application/gzip">${wasm.toString("base64")}</script>\n<!-- selectors -->`;
    },
  },
  report: { file: "report.html", script_sources: "", data: () => "<!-- report -->" },
};

function onePage({ file, script_sources, data }: PageKind): Plugin {
  const hash = (text: string) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
  return {
    name: "one-page",
    enforce: "post",
    generateBundle(_, bundle) {
      const page = bundle[file];
      if (page?.type !== "asset") throw new Error(`no ${file}`);
      let script = "";
      let style = "";
      for (const [name, part] of Object.entries(bundle)) {
        if (name === file) continue;
        if (part.type === "chunk") script += part.code;
        else if (name.endsWith(".css")) style += String(part.source);
        else if (!name.endsWith(".wasm")) // that of the package, which the page carries as data
          throw new Error(`${name} would be a file beside the page`);
        delete bundle[name];
      }
      script = script.replaceAll("</script", "<\\/script").trim();
      style = style.trim();
      const policy = [
        "default-src 'none'",
        `script-src ${hash(script)}${script_sources}`,
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
        .replace("</body>", () => `${data()}\n<script type="module">${script}</script>\n  </body>`);
    },
  };
}

export default defineConfig(({ mode }) => {
  const kind = kPages[mode];
  if (!kind) throw new Error(`there is no page ${mode}`);
  return {
    base: "./",
    resolve: { alias: { flinch: resolve(packageFolder, "flinch.js") } },
    build: {
      target: "es2022",
      assetsInlineLimit: 0,
      modulePreload: false,
      outDir: process.env.FLINCH_PAGE_FOLDER ?? "../build/page",
      emptyOutDir: false,
      chunkSizeWarningLimit: 2000,
      rollupOptions: { input: kind.file, external: [/^node:/] }, // of the package, for Node alone
    },
    worker: { format: "iife" }, // a module from a blob does not load from file://
    plugins: [onePage(kind)],
  };
});

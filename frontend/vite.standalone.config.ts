/** Builds the page in one file, into which the server writes a program or a run: it needs no network. */

import { readFileSync } from "node:fs";
import { gzipSync } from "node:zlib";

import type { Plugin } from "vite";
import { defineConfig } from "vite";

/** The licences of everything that it bundles, from the build of the page itself. */
const NOTICES = "../src/learnblock/server/static/third-party-notices.md";

/** Puts script and styles into the page, compressed, and leaves no other file. */
const single: Plugin = {
  name: "single-file",
  enforce: "post",
  generateBundle: {
    order: "post",
    handler(_, bundle) {
      let [code, styles] = ["", ""];
      for (const [name, file] of Object.entries(bundle)) {
        if (file.type === "chunk") code += file.code;
        else if (name.endsWith(".css")) styles += file.source;
        delete bundle[name];
      }
      const packed = (text: string) => gzipSync(text, { level: 9 }).toString("base64");
      const page = readFileSync("standalone.html", "utf-8")
        .replace("{styles}", () => packed(styles))
        .replace("{code}", () => packed(code))
        .replace("{licences}", () => packed(readFileSync(NOTICES, "utf-8")));
      this.emitFile({ type: "asset", fileName: "standalone.html", source: page });
    },
  },
};

export default defineConfig({
  base: "./",
  plugins: [single],
  publicDir: false,
  // Blockly's cursors and sounds, which a picture does not need, would be beside the page.
  define: { "import.meta.url": "document.baseURI" },
  build: {
    outDir: "../src/learnblock/server/static",
    emptyOutDir: false,
    cssCodeSplit: false,
    assetsInlineLimit: Number.MAX_SAFE_INTEGER,
    chunkSizeWarningLimit: 4000,
    rolldownOptions: {
      input: "src/standalone.ts",
      output: { format: "iife", codeSplitting: false },
    },
  },
});

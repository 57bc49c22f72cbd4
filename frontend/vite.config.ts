import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync } from "node:zlib";

import type { Plugin } from "vite";
import { defineConfig, loadEnv } from "vite";

/** Packs once, as small as can be, what the server would otherwise pack at each opening. */
const brotli: Plugin = {
  name: "brotli",
  writeBundle({ dir }, bundle) {
    for (const name of Object.keys(bundle).filter((name) => /\.(js|css)$/.test(name))) {
      const path = join(dir!, name);
      writeFileSync(`${path}.br`, brotliCompressSync(readFileSync(path)));
    }
  },
};

export default defineConfig(({ mode }) => {
  // `learnblock dev` starts Vite beside a server and says where that is.
  const env = loadEnv(mode, ".", "LEARNBLOCK_");
  const target = env["LEARNBLOCK_SERVER"] ?? "http://127.0.0.1:8421";
  // To the server a page that Vite serves looks like its own.
  const headers = { origin: target, cookie: `learnblock_token=${env["LEARNBLOCK_TOKEN"] ?? ""}` };
  const own = { target, changeOrigin: true, headers };
  return {
    // Relative addresses throughout: the page also lives behind a proxy, at whatever path.
    base: "./",
    plugins: [brotli],
    build: {
      outDir: "../src/learnblock/server/static",
      emptyOutDir: true,
      // Blockly alone is larger than Vite's idea of a large file.
      chunkSizeWarningLimit: 1500,
      rolldownOptions: {
        output: {
          // Blockly asks for its pictures and sounds by name, in one folder.
          assetFileNames: ({ originalFileNames }) =>
            originalFileNames.some((name) => name.includes("blockly/media/"))
              ? "media/[name][extname]"
              : "assets/[name]-[hash][extname]",
        },
      },
    },
    server: {
      proxy: { "/ws": { ...own, ws: true }, "/palette": own, "/textures": own, "/worlds": own },
    },
  };
});

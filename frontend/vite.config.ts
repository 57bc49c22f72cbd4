import { appendFileSync, existsSync, readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { brotliCompressSync } from "node:zlib";

import type { Plugin } from "vite";
import { defineConfig, loadEnv } from "vite";

/** Shipped with the page: the licences of everything that it bundles. */
const NOTICES = "third-party-notices.md";

/** Compresses the files once at the build, with the best compression, instead of at each request. */
const brotli: Plugin = {
  name: "brotli",
  writeBundle({ dir }, bundle) {
    for (const name of Object.keys(bundle).filter((name) => /\.(js|css)$/.test(name))) {
      const path = join(dir!, name);
      writeFileSync(`${path}.br`, brotliCompressSync(readFileSync(path)));
    }
  },
};

/** Adds the licences of the fonts, which reach the page through style sheets only. */
const fontLicences: Plugin = {
  name: "font-licences",
  writeBundle({ dir }) {
    for (const font of ["@fontsource-variable/nunito", "@fontsource/jetbrains-mono"]) {
      const licence = readFileSync(join("node_modules", font, "LICENSE"), "utf-8");
      appendFileSync(join(dir!, NOTICES), `\n## ${font} - (OFL-1.1)\n\n${licence}`);
    }
  },
};

/** The pages; what the tests build has only the first. */
const pages: Plugin = {
  name: "pages",
  config({ root = "." }) {
    const input = ["index.html", "class.html", "guest.html", "hand-in-run.html"]
      .map((page) => resolve(root, page))
      .filter(existsSync);
    return { build: { rolldownOptions: { input } } };
  },
};

/** A file of words; its language is the folder's name. */
const WORDS = /\/learnblock\/i18n\/(\w+)\/.*\.ftl/;

/** One chunk for each language, loaded when it is used. */
function wordsChunk(id: string): string | null {
  const language = WORDS.exec(id)?.[1];
  return language ? `words-${language}` : null;
}

export default defineConfig(({ mode }) => {
  // `learnblock dev` starts Vite beside a server and passes its address.
  const env = loadEnv(mode, ".", "LEARNBLOCK_");
  const target = env.LEARNBLOCK_SERVER ?? "http://127.0.0.1:8421";
  // For the server, a page from Vite looks like its own.
  const headers = { origin: target, cookie: `learnblock_token=${env.LEARNBLOCK_TOKEN ?? ""}` };
  const own = { target, changeOrigin: true, headers };
  return {
    // Relative addresses everywhere: a proxy may serve the page at any path.
    base: "./",
    plugins: [pages, brotli, fontLicences],
    build: {
      outDir: "../src/learnblock/server/static",
      emptyOutDir: true,
      license: { fileName: NOTICES },
      // Blockly alone exceeds the default limit.
      chunkSizeWarningLimit: 1500,
      rolldownOptions: {
        output: {
          // Blockly loads its pictures and sounds by name from one folder.
          assetFileNames: ({ originalFileNames }) =>
            originalFileNames.some((name) => name.includes("blockly/media/"))
              ? "media/[name][extname]"
              : "assets/[name]-[hash][extname]",
          codeSplitting: { groups: [{ name: wordsChunk }] },
        },
      },
    },
    server: {
      // The words of all messages are beside the Python code that sends them; the help searches the docs.
      fs: { allow: [".", "../docs", "../src/learnblock/i18n", "../src/learnblock/devices"] },
      proxy: {
        "/ws": { ...own, ws: true },
        "/palette": own,
        "/help": own,
        "/textures": own,
        "/worlds": own,
        "/projects": own,
      },
    },
  };
});

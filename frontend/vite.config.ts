import { defineConfig } from "vite";

// Relative addresses throughout: the page also lives behind a proxy, at whatever path.
export default defineConfig({
  base: "./",
  build: {
    outDir: "../src/learnblock/server/static",
    emptyOutDir: true,
    // Blockly alone is larger than Vite's idea of a large file.
    chunkSizeWarningLimit: 1500,
  },
});

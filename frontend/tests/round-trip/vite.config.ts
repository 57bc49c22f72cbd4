import { defineConfig } from "vite";

// Only tests load this page, and minifying takes several times as long as building it.
export default defineConfig({
  base: "./",
  build: {
    minify: false,
    reportCompressedSize: false,
    chunkSizeWarningLimit: 9000,
    // Blockly loads its pictures and sounds by name from one folder.
    rolldownOptions: { output: { assetFileNames: "assets/[name][extname]" } },
  },
});

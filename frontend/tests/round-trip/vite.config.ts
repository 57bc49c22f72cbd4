import { defineConfig } from "vite";

// Nobody downloads this page: to make it small takes several times as long as to make it.
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

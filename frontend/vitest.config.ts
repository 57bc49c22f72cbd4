import { defineConfig } from "vitest/config";

// Apart from the page's build: a test needs neither its plugins nor its server. A busy computer takes
// longer for a test, which is no failure. Files with components (`.tsx`) have a document. Each file
// has modules of its own, in a thread, which takes less to start than a process.
export default defineConfig({
  // The words are beside those of Python.
  server: { fs: { allow: [".."] } },
  oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
  test: { include: ["tests/**/*.test.{ts,tsx}"], environment: "node", pool: "threads", testTimeout: 60_000 },
});

import { defineConfig } from "vitest/config";

// Apart from the page's build: a test needs neither its plugins nor its server. A busy computer takes
// longer for a test, which is no failure.
export default defineConfig({ test: { include: ["tests/**/*.test.ts"], environment: "node", testTimeout: 60_000 } });

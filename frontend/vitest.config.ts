import { defineConfig } from "vitest/config";

// Apart from the page's build: a test needs neither its plugins nor its server.
export default defineConfig({ test: { include: ["tests/**/*.test.ts"], environment: "node" } });

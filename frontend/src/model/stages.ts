/** How much of the page is shown at first; everything stays reachable. */
export type Stage = "starter" | "explorer" | "coder";

/** From the first to the last. */
export const STAGES: readonly Stage[] = ["starter", "explorer", "coder"];

/** Loads the parts of the working page while the user looks at the start page. */
export function preload(): void {
  const whenIdle = globalThis.requestIdleCallback ?? setTimeout;
  whenIdle(() => {
    void import("../../views/blocks/blocks-view");
    void import("../../views/text/text-view");
    void import("../../views/world");
  });
}

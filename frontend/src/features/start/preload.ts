import { whenIdle } from "../../ui/when-idle";

/** Loads the parts of the working page while the user looks at the start page. */
export function preload(): void {
  whenIdle(() => {
    void import("../../views/blocks/blocks-view");
    void import("../../views/text/text-view");
    void import("../../views/world");
  });
}

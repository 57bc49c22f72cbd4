/** Whether a part of the page can be seen. */

import { computed, signal, type ReadonlySignal } from "@preact/signals";

export interface Visibility {
  readonly visible: ReadonlySignal<boolean>;
  destroy(): void;
}

/** Follows whether an element is on the screen, in a page that is not hidden. */
export function watchVisibility(element: Element): Visibility {
  const onScreen = signal(false);
  const pageShown = signal(!document.hidden);
  const observer = new IntersectionObserver((entries) => {
    onScreen.value = entries.at(-1)?.isIntersecting ?? false;
  });
  const follow = () => (pageShown.value = !document.hidden);
  observer.observe(element);
  document.addEventListener("visibilitychange", follow);
  return {
    visible: computed(() => onScreen.value && pageShown.value),
    destroy: () => {
      observer.disconnect();
      document.removeEventListener("visibilitychange", follow);
    },
  };
}

/** Detects whether an element is visible. */

import { computed, type ReadonlySignal, signal } from "@preact/signals";

export interface Visibility {
  readonly visible: ReadonlySignal<boolean>;
  destroy(): void;
}

/** Watches whether an element is on the screen of a visible page. */
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

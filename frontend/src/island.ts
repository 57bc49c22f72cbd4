/** A part of the page that draws itself, outside Preact: it has a place in the page and an end. */
export interface Island {
  readonly dom: HTMLElement;
  destroy(): void;
}

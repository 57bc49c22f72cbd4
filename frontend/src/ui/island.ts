/** A part of the page that draws itself, without Preact. */
export interface Island {
  readonly dom: HTMLElement;
  destroy(): void;
}

/** Centres a view in the part of the picture that nothing covers. */

import type { PerspectiveCamera } from "three";

/** The largest share of a small picture's height that is left to its overlays. */
const MOST = 0.35;

/** How many pixels are covered at the upper and at the lower edge. */
export interface Covered {
  readonly top: number;
  readonly bottom: number;
}

/** Fit a camera to a picture of this size in pixels: its view is centred in what is free. */
export function fitFree(camera: PerspectiveCamera, width: number, height: number, { top, bottom }: Covered): void {
  const hidden = Math.min(top + bottom, MOST * height);
  const free = Math.max(1, height - hidden);
  const above = hidden && (hidden * top) / (top + bottom);
  camera.aspect = width / free;
  camera.setViewOffset(width, free, 0, -above, width, height);
}

/** The part of the picture's height that nothing covers. */
export function freePart({ view }: PerspectiveCamera): number {
  return view ? view.fullHeight / view.height : 1;
}

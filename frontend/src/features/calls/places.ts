/** A laid out call graph. */

/** The size of a function's box in pixels. */
export const BOX = { width: 148, height: 44 };

export interface Place {
  readonly x: number;
  readonly y: number;
}

/** A layer of the graph. */
export interface Column {
  readonly layer: number;
  /** Its middle. */
  readonly x: number;
}

export interface Laid {
  readonly width: number;
  readonly height: number;
  /** The middle of each function's box. */
  readonly places: readonly Place[];
  /** The way of each edge's line. */
  readonly lines: readonly (readonly Place[])[];
  readonly columns: readonly Column[];
}

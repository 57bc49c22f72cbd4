/** A laid out call graph. */

/** The size of a function's box in pixels. */
export const BOX = { width: 148, height: 44 };

export interface Place {
  readonly x: number;
  readonly y: number;
}

/** A layer of the graph, and where its name is. */
export interface Column extends Place {
  readonly layer: number;
  /** Whether it is a row, whose name begins there; else the name is centred there. */
  readonly isRow?: boolean;
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

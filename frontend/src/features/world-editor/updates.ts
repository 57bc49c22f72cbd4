/** How the form changes values. */

/** Computes a value from the current one. */
export type Update<T> = (old: T) => T;
/** Changes the value of a key. */
export type Take = (key: string, update: Update<unknown>) => void;

/** Changes a list. */
export type TakeList<T> = (update: Update<T[]>) => void;

/** What the fields of a form have in common. */

import { createContext } from "preact";
import { useContext } from "preact/hooks";

/** Where a value is: keys of tables, and numbers in lists. */
export type Path = readonly (string | number)[];

export interface Form {
  /** What the server says about the value at a path. Without it, fields refuse what is not allowed. */
  readonly problems?: (path: Path) => readonly string[];
}

export const FormContext = createContext<Form>({});

/** What the server says about the value at a path; null where fields judge for themselves. */
export function useProblems(path: Path): readonly string[] | null {
  return useContext(FormContext).problems?.(path) ?? null;
}

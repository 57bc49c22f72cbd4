/** What the right side of the dialog shows. */

export type Aside =
  | { readonly what: "robot" }
  | { readonly what: "help" | "address"; readonly robot: string }
  | { readonly what: "calibrate" };

/** The connection to a robot. */
export const ROBOT: Aside = { what: "robot" };

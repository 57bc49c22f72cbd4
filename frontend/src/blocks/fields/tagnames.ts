/** The names that tags have in the user's dictionary. */

import { signal } from "@preact/signals";

export const tagNames = signal<readonly string[]>([]);

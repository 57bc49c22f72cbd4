/** The component `Markdown`, whose code is loaded when it is first shown. */

import { loadedLater } from "../../ui/loaded-later";

export const Markdown = loadedLater(async () => (await import("./markdown")).Markdown);

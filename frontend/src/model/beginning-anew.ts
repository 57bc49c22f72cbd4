/** What begins anew with each connection to the server, and with each opened project. */

import type { Connection } from "../protocol/connection";
import type { Opened, Welcome } from "../protocol/messages";

/** A part of the page that a new connection changes: the first one, or a reconnection. */
export interface Connected {
  connected(welcome: Welcome): void;
}

/** A part of the page that an opened project changes: another one, or the same one after a reconnection. */
export interface Resettable {
  reset(opened: Opened): void;
}

/** Connect and reset parts of the page in the order of these lists, whatever the order in which they were made. */
export function beginAnew(
  connection: Connection,
  parts: { readonly connected: readonly Connected[]; readonly reset: readonly Resettable[] },
): void {
  connection.on("Welcome", (welcome) => {
    for (const part of parts.connected) part.connected(welcome);
  });
  connection.on("Opened", (opened) => {
    for (const part of parts.reset) part.reset(opened);
  });
}

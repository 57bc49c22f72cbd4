/** The page's address: the open project and, on the first visit, the access token. */

const base = new URL(".", location.href);
/** Several servers may share one origin, behind a proxy. */
const KEY = `learnblock.token:${base.pathname}`;

function parameters(): URLSearchParams {
  return new URLSearchParams(location.hash.slice(1));
}

/** Move the token from the address to the page's storage and return it; without one, return the stored one. */
export function takeToken(): string {
  const address = new URL(location.href);
  const hash = parameters();
  const given = address.searchParams.get("token") ?? hash.get("token");
  if (given === null) return localStorage.getItem(KEY) ?? "";
  localStorage.setItem(KEY, given);
  address.searchParams.delete("token");
  hash.delete("token");
  address.hash = hash.toString();
  history.replaceState(null, "", address);
  return given;
}

/** The address of the server's websocket, relative to the page, because a proxy may add a path. */
export function socketAddress(): URL {
  const address = new URL("ws", base);
  address.protocol = base.protocol === "https:" ? "wss:" : "ws:";
  return address;
}

/** The project in the address. */
export function addressedProject(): string | null {
  return parameters().get("project");
}

/** Put the open project into the address, for reloads, bookmarks and the back button. */
export function nameProject(name: string): void {
  const before = addressedProject();
  if (before === null) renameProject(name);
  else if (before !== name) history.pushState(null, "", hashOf(name));
}

/** Replace the project in the address without adding to the history. */
export function renameProject(name: string): void {
  history.replaceState(null, "", hashOf(name));
}

function hashOf(name: string): string {
  return `#${new URLSearchParams({ project: name })}`;
}

/** What stands in the page's address: the open project, and once the token that lets us in. */

const base = new URL(".", location.href);
/** Several servers may live at one origin, behind a proxy. */
const KEY = `learnblock.token:${base.pathname}`;

function parameters(): URLSearchParams {
  return new URLSearchParams(location.hash.slice(1));
}

/** The token: from the address, which is then rid of it, or as a former page kept it. */
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

/** Of the server's socket, relative to the page: a proxy may have put both at any path. */
export function socketAddress(): URL {
  const address = new URL("ws", base);
  address.protocol = base.protocol === "https:" ? "wss:" : "ws:";
  return address;
}

/** The project that the address names. */
export function addressedProject(): string | null {
  return parameters().get("project");
}

/** Name the open project in the address, for reloads, bookmarks and the way back. */
export function nameProject(name: string): void {
  const before = addressedProject();
  if (before === null) renameProject(name);
  else if (before !== name) history.pushState(null, "", hashOf(name));
}

/** Name it instead of what the address names, which is no way back. */
export function renameProject(name: string): void {
  history.replaceState(null, "", hashOf(name));
}

function hashOf(name: string): string {
  return `#${new URLSearchParams({ project: name })}`;
}

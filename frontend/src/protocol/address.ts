/** The page's address: the open project and, on the first visit, the access token. */

import { inBrowser } from "../ui/storage";
import { socketAt } from "./channel";

// The frame of a notebook has no address of its own, but its page has.
const base = new URL(".", document.baseURI);
/** Several servers may share one origin, behind a proxy. */
const TOKEN = inBrowser(`learnblock.token:${base.pathname}`);

/** The name of a shared link in the fragment. */
const SHARED = "share";

function parameters(): URLSearchParams {
  return new URLSearchParams(location.hash.slice(1));
}

/** Move the token from the address to the page's storage and return it; without one, return the stored one. */
export function takeToken(): string {
  const address = new URL(location.href);
  const hash = parameters();
  const given = address.searchParams.get("token") ?? hash.get("token");
  if (given === null) return TOKEN.read() ?? "";
  TOKEN.write(given);
  address.searchParams.delete("token");
  hash.delete("token");
  address.hash = hash.toString();
  history.replaceState(null, "", address);
  return given;
}

/**
 * The address that opens this page, with its project, on another device; null if no other device can
 * reach the server.
 *
 * @param network the numeric address of the server's computer in its network, if it listens there.
 */
export function addressElsewhere(network: string | null): string | null {
  const address = new URL(location.href);
  if (isLoopback(address.hostname)) {
    if (network === null) return null;
    address.hostname = network;
  }
  const token = TOKEN.read();
  // In a class and behind a proxy that logs users in there is none.
  if (token) address.searchParams.set("token", token);
  return address.href;
}

/**
 * The address that opens a shared link in any LearnBlock at that address. It never has the token: that opens
 * all projects.
 */
export function sharedAddress(link: string, network: string | null): string {
  const address = new URL(base);
  if (isLoopback(address.hostname) && network !== null) address.hostname = network;
  address.hash = `${SHARED}=${link}`;
  return address.href;
}

/** Take a shared link out of the address and return it; null if there is none. */
export function takeSharedLink(): string | null {
  const link = parameters().get(SHARED);
  if (link === null) return null;
  forgetProject();
  return `#${SHARED}=${link}`;
}

function isLoopback(name: string): boolean {
  return name === "localhost" || name === "[::1]" || name.startsWith("127.");
}

/** The address of the server's websocket. */
export function socketAddress(): URL {
  return socketAt("ws", base);
}

/** The project in the address. */
export function addressedProject(): string | null {
  return parameters().get("project");
}

/** Put the open project into the address, for reloads, bookmarks and the back button. */
export function nameProject(name: string): void {
  if (addressedProject() !== name) history.pushState(null, "", hashOf(name));
}

/** Take the project out of the address; the back button returns to it. */
export function nameNoProject(): void {
  if (addressedProject() !== null) history.pushState(null, "", plainAddress());
}

/** Take a project that can't be opened out of the address and the history. */
export function forgetProject(): void {
  history.replaceState(null, "", plainAddress());
}

/** Replace the project in the address without adding to the history. */
export function renameProject(name: string): void {
  history.replaceState(null, "", hashOf(name));
}

function plainAddress(): string {
  return location.pathname + location.search;
}

function hashOf(name: string): string {
  return `#${new URLSearchParams({ project: name })}`;
}

/** Do something once the browser has nothing else to do; Safari can't say when that is. */
export function whenIdle(action: () => void): void {
  const request = globalThis.requestIdleCallback ?? setTimeout;
  request(() => action());
}

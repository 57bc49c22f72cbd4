/** Announces texts to screen readers, invisibly. */
export class WorldAnnouncer {
  readonly dom = document.createElement("div");

  constructor() {
    this.dom.className = "world-said hidden";
    this.dom.ariaLive = "polite";
  }

  say(text: string): void {
    const line = document.createElement("p");
    line.textContent = text;
    // A new element, so that the same text is read again.
    this.dom.replaceChildren(line);
  }
}

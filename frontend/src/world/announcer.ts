/** Tells those who listen to the page; nothing of it is seen. */
export class Announcer {
  readonly dom = document.createElement("div");

  constructor() {
    this.dom.className = "world-said";
    this.dom.ariaLive = "polite";
  }

  say(text: string): void {
    const line = document.createElement("p");
    line.textContent = text;
    // A new element, so that the same sentence is read again when it is asked for again.
    this.dom.replaceChildren(line);
  }
}

/** Helpers for creating elements. */

type Attributes = Record<string, string>;

/** An element with attributes and children. */
export function element<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...inside: (Node | string)[]
): HTMLElementTagNameMap[Tag] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...inside);
  return made;
}

/** A button with an action. */
export function button(className: string, press: () => void): HTMLButtonElement {
  const made = element("button", { type: "button", class: className });
  made.onclick = press;
  return made;
}

/** Download a file. */
export function download(filename: string, type: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  element("a", { href: address, download: filename }).click();
  URL.revokeObjectURL(address);
}

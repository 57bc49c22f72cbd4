/** SVG elements in the plan's coordinates: x east as in the world, y down. */

const SPACE = "http://www.w3.org/2000/svg";

type Attributes = Readonly<Record<string, string | number>>;

export function svg<K extends keyof SVGElementTagNameMap>(
  name: K,
  attributes: Attributes,
  ...children: readonly (Node | string)[]
): SVGElementTagNameMap[K] {
  const element = document.createElementNS(SPACE, name);
  set(element, attributes);
  element.append(...children);
  return element;
}

export function set(element: Element, attributes: Attributes): void {
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
}

/** A chain of world points as `points` of a polyline. */
export function chain(points: readonly (readonly [number, number])[]): string {
  return points.map(([x, y]) => `${x},${-y}`).join(" ");
}

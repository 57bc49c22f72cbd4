/** A face that shows an emotion. */

interface Features {
  readonly brows: string;
  /** Heights of the left and right eye. */
  readonly eyes: readonly [number, number];
  readonly mouth: string;
}

const FLAT = "M18 20h14M48 20h14";
/** In a picture of 80 by 64. */
const FACES: Record<string, Features> = {
  joy: { brows: "M18 18q7-5 14 0M48 18q7-5 14 0", eyes: [6, 6], mouth: "M24 44q16 16 32 0" },
  sadness: { brows: "M18 22l14-6M62 22l-14-6", eyes: [5, 5], mouth: "M26 54q14-12 28 0" },
  anger: { brows: "M18 15l14 7M62 15l-14 7", eyes: [5, 5], mouth: "M26 52q14-7 28 0" },
  fear: { brows: "M18 16q7-6 14-4M62 16q-7-6-14-4", eyes: [9, 9], mouth: "M26 50q5-6 9 0t9 0 9 0" },
  surprise: { brows: "M18 13q7-6 14 0M48 13q7-6 14 0", eyes: [9, 9], mouth: "M40 42a7 8 0 1 0 .1 0Z" },
  disgust: { brows: "M18 20l14 2M48 16q7-4 14 0", eyes: [3, 6], mouth: "M26 52q10-8 16-2t12-4" },
  neutral: { brows: FLAT, eyes: [6, 6], mouth: "M27 48h26" },
};

const SVG = "http://www.w3.org/2000/svg";

function shape(name: string, attributes: Record<string, string | number>): SVGElement {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  return made;
}

function drawing({ brows, eyes, mouth }: Features): SVGElement[] {
  return [
    shape("path", { d: brows }),
    shape("ellipse", { cx: 25, cy: 31, rx: 6, ry: eyes[0], class: "eye" }),
    shape("ellipse", { cx: 55, cy: 31, rx: 6, ry: eyes[1], class: "eye" }),
    shape("path", { d: mouth }),
  ];
}

/** A picture of an emotion; blank for one without a face, such as `none`. */
export function face(emotion: string): SVGElement {
  const features = FACES[emotion];
  const picture = shape("svg", { viewBox: "0 0 80 64", class: "face", "aria-hidden": "true" });
  picture.append(...(features ? drawing(features) : []));
  return picture;
}

/** A face that shows an emotion. */

interface Features {
  readonly brows: string;
  /** Heights of the left and right eye. */
  readonly eyes: readonly [number, number];
  readonly mouth: string;
}

const FLAT = "M18 16h14M48 16h14";
/** In a picture of 80 by 64. Brows keep away from the eyes, or they would be one spot in a block. */
const FACES: Record<string, Features> = {
  joy: { brows: "", eyes: [7, 7], mouth: "M20 45q20 20 40 0" },
  sadness: { brows: "M17 18l14-6M63 18l-14-6", eyes: [5, 5], mouth: "M26 54q14-12 28 0" },
  anger: { brows: "M18 11l14 7M62 11l-14 7", eyes: [5, 5], mouth: "M26 52q14-7 28 0" },
  fear: { brows: "M18 12q7-6 14-4M62 12q-7-6-14-4", eyes: [9, 9], mouth: "M26 50q5-6 9 0t9 0 9 0" },
  surprise: { brows: "M18 11q7-6 14 0M48 11q7-6 14 0", eyes: [9, 9], mouth: "M40 42a7 8 0 1 0 .1 0Z" },
  disgust: { brows: "M18 18l14 2M48 14q7-4 14 0", eyes: [3, 6], mouth: "M26 52q10-8 16-2t12-4" },
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

/** The same face as the source of a round picture, in one colour. */
export function faceSource(emotion: string, color: string): string {
  const features = FACES[emotion];
  const lines = { fill: "none", stroke: color, "stroke-width": 5, "stroke-linecap": "round" };
  const picture = shape("svg", { xmlns: SVG, viewBox: "-4 -10 88 88", width: 22, height: 22, ...lines });
  picture.append(shape("circle", { cx: 40, cy: 34, r: 41 }), ...(features ? drawing(features) : []));
  // Without an outline, small eyes stay apart from brows and mouth.
  for (const eye of picture.querySelectorAll(".eye")) {
    eye.setAttribute("fill", color);
    eye.setAttribute("stroke", "none");
  }
  return `data:image/svg+xml,${encodeURIComponent(picture.outerHTML)}`;
}

/** The pictures of PINs. */

import {
  Apple,
  Bell,
  Car,
  Cloud,
  Fish,
  Flower2,
  Heart,
  House,
  type IconNode,
  KeyRound,
  Moon,
  Sailboat,
  Star,
  Sun,
  TreeDeciduous,
  Umbrella,
  Volleyball,
} from "lucide";
import { h } from "preact";

import { t } from "../../i18n";
import type { Picture } from "../../protocol/classroom";

/** Each has a colour of its own besides its outline and its name. */
const PICTURES: Readonly<Record<Picture, readonly [IconNode, string]>> = {
  apple: [Apple, "#dc2626"],
  ball: [Volleyball, "#c2470a"],
  bell: [Bell, "#a16207"],
  boat: [Sailboat, "#2563eb"],
  car: [Car, "#c4267f"],
  cloud: [Cloud, "#0369a1"],
  fish: [Fish, "#0b7a75"],
  flower: [Flower2, "#a21caf"],
  heart: [Heart, "#c81e3a"],
  house: [House, "#9a4a00"],
  key: [KeyRound, "#8a5a00"],
  moon: [Moon, "#4338ca"],
  star: [Star, "#9a6200"],
  sun: [Sun, "#b45309"],
  tree: [TreeDeciduous, "#15803d"],
  umbrella: [Umbrella, "#7c3aed"],
};

export const ALL = Object.keys(PICTURES) as readonly Picture[];

export function pictureName(picture: Picture): string {
  return t(`page-class-picture-${picture}`);
}

/** The colour of a picture, for the style of what shows it. */
export function pictureColor(picture: Picture): Record<string, string> {
  return { "--picture": PICTURES[picture][1] };
}

export function PinPicture({ picture }: { picture: Picture }) {
  return (
    <svg class="icon pin-picture" viewBox="0 0 24 24" aria-hidden="true" style={pictureColor(picture)}>
      {PICTURES[picture][0].map(([name, attributes]) => h(name, attributes))}
    </svg>
  );
}

/** Pictures in a row, with their names. */
export function PictureRow({ pictures }: { pictures: readonly Picture[] }) {
  return (
    <ol class="pin-row">
      {pictures.map((picture) => (
        <li key={picture} class="pin-tile" style={pictureColor(picture)}>
          <PinPicture picture={picture} />
          <span>{pictureName(picture)}</span>
        </li>
      ))}
    </ol>
  );
}

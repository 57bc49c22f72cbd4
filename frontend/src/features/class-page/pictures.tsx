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

/** Colours differ by lightness, too, and no two pictures have the same outline. */
const PICTURES: Readonly<Record<Picture, readonly [IconNode, string]>> = {
  apple: [Apple, "#e5383b"],
  ball: [Volleyball, "#f3a712"],
  bell: [Bell, "#ffd166"],
  boat: [Sailboat, "#4ea8de"],
  car: [Car, "#d62828"],
  cloud: [Cloud, "#bde0fe"],
  fish: [Fish, "#fb8500"],
  flower: [Flower2, "#ff8fab"],
  heart: [Heart, "#f0529c"],
  house: [House, "#c8956c"],
  key: [KeyRound, "#ffe066"],
  moon: [Moon, "#cdb4db"],
  star: [Star, "#ffc531"],
  sun: [Sun, "#ffb703"],
  tree: [TreeDeciduous, "#52b788"],
  umbrella: [Umbrella, "#8257e6"],
};

export const ALL = Object.keys(PICTURES) as readonly Picture[];

export function pictureName(picture: Picture): string {
  return t(`page-class-picture-${picture}`);
}

export function PinPicture({ picture }: { picture: Picture }) {
  const [node, color] = PICTURES[picture];
  return (
    <svg
      class="pin-picture"
      viewBox="0 0 24 24"
      fill={color}
      stroke="#1a2138"
      stroke-width="1.4"
      stroke-linecap="round"
      stroke-linejoin="round"
      aria-hidden="true"
    >
      {node.map(([name, attributes]) => h(name, attributes))}
    </svg>
  );
}

/** Pictures in a row, with their names. */
export function PictureRow({ pictures }: { pictures: readonly Picture[] }) {
  return (
    <ol class="pin-row">
      {pictures.map((picture) => (
        <li key={picture}>
          <PinPicture picture={picture} />
          <span>{pictureName(picture)}</span>
        </li>
      ))}
    </ol>
  );
}

/** What a block that is being made will look like: how it is used, and where its maker says what it does. */

import type { OwnBlock } from "../../model/own-blocks";
import type { Island } from "../../ui/island";
import { BlockPicture } from "../../views/blocks/block-picture";
import { callState, definitionState } from "../../views/blocks/own-blocks";

/** As large as the blocks in the program. */
const SCALE = 0.85;

export interface PicturesOfOwn extends Island {
  resize(): void;
  show(own: OwnBlock): void;
}

/** @param words What is said above the call and above the definition. */
export function createPictures(words: readonly [string, string]): PicturesOfOwn {
  const dom = document.createElement("div");
  dom.className = "make-block-pair";
  const [call, definition] = [new BlockPicture(SCALE), new BlockPicture(SCALE)];
  [call, definition].forEach((picture, place) => {
    const part = document.createElement("div");
    part.append(Object.assign(document.createElement("p"), { textContent: words[place] }), picture.dom);
    dom.append(part);
  });
  return {
    dom,
    resize: () => [call, definition].forEach((picture) => picture.resize()),
    show: (own) => {
      call.show(callState(own, false));
      definition.show(definitionState(own));
    },
    destroy: () => [call, definition].forEach((picture) => picture.destroy()),
  };
}

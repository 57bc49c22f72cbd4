/** What is written into a page in one file. */

import type { ThemeName } from "../../model/preferences";
import type { Workspace } from "../../protocol/messages";
import type { Palette } from "../../views/blocks/palette";

/** A picture of a program, which the page draws for the command line. */
export interface PictureContent {
  readonly kind: "picture";
  readonly type: "svg" | "png";
  readonly language: string;
  readonly theme: ThemeName;
  readonly palette: Palette;
  readonly workspace: Workspace;
  readonly text: string;
}

export type Content = PictureContent;

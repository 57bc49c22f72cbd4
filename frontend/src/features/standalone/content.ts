/** What is written into a page in one file. */

import type { ThemeName } from "../../model/preferences";
import type {
  Drawing,
  Past,
  Place,
  Questions,
  Scene,
  Telemetry,
  Timeline,
  WhyAnswer,
  Workspace,
} from "../../protocol/messages";
import type { Palette } from "../../views/blocks/palette";
import type { Resident } from "./world";

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

/** A run, with every moment, question and answer that the page can show: see `server/runs/take_home.py`. */
export interface RunContent {
  readonly kind: "run";
  readonly language: string;
  readonly title: string;
  /** Who made it; empty if the page is not to say so. */
  readonly pupil: string;
  readonly palette: Palette;
  readonly scene: Scene;
  /** Where all robots were at each time in s. */
  readonly states: readonly (readonly [number, Telemetry["robots"]])[];
  /** At least one. */
  readonly robots: readonly RobotContent[];
}

/** A robot of the run, with its program and all that can be shown of it. */
export interface RobotContent extends Recording, Resident {
  /** The name of its kind, such as `sim-ebo`. */
  readonly robot: string;
  readonly workspace: Workspace;
  readonly blocktext: string;
  readonly python: string;
  readonly places: readonly Place[];
  readonly printed: string;
}

/** What a server would answer about the run. */
export interface Recording {
  readonly timeline: Timeline;
  /** In order of time. */
  readonly moments: readonly Moment[];
  /** What was on the floor at the end. */
  readonly drawing: Drawing | null;
  readonly questions: Questions;
  readonly answers: readonly WhyAnswer[];
}

/** Without the states of the robots, which `RunContent` has. */
export interface Moment {
  readonly past: Past;
  /** How many points of the drawing there were, if it is not in `past`. */
  readonly drawn: number;
}

/** A lesson on paper: see `lessons/worksheet.py`. */
export interface WorksheetContent {
  readonly kind: "worksheet";
  readonly language: string;
  readonly palette: Palette;
  readonly title: string;
  /** The addresses of the pictures in its texts, with their data, by their names. */
  readonly pictures: Readonly<Record<string, string>>;
  readonly steps: readonly WorksheetStep[];
}

export interface WorksheetStep {
  readonly title: string;
  /** Markdown, and programs that are drawn. */
  readonly text: readonly { readonly text: string; readonly workspace: Workspace | null }[];
  readonly goals: readonly string[];
  readonly quiz: WorksheetQuiz | null;
  /** The blocks to cut out. */
  readonly pieces: readonly Workspace[];
  readonly solution: { readonly text: string; readonly workspace: Workspace } | null;
}

export interface WorksheetQuiz {
  readonly question: string;
  readonly choices: readonly { readonly text: string; readonly right: boolean }[];
}

export type Content = PictureContent | RunContent | WorksheetContent;

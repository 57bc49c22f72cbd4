/** The conversation of a class; written by `python -m learnblock.classroom.typescript`. */

import type { Phrase } from "../i18n";

export type Picture = "apple" | "ball" | "bell" | "boat" | "car" | "cloud" | "fish" | "flower" | "heart" | "house" | "key" | "moon" | "star" | "sun" | "tree" | "umbrella";

export type Writing = "asked" | "no" | "yes";

export interface AboutClass {
  title: string;
  open: boolean;
  teaches: boolean;
  pupil: string;
  address: string;
}

export interface AnswerKnocking {
  kind: "AnswerKnocking";
  on: boolean;
}

export interface AskForHelp {
  kind: "AskForHelp";
  on: boolean;
  request?: number;
}

export interface AskToWrite {
  kind: "AskToWrite";
  on: boolean;
  request?: number;
}

export interface EyesUp {
  kind: "EyesUp";
  on: boolean;
}

export interface HandOut {
  kind: "HandOut";
  lesson: string;
  project: string;
}

export interface InClass {
  kind: "InClass";
  name: string;
  role: "helper" | "pupil" | "watcher";
  eyes_up: boolean;
  hand: boolean;
  writing: "asked" | "no" | "yes";
  hint?: string;
}

export interface Join {
  word: string;
  name: string;
  pictures: ("apple" | "ball" | "bell" | "boat" | "car" | "cloud" | "fish" | "flower" | "heart" | "house" | "key" | "moon" | "star" | "sun" | "tree" | "umbrella")[] | null;
}

export interface Joined {
  address: string;
  pictures?: ("apple" | "ball" | "bell" | "boat" | "car" | "cloud" | "fish" | "flower" | "heart" | "house" | "key" | "moon" | "star" | "sun" | "tree" | "umbrella")[];
}

export interface LetJoin {
  kind: "LetJoin";
  on: boolean;
}

export interface LetTeacherWrite {
  kind: "LetTeacherWrite";
  on: boolean;
  request?: number;
}

export interface NewPin {
  kind: "NewPin";
  name: string;
  pictures: ("apple" | "ball" | "bell" | "boat" | "car" | "cloud" | "fish" | "flower" | "heart" | "house" | "key" | "moon" | "star" | "sun" | "tree" | "umbrella")[];
}

export interface NotJoined {
  message: Phrase;
}

export interface Plan {
  kind: "Plan";
  pupil: string;
  scene: number;
  world: Record<string, unknown>;
  lines?: [number, number][][];
}

export interface Projected {
  kind: "Projected";
  title: string;
  word: string;
  address: string;
  open: boolean;
  seat?: Seat | null;
  plan?: Plan | null;
  names?: string[];
}

export interface Refused {
  kind: "Refused";
  message: Phrase;
}

export interface RemovePupils {
  kind: "RemovePupils";
  pupils: string[];
}

export interface RenewPin {
  kind: "RenewPin";
  pupil: string;
}

export interface RenewWord {
  kind: "RenewWord";
}

export interface Seat {
  project?: string;
  robot?: string;
  pose?: [number, number, number] | null;
  way?: number[];
  state?: "done" | "ended" | "held" | "idle" | "input" | "paused" | "running" | "starting";
  goals?: ("failed" | "open" | "reached")[];
  lesson?: string | Record<string, string>;
  step?: number;
  steps?: number;
  stars?: number;
  error?: Record<string, unknown> | null;
  id: string;
  name?: string;
  here?: boolean;
  hand?: boolean;
  scene?: number;
  quiet?: number;
  stuck?: number;
  writing?: "asked" | "no" | "yes";
}

export interface Seats {
  kind: "Seats";
  seats: Seat[];
}

export interface SendHint {
  kind: "SendHint";
  text: string;
  pupil?: string | null;
}

export interface ShowOnProjector {
  kind: "ShowOnProjector";
  pupil?: string | null;
}

export interface StopAll {
  kind: "StopAll";
}

export interface Wall {
  kind: "Wall";
  title: string;
  word: string;
  address: string;
  open: boolean;
  eyes_up: boolean;
  more: number;
  projected?: string;
  pupils?: string[];
  lessons?: ([string, string | Record<string, string>])[];
  knocking?: string[];
}

export type FromPupil =
  | AskForHelp
  | LetTeacherWrite
  | AskToWrite;

export type ToPupil =
  | InClass;

export type FromTeacher =
  | EyesUp
  | StopAll
  | SendHint
  | HandOut
  | RenewPin
  | RemovePupils
  | LetJoin
  | AnswerKnocking
  | RenewWord
  | ShowOnProjector;

export type ToTeacher =
  | Wall
  | Seats
  | Plan
  | NewPin
  | Refused
  | Projected;

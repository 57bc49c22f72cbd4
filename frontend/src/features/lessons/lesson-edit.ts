/** A lesson that a teacher makes or changes: the values of its file, and the programs beside them. */

import type { EditedLesson, EditedStep, LessonStep, WrittenProgram } from "../../protocol/messages";

export type Phase = LessonStep["phase"];
/** A text by language; the teacher writes at least one. */
export type Texts = Readonly<Record<string, string>>;
/** A check or an event: its kind, and the values that it takes. */
export type Values = Readonly<Record<string, unknown>>;

export interface ChoiceContent {
  readonly text: Texts;
  readonly right?: boolean;
  readonly because?: Texts;
}

export interface HintContent {
  readonly check?: string;
  readonly say: readonly Texts[];
}

/** A puzzle: the file of its program, other orders that are as right, and lines that don't belong to it. */
export interface PuzzleContent {
  readonly program: string;
  readonly also?: readonly string[];
  readonly distractors?: readonly string[];
}

/** A key that is pressed; times are seconds. */
export interface KeyPressContent {
  readonly key: string;
  readonly at: number;
  readonly seconds?: number;
  readonly times?: number;
  readonly every?: number;
}

export interface StepContent {
  readonly title: Texts;
  readonly phase: Phase;
  readonly text: Texts;
  readonly world?: string;
  readonly blocks?: string | readonly string[];
  readonly variants?: number;
  readonly seconds?: number;
  readonly keys?: readonly KeyPressContent[];
  readonly check?: readonly Values[];
  readonly hint?: readonly HintContent[];
  readonly quiz?: { readonly question: Texts; readonly choices: readonly ChoiceContent[] };
  readonly puzzle?: PuzzleContent;
}

export interface LessonContent {
  readonly title: Texts;
  readonly level: number;
  readonly minutes: number;
  readonly aims: readonly Texts[];
  readonly robots: readonly string[];
  readonly step: readonly StepContent[];
}

export interface LessonEdit {
  readonly content: LessonContent;
  readonly steps: readonly EditedStep[];
  /** The name of the saved lesson; empty for a new one. */
  readonly lesson: string;
  readonly programs: Readonly<Record<string, string>>;
  readonly notes: Texts;
}

export const NEW_STEP: StepContent = { title: {}, phase: "make", text: {}, check: [{ kind: "ends" }] };
export const EMPTY_PROGRAM: WrittenProgram = { text: "main:\n    pass\nend\n" };

/** The keys of texts, and of lists of texts. */
const TEXTS = new Set(["title", "text", "question", "because"]);
const LISTS = new Set(["aims"]);

/** A lesson from the server, with every text by language: one for all languages is in the user's. */
export function draftOf({ content, steps = [], lesson = "", programs = {}, notes = {} }: EditedLesson, code: string) {
  const found = byLanguage(content, code) as unknown as LessonContent;
  return { content: found, steps, lesson, programs, notes } satisfies LessonEdit;
}

/** What is sent to the server: without blank texts where the lesson can do without them. */
export function editedOf({ content, steps, lesson, programs, notes }: LessonEdit): EditedLesson {
  const aims = content.aims.filter((aim) => !isBlank(aim));
  const kept = { ...content, aims: aims.length > 0 ? aims : [{}], step: content.step.map(writtenStep) };
  const written = withoutBlanks(kept) as Record<string, unknown>;
  return { content: written, steps: [...steps], lesson, programs: { ...programs }, notes: { ...notes } };
}

export function isBlank(text: Texts = {}): boolean {
  return Object.values(text).every((one) => one.trim() === "");
}

/** Values with an entry added, moved by some places, or without one. */
export function moved<Item>(items: readonly Item[], at: number, by: number): readonly Item[] {
  const others = items.filter((_, index) => index !== at);
  const item = items[at];
  return item === undefined ? items : others.toSpliced(at + by, 0, item);
}

function writtenStep(step: StepContent): StepContent {
  const { hint = [], check = [], quiz, puzzle, ...others } = step;
  const hints = hint.map((rule) => ({ ...rule, say: rule.say.filter((text) => !isBlank(text)) }));
  const checks = check.map(({ say, ...values }) => (isBlank(say as Texts) ? values : { ...values, say }));
  const choices = quiz?.choices.map(({ because, ...choice }) => (isBlank(because) ? choice : { ...choice, because }));
  return {
    ...others,
    ...(checks.length > 0 && { check: checks }),
    ...(hints.length > 0 && { hint: hints.filter((rule) => rule.say.length > 0) }),
    ...(puzzle && { puzzle: writtenPuzzle(puzzle) }),
    ...(quiz && { quiz: { question: quiz.question, choices: choices ?? [] } }),
  };
}

function writtenPuzzle({ also = [], distractors = [], ...others }: PuzzleContent): PuzzleContent {
  const isWritten = (text: string) => text.trim() !== "";
  return { ...others, also: also.filter(isWritten), distractors: distractors.filter(isWritten) };
}

/** Values without the languages in which a text is blank. */
function withoutBlanks(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(withoutBlanks);
  if (typeof value !== "object" || value === null) return value;
  const entries = Object.entries(value).map(([key, one]) => {
    const isText = TEXTS.has(key) || key === "say";
    return [key, isText && !Array.isArray(one) ? written(one as Texts) : withoutBlanks(one)] as const;
  });
  return Object.fromEntries(entries);
}

function written(text: Texts): Texts {
  return Object.fromEntries(Object.entries(text).filter(([, words]) => words.trim() !== ""));
}

function byLanguage(value: unknown, code: string): unknown {
  if (Array.isArray(value)) return value.map((one) => byLanguage(one, code));
  if (typeof value !== "object" || value === null) return value;
  const entries = Object.entries(value).map(([key, one]) => {
    if (TEXTS.has(key) && typeof one === "string") return [key, { [code]: one }] as const;
    if ((LISTS.has(key) || key === "say") && Array.isArray(one)) return [key, one.map((text) => textIn(text, code))];
    if (key === "say") return [key, textIn(one, code)];
    return [key, byLanguage(one, code)] as const;
  });
  return Object.fromEntries(entries);
}

function textIn(text: unknown, code: string): unknown {
  return typeof text === "string" ? { [code]: text } : text;
}

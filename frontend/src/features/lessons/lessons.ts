/** The lessons to choose from, and the one of the open project. */

import { computed, signal } from "@preact/signals";

import { language, say, t } from "../../i18n";
import type { Announcer } from "../../model/announcer";
import { browserId } from "../../model/browser-id";
import { type MissedPlace, missedPlace } from "../../model/missed";
import { arrange, preferences } from "../../model/preferences";
import type { Program } from "../../model/program";
import type { Connection } from "../../protocol/connection";
import {
  type LessonAttempt,
  type LessonChecked,
  type LessonChoice,
  type LessonGoal,
  type LessonGoals,
  type LessonHints,
  type LessonNotes,
  type LessonShown,
  LIMITS,
  type PuzzleJudged,
  type QuizJudged,
  type Welcome,
} from "../../protocol/messages";
import { bytesOf, inBase64, saveFile } from "../../ui/files";
import type { Toasts } from "../../ui/toasts";
import { type LessonFolder, lessonFolderOf } from "./folder";
import { LARGEST, LONGEST_NAME } from "./lesson-file";
import { inLanguage, sayWords } from "./texts";

export { inLanguage, sayWords };

/** Whether all its stars are earned; a lesson without stars is done once it was begun. */
export function isDone({ earned = 0, stars, project = "" }: LessonChoice): boolean {
  return stars > 0 ? earned >= stars : project !== "";
}

/** More marks would hide the world. */
const MOST_MISSED = 3;

/** Where a goal was missed; nothing if it was not, or has no place. */
function missedPlaces({ state, place, nearest, reason }: LessonGoal): readonly MissedPlace[] {
  return state === "failed" && place && nearest && reason ? [missedPlace(reason, place, nearest)] : [];
}

interface Others {
  readonly program: Program;
  readonly announcer: Announcer;
  readonly toasts: Toasts;
}

export class Lessons {
  /** Null until the server has sent them. */
  readonly choices = signal<readonly LessonChoice[] | null>(null);
  /** Whether this page may show what only the teacher has. */
  readonly teaches = signal(false);
  /** The lesson of the open project; null without one. */
  readonly shown = signal<LessonShown | null>(null);
  readonly goals = computed(() => this.news.value?.goals ?? this.shown.value?.goals ?? []);
  readonly steps = computed(() => this.news.value?.steps ?? this.shown.value?.steps ?? []);
  readonly checked = signal<LessonChecked | null>(null);
  readonly hints = signal<LessonHints | null>(null);
  readonly quiz = signal<QuizJudged | null>(null);
  /** The answers that are chosen, by their indices. */
  readonly chosen = signal<readonly number[]>([]);
  readonly puzzle = signal<PuzzleJudged | null>(null);
  /** What a lesson has for the teacher; null until the server has sent it. */
  readonly notes = signal<LessonNotes | null>(null);
  /** Stars that have just been earned, until the celebration is over; counts celebrations. */
  readonly party = signal(0);
  /** Whether a run has failed since the step was shown: then a hint is offered. */
  readonly failed = signal(false);
  /** What is known of the goals since the step was shown. */
  private readonly news = signal<LessonGoals | null>(null);
  private readonly live = signal(false);
  /** The lesson that was shown last. */
  private opened = "";
  /** The places that the last run has missed, the first ones of several. */
  readonly missed = computed(() =>
    this.live.value ? [] : this.goals.value.flatMap(missedPlaces).slice(0, MOST_MISSED),
  );
  private readonly browser = browserId();

  constructor(
    private readonly connection: Connection,
    private readonly others: Others,
  ) {
    connection.on("Lessons", ({ lessons, problems = [] }) => {
      this.choices.value = lessons;
      for (const problem of problems) others.toasts.error(say(problem));
    });
    connection.on("LessonShown", (shown) => this.show(shown));
    connection.on("LessonGoals", (goals) => this.judged(goals));
    connection.on("LessonChecked", (checked) => this.told(checked));
    connection.on("LessonHints", (hints) => (this.hints.value = hints));
    connection.on("QuizJudged", (judged) => this.answered(this.quiz, judged));
    connection.on("PuzzleJudged", (judged) => this.answered(this.puzzle, judged));
    connection.on("LessonNotes", (notes) => (this.notes.value = notes));
    connection.on("WorksheetMade", ({ filename, content }) => saveFile(filename, bytesOf(content), "text/html"));
    connection.on("LessonImported", ({ lesson, title }) => {
      others.toasts.note(t("page-lesson-imported", { title: inLanguage(title) }));
      this.start({ name: lesson, title });
    });
  }

  connected({ teaches = false }: Welcome): void {
    this.teaches.value = teaches;
    this.connection.send({ kind: "Introduce", browser: this.browser });
  }

  /** Forget the step that was shown. */
  reset(): void {
    this.shown.value = this.news.value = this.checked.value = this.hints.value = null;
    this.quiz.value = this.puzzle.value = null;
    this.chosen.value = [];
    this.failed.value = this.live.value = false;
  }

  /** Whether the program of a lesson runs and is being judged. */
  get isLive(): boolean {
    return this.live.value;
  }

  /** Whether the step asks something that has not been answered, right or wrong. */
  get isAsking(): boolean {
    const { quiz = null, puzzle = null } = this.shown.value ?? {};
    const isOpen = (question: { solved?: boolean } | null, judged: unknown) => question && !question.solved && !judged;
    return Boolean(isOpen(quiz, this.quiz.value) || isOpen(puzzle, this.puzzle.value));
  }

  /** Whether the step that is shown has earned a star. */
  get hasStar(): boolean {
    return (this.steps.value[(this.shown.value?.step ?? 1) - 1]?.earned ?? 0) > 0;
  }

  /** Whether each step that has stars has earned one. */
  get isFinished(): boolean {
    return this.steps.value.every(({ stars = 0, earned = 0 }) => stars === 0 || earned > 0);
  }

  list(): void {
    this.connection.send({ kind: "ListLessons" });
  }

  /** Go on with a lesson, or begin it; 0 for the step where the pupil is. */
  start(lesson: Pick<LessonChoice, "name" | "title">, again = false, step = 0): void {
    this.others.program.flush();
    this.opened = "";
    const { robot } = preferences.value;
    const name = inLanguage(lesson.title).slice(0, 80);
    this.connection.send({ kind: "StartLesson", lesson: lesson.name, name, robot, again, step });
  }

  showStep(step: number): void {
    this.others.program.flush();
    this.connection.send({ kind: "ShowStep", step });
  }

  restartStep(): void {
    this.others.program.flush();
    this.connection.send({ kind: "RestartStep" });
  }

  check(): void {
    this.others.program.showAllProblems();
    this.connection.send({ kind: "CheckStep" });
  }

  stopChecking(): void {
    this.connection.send({ kind: "StopChecking" });
  }

  /** Run the program where it has failed. */
  replay({ robot, variant = 0 }: LessonAttempt): void {
    this.connection.send({ kind: "ShowVariant", robot, variant });
  }

  takeHint(): void {
    this.connection.send({ kind: "TakeHint" });
  }

  choose(answers: readonly number[]): void {
    this.quiz.value = null;
    this.chosen.value = answers;
  }

  answerQuiz(): void {
    const { value: choices } = this.chosen;
    if (choices.length > 0) this.connection.send({ kind: "AnswerQuiz", choices: [...choices] });
  }

  answerPuzzle(order: readonly number[]): void {
    this.connection.send({ kind: "AnswerPuzzle", order: [...order] });
  }

  /** Add a lesson's file to the user's lessons, and begin it. */
  async import(file: File): Promise<void> {
    if (file.size > LARGEST) return this.others.toasts.error(t("page-lesson-too-large", { name: file.name }));
    const content = await inBase64(file);
    this.connection.send({ kind: "ImportLesson", filename: file.name.slice(-LONGEST_NAME), content });
  }

  /** Add a folder with a lesson to the user's lessons, and begin it. */
  async importFolder({ name, files }: LessonFolder): Promise<void> {
    const size = [...files.values()].reduce((sum, file) => sum + file.size, 0);
    if (size > LARGEST) return this.others.toasts.error(t("page-lesson-too-large", { name }));
    const read = [...files].map(async ([path, file]) => [path, await inBase64(file)] as const);
    const content = Object.fromEntries(await Promise.all(read));
    this.connection.send({
      kind: "ImportLessonFolder",
      name: name.slice(0, LIMITS.ImportLessonFolder.name),
      files: content,
    });
  }

  /** Add what the user has chosen as a folder, if it is a lesson. */
  takeFolder(files: readonly File[]): void {
    const folder = lessonFolderOf(files);
    if (folder) void this.importFolder(folder);
    else if (files.length > 0) this.others.toasts.error(t("page-lesson-no-folder"));
  }

  delete(lesson: string): void {
    this.connection.send({ kind: "DeleteLesson", lesson });
  }

  /** Ask for what a lesson has for the teacher. */
  readNotes(lesson: string): void {
    this.notes.value = null;
    this.connection.send({ kind: "ReadLessonNotes", lesson });
  }

  /** Save a lesson on paper, to print it. */
  saveWorksheet(lesson: string): void {
    this.connection.send({ kind: "MakeWorksheet", lesson, language: language.peek() });
  }

  private show(shown: LessonShown): void {
    const before = this.shown.peek();
    if (before?.name !== shown.name || before?.step !== shown.step) this.reset();
    this.news.value = null;
    // The output of another project would take the lesson's room.
    if (shown.name && shown.name !== this.opened) arrange({ panel: false });
    this.opened = shown.name ?? "";
    this.shown.value = shown.name ? shown : null;
  }

  private judged(goals: LessonGoals): void {
    const before = this.goals.peek();
    const { live = false, done = false, earned = 0 } = goals;
    this.news.value = goals.steps?.length ? goals : { ...goals, steps: [...this.steps.peek()] };
    this.live.value = live;
    const met = goals.goals.filter((goal, index) => goal.state === "met" && before[index]?.state !== "met");
    if (met.length > 0) {
      this.others.announcer.say(t("page-lesson-met-said", { goals: met.map((goal) => sayWords(goal.say)).join(", ") }));
    }
    if (live) {
      this.checked.value = null;
      this.hints.value = null;
    }
    if (earned > 0) this.celebrate();
    this.failed.value = !live && !done && goals.goals.some((goal) => goal.state === "failed");
  }

  private told(checked: LessonChecked): void {
    const before = this.checked.peek();
    this.checked.value = checked;
    if (before?.running && !checked.running) {
      this.others.announcer.say(t(checked.everywhere ? "page-lesson-everywhere-yes" : "page-lesson-everywhere-no"));
      if (checked.everywhere) this.party.value++;
    }
  }

  private answered<Judged extends { right: boolean }>(place: { value: Judged | null }, judged: Judged): void {
    place.value = judged;
    this.others.announcer.say(t(judged.right ? "page-lesson-right" : "page-lesson-wrong"));
    if (judged.right) this.party.value++;
  }

  private celebrate(): void {
    this.party.value++;
    this.others.announcer.say(t("page-lesson-star-said"));
  }
}

declare module "../../model/page" {
  interface Page {
    readonly lessons: Lessons;
  }
}

/** Lessons that a teacher makes or changes: the draft, its mistakes, and the trial of its solutions. */

import { effect, signal } from "@preact/signals";

import { language, t } from "../../i18n";
import type { Dialogs } from "../../model/dialogs";
import type { Program } from "../../model/program";
import type { Connection } from "../../protocol/connection";
import type { EditedStep, LessonExamined, LessonTried, WrittenProgram } from "../../protocol/messages";
import { bytesOf, saveFile } from "../../ui/files";
import type { Path } from "../../ui/form/form";
import { UnsavedEdits } from "../../ui/storage";
import type { Toasts } from "../../ui/toasts";
import {
  draftOf,
  EMPTY_PROGRAM,
  editedOf,
  type LessonContent,
  type LessonEdit,
  moved,
  NEW_STEP,
  type StepContent,
} from "./lesson-edit";
import { inLanguage, type Lessons } from "./lessons";

/** ms without an edit before the server examines the lesson. */
const PAUSE = 400;
export const MOST_STEPS = 30;

/** By the name that a lesson was saved under; a new lesson has the empty name. */
const UNSAVED = new UnsavedEdits<LessonEdit>("learnblock.lessons");

/** What the editor shows: what the lesson is about, a step by its index, or what is for the teacher. */
export type Section = "about" | "teacher" | number;

interface Others {
  readonly program: Program;
  readonly dialogs: Dialogs;
  readonly toasts: Toasts;
  readonly lessons: Lessons;
}

export class LessonMaking {
  /** Null if no lesson is being made. */
  readonly draft = signal<LessonEdit | null>(null);
  readonly examined = signal<LessonExamined>({ kind: "LessonExamined" });
  /** The names of the skills that checks may ask for. */
  readonly skills = signal<readonly string[]>([]);
  readonly tried = signal<LessonTried | null>(null);
  readonly section = signal<Section>("about");
  /** The language in which the teacher writes. */
  readonly writing = signal("en");
  readonly isSaved = signal(true);
  /** Whether mistakes are shown: only once the teacher wants to save or try the lesson. */
  readonly isStrict = signal(false);
  /** Whether the lesson is downloaded once it is saved: for pupils, or with the teacher's part. */
  private download: "pupils" | "teacher" | null = null;
  private timer = 0;

  constructor(
    private readonly connection: Connection,
    private readonly others: Others,
  ) {
    connection.on("LessonToEdit", ({ edited, skills = [] }) => {
      this.skills.value = skills;
      const draft = draftOf(edited, language.peek());
      const left = UNSAVED.read(draft.lesson);
      this.show(left ?? draft, { isSaved: draft.lesson !== "" && !left });
    });
    connection.on("LessonExamined", (examined) => this.learn(examined));
    connection.on("LessonTried", (tried) => (this.tried.value = tried));
    connection.on("LessonSaved", ({ lesson }) => this.saved(lesson));
    connection.on("LessonExported", ({ filename, content }) => saveFile(filename, bytesOf(content), "application/zip"));
    effect(() => this.examineSoon(this.draft.value));
  }

  /** Make a lesson of the open project, or go on with the unsaved one. */
  make(): void {
    this.others.program.flush();
    const left = UNSAVED.read("");
    if (left) this.show(left, { isSaved: false });
    else this.connection.send({ kind: "MakeLesson" });
  }

  change(lesson: string): void {
    this.connection.send({ kind: "ChangeLesson", lesson });
  }

  /** Make a lesson of the user's of any lesson, and change it. */
  copy(lesson: string): void {
    this.connection.send({ kind: "CopyLesson", lesson });
    this.others.lessons.list();
  }

  edit(change: (draft: LessonEdit) => LessonEdit): void {
    const { draft } = this;
    if (!draft.value) return;
    draft.value = change(draft.value);
    this.isSaved.value = false;
    UNSAVED.keep(draft.value.lesson, draft.value);
  }

  editContent(values: Partial<LessonContent>): void {
    this.edit((draft) => ({ ...draft, content: { ...draft.content, ...values } }));
  }

  editStep(index: number, values: Partial<StepContent>): void {
    this.edit((draft) => {
      const step = draft.content.step.map((one, at) => (at === index ? { ...one, ...values } : one));
      return { ...draft, content: { ...draft.content, step } };
    });
  }

  editPrograms(index: number, values: Partial<EditedStep>): void {
    this.edit((draft) => {
      const steps = draft.content.step.map((_, at) => ({ ...draft.steps[at], ...(at === index && values) }));
      return { ...draft, steps };
    });
  }

  /** Add a program of a puzzle under a free name; return the name of its file. */
  addProgram(stem: string, { text }: WrittenProgram): string {
    const known = this.draft.value?.programs ?? {};
    const numbers = Array.from({ length: MOST_STEPS + 1 }, (_, index) => `${stem}-${index + 1}.bt`);
    const file = numbers.find((name) => !(name in known)) ?? `${stem}.bt`;
    this.editProgram(file, text);
    return file;
  }

  editProgram(file: string, text: string): void {
    this.edit((draft) => ({ ...draft, programs: { ...draft.programs, [file]: text } }));
  }

  addStep(): void {
    const count = this.draft.value?.content.step.length ?? 0;
    this.editSteps(
      (steps) => [...steps, NEW_STEP],
      (steps) => [...steps, {}],
    );
    this.section.value = count;
  }

  moveStep(index: number, by: number): void {
    this.editSteps(
      (steps) => moved(steps, index, by),
      (steps) => moved(steps, index, by),
    );
    this.section.value = index + by;
  }

  deleteStep(index: number): void {
    this.editSteps(
      (steps) => steps.filter((_, at) => at !== index),
      (steps) => steps.filter((_, at) => at !== index),
    );
    this.section.value = Math.max(0, index - 1);
  }

  /** Forget what is not saved: a saved lesson is shown as it is, and a new one is given up. */
  discard(): void {
    const { lesson = "" } = this.draft.value ?? {};
    UNSAVED.drop(lesson);
    if (lesson) return this.change(lesson);
    this.others.dialogs.close();
    this.draft.value = null;
    this.isSaved.value = true;
  }

  save(): void {
    this.download = null;
    this.send("SaveLesson");
  }

  /** Save the lesson if that is necessary, and download it. */
  saveAndDownload(what: "pupils" | "teacher"): void {
    const lesson = this.draft.value?.lesson;
    if (lesson && this.isSaved.value) return this.export(lesson, what);
    this.save();
    this.download = what;
  }

  export(lesson: string, what: "pupils" | "teacher"): void {
    this.connection.send({ kind: "ExportLesson", lesson, for_pupils: what === "pupils" });
  }

  tryIt(): void {
    this.tried.value = null;
    this.send("TryLesson");
  }

  stopTrying(): void {
    this.connection.send({ kind: "StopTrying" });
  }

  /** Close the dialog; what is not saved can be edited further. */
  close(): void {
    this.stopTrying();
    this.others.dialogs.close();
    if (!this.draft.value || this.isSaved.value) return;
    const reopen = () => this.others.dialogs.show("lessonEditor");
    const title = inLanguage(this.draft.value.content.title);
    this.others.toasts.show({
      sort: "note",
      text: t("page-maker-unsaved", { title }),
      action: { text: t("page-maker-go-on"), run: reopen },
    });
  }

  /** The mistakes at a place, or below it. */
  problemsAt(path: Path): readonly NonNullable<LessonExamined["problems"]>[number][] {
    if (!this.isStrict.value) return [];
    const isThere = (other: Path) => path.every((step, index) => other[index] === step);
    return (this.examined.value.problems ?? []).filter((one) => isThere(one.path));
  }

  /** The open program; null if none is open. */
  openProgram(): WrittenProgram | null {
    const text = this.others.program.state.value.blocktext;
    return text.trim() ? { text } : null;
  }

  private show(draft: LessonEdit, { isSaved }: { readonly isSaved: boolean }): void {
    this.isStrict.value = false;
    this.tried.value = null;
    this.section.value = "about";
    this.writing.value = language.peek();
    const steps = draft.content.step.map((_, index) => draft.steps[index] ?? { program: EMPTY_PROGRAM });
    this.draft.value = { ...draft, steps };
    this.isSaved.value = isSaved;
    this.others.dialogs.show("lessonEditor");
  }

  private editSteps(
    change: (steps: readonly StepContent[]) => readonly StepContent[],
    changePrograms: (steps: readonly EditedStep[]) => readonly EditedStep[],
  ): void {
    this.edit((draft) => ({
      ...draft,
      content: { ...draft.content, step: change(draft.content.step) },
      steps: changePrograms(draft.steps),
    }));
  }

  private examineSoon(draft: LessonEdit | null): void {
    clearTimeout(this.timer);
    if (draft) this.timer = window.setTimeout(() => this.send("ExamineLesson"), PAUSE);
  }

  private send(kind: "ExamineLesson" | "SaveLesson" | "TryLesson"): void {
    if (this.draft.value) this.connection.send({ kind, edited: editedOf(this.draft.value) });
  }

  private learn(examined: LessonExamined): void {
    this.examined.value = examined;
    if (examined.refused) {
      this.isStrict.value = true;
      this.download = null;
    }
  }

  private saved(lesson: string): void {
    const { draft, download } = this;
    if (!draft.value) return;
    UNSAVED.drop(draft.value.lesson);
    const steps = draft.value.steps.map((step, index) => ({ ...step, before: index + 1 }));
    draft.value = { ...draft.value, lesson, steps };
    this.isSaved.value = true;
    this.isStrict.value = false;
    this.others.toasts.note(t("page-maker-saved", { title: inLanguage(draft.value.content.title) }));
    this.others.lessons.list();
    if (download) this.export(lesson, download);
    this.download = null;
  }
}

declare module "../../model/page" {
  interface Page {
    readonly lessonMaking: LessonMaking;
  }
}

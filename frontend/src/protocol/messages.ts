/** The conversation with the server; written by `python -m learnblock.server.typescript`. */

import type { Phrase } from "../i18n";
import type { RobotDescription, WorldFile } from "./world";

export type Notation = "blocktext" | "python";

export type View = "blocks" | "blocktext" | "python";

export interface AddTab {
  kind: "AddTab";
  robot: string;
  count?: number;
  request?: number;
}

export interface AllowNetwork {
  kind: "AllowNetwork";
  allowed: boolean;
  key: string;
  request?: number;
}

export interface Answer {
  kind: "Answer";
  text: string;
  request?: number;
}

export interface AnswerPuzzle {
  kind: "AnswerPuzzle";
  order: number[];
  request?: number;
}

export interface AnswerQuiz {
  kind: "AnswerQuiz";
  choices: number[];
  request?: number;
}

export interface AskWhy {
  kind: "AskWhy";
  question: WhyQuestion;
  request?: number;
}

export interface Asked {
  question: WhyQuestion;
  phrase: Phrase;
  block: string | null;
}

export interface AtSeat {
  kind: "AtSeat";
  work: Work;
  successes?: number;
  scene?: Scene | null;
}

export interface BeginRobot {
  kind: "BeginRobot";
  request?: number;
}

export interface Block {
  type: string;
  id: string;
  x?: number | null;
  y?: number | null;
  fields?: Record<string, string | number | boolean | Record<string, string> | null>;
  inputs?: Record<string, Input>;
  extraState?: unknown;
  comment?: BlockComment | null;
  data?: string | null;
  collapsed?: boolean;
  disabledReasons?: string[];
  inline?: boolean | null;
}

export interface BlockComment {
  text: string;
  pinned?: boolean;
  width?: number | null;
  height?: number | null;
}

export interface BlockNames {
  categories?: string[];
  blocks?: string[];
}

export interface BlockSet {
  name?: string;
  title?: Record<string, string>;
  description?: Record<string, string>;
  show?: BlockNames;
  hide?: BlockNames;
}

export interface BlockSetRead {
  kind: "BlockSetRead";
  set: BlockSet;
}

export interface BlockSets {
  kind: "BlockSets";
  ours: BlockSet[];
  own: BlockSet[];
  problems?: Phrase[];
}

export interface BlocksShown {
  kind: "BlocksShown";
  set: BlockSet;
  carried?: BlockSet[];
}

export interface Bumped {
  kind: "Bumped";
  time: number;
  thing: Phrase;
}

export interface CallEdge {
  caller: number;
  callee: number;
  count: number;
  seconds: number;
  share: number;
  first: number;
  event: number;
}

export interface CallGraph {
  kind: "CallGraph";
  robot: string;
  first: number;
  last: number;
  functions?: CalledFunction[];
  edges?: CallEdge[];
}

export interface CalledFunction {
  layer: number;
  name: string;
  count: number;
  seconds: number;
  share: number;
}

export interface CallsBeside {
  kind: "CallsBeside";
  first: CallGraph;
  second: CallGraph;
}

export interface CameraFrame {
  kind: "CameraFrame";
  width: number;
  height: number;
  time: number;
  seen?: Seen[];
  past?: boolean;
}

export interface ChangeLesson {
  kind: "ChangeLesson";
  lesson: string;
  request?: number;
}

export interface ChangeSettings {
  kind: "ChangeSettings";
  robot: string;
  values: Record<string, unknown>;
  agreed?: boolean;
  request?: number;
}

export interface CheckCustomBlock {
  kind: "CheckCustomBlock";
  name: string;
  source: string;
  configuration?: string;
  replaces?: string;
  language?: string;
  request?: number;
}

export interface CheckStep {
  kind: "CheckStep";
  request?: number;
}

export interface CheckWorld {
  kind: "CheckWorld";
  world: WorldFile;
  request?: number;
}

export interface ChooseBlockSet {
  kind: "ChooseBlockSet";
  set: BlockSet;
  request?: number;
}

export interface ChooseRobot {
  kind: "ChooseRobot";
  name: string;
  request?: number;
}

export interface ChooseWorld {
  kind: "ChooseWorld";
  name: string;
  variant?: number;
  request?: number;
}

export interface CloseProject {
  kind: "CloseProject";
  request?: number;
}

export interface CloseRun {
  kind: "CloseRun";
  request?: number;
}

export interface CloseTab {
  kind: "CloseTab";
  name: string;
  request?: number;
}

export interface CodeOffered {
  kind: "CodeOffered";
  blocks?: OfferedCode[];
  libraries?: OfferedCode[];
}

export interface CompareRuns {
  kind: "CompareRuns";
  first: string;
  second: string;
  request?: number;
}

export interface ComparedRun {
  id: string;
  way: [number, number, number][];
  step: RunStep | null;
}

export interface Complete {
  kind: "Complete";
  notation: "blocktext" | "python";
  line: number;
  column: number;
  language?: string;
  request?: number;
}

export interface Completion {
  label: string;
  insert: string;
  sort: string;
  detail?: string;
  help?: string;
  category?: string;
}

export interface Completions {
  kind: "Completions";
  request: number;
  from_column: number;
  options: Completion[];
}

export interface Conflict {
  kind: "Conflict";
  version: string;
  by: "before" | "file" | "page";
}

export interface ConnectRobot {
  kind: "ConnectRobot";
  id: string;
  request?: number;
}

export interface Containment {
  kind: "Containment";
  findings: Finding[];
}

export interface ConvertLibrary {
  kind: "ConvertLibrary";
  filename: string;
  content: string;
  python?: string | null;
  configuration?: string | null;
  request?: number;
}

export interface CopyLesson {
  kind: "CopyLesson";
  lesson: string;
  request?: number;
}

export interface CopyProject {
  kind: "CopyProject";
  project: string;
  name: string;
  request?: number;
}

export interface CorrectRobot {
  kind: "CorrectRobot";
  distance?: number;
  angle?: number;
  save?: boolean;
  request?: number;
}

export interface Correction {
  setting: string;
  before: number;
  after: number;
}

export interface CustomBlock {
  name: string;
  category: string;
  blocks: string[];
  source: string;
  configuration: string;
  problems: CustomBlockProblem[];
}

export interface CustomBlockChecked {
  kind: "CustomBlockChecked";
  request: number;
  problems?: CustomBlockProblem[];
  configuration?: string;
  chosen?: string;
  previews?: CustomBlockPreview[];
}

export interface CustomBlockPreview {
  name: string;
  definition: Record<string, unknown>;
  block: Record<string, unknown>;
}

export interface CustomBlockProblem {
  part: "configuration" | "name" | "source";
  code: string;
  message: Phrase;
  severity: "error" | "warning";
  line?: number;
  column?: number;
  end_column?: number;
}

export interface CustomBlockSaved {
  kind: "CustomBlockSaved";
  name: string;
}

export interface CustomBlocks {
  kind: "CustomBlocks";
  blocks: CustomBlock[];
}

export interface Delete {
  kind: "Delete";
  name: string;
  request?: number;
}

export interface DeleteBlockSet {
  kind: "DeleteBlockSet";
  name: string;
  request?: number;
}

export interface DeleteCustomBlock {
  kind: "DeleteCustomBlock";
  name: string;
  request?: number;
}

export interface DeleteLesson {
  kind: "DeleteLesson";
  lesson: string;
  request?: number;
}

export interface DeleteRun {
  kind: "DeleteRun";
  run: string;
  request?: number;
}

export interface DeleteWorld {
  kind: "DeleteWorld";
  name: string;
  request?: number;
}

export interface Describe {
  kind: "Describe";
  notation: "blocktext" | "python";
  line: number;
  column: number;
  language?: string;
  request?: number;
}

export interface Description {
  kind: "Description";
  title?: string;
  text?: string;
  needs?: string[];
  serves?: Phrase | null;
  line?: number;
  column?: number;
  from_column?: number;
  to_column?: number;
  sort?: "" | "function" | "variable" | "when";
  name?: string;
  request: number;
}

export interface DisconnectRobot {
  kind: "DisconnectRobot";
  request?: number;
}

export interface Document {
  kind: "Document";
  edit: number;
  revision: number;
  origin: "blocks" | "blocktext" | "python";
  blocktext?: string | null;
  python?: string | null;
  workspace?: Workspace | null;
  places?: Place[];
  problems?: Problem[];
  stale?: ("blocks" | "blocktext" | "python")[];
  asked?: string[];
  can_undo?: boolean;
  can_redo?: boolean;
}

export interface Done {
  kind: "Done";
  request: number;
}

export interface DownloadLibrary {
  kind: "DownloadLibrary";
  name: string;
  request?: number;
}

export interface Drawing {
  kind: "Drawing";
  fresh: boolean;
  parts?: StrokePart[];
}

export interface Drive {
  kind: "Drive";
  advance: number;
  rotation: number;
  request?: number;
}

export interface DuplicateCustomBlock {
  kind: "DuplicateCustomBlock";
  name: string;
  new: string;
  request?: number;
}

export interface EditBlocks {
  kind: "EditBlocks";
  edit: number;
  workspace: Workspace;
  revision?: number;
  shown?: number;
  request?: number;
}

export interface EditText {
  kind: "EditText";
  edit: number;
  notation: "blocktext" | "python";
  text: string;
  revision?: number;
  shown?: number;
  request?: number;
}

export interface EditedLesson {
  content: Record<string, unknown>;
  steps?: EditedStep[];
  lesson?: string;
  programs?: Record<string, string>;
  notes?: Record<string, string>;
}

export interface EditedStep {
  before?: number;
  program?: WrittenProgram | null;
  solution?: WrittenProgram | null;
}

export interface Ended {
  kind: "Ended";
  ended: string;
  message?: Phrase | null;
  block?: string | null;
  line?: number;
  time?: number;
  distance?: number | null;
  goals?: GoalNow[];
  emotions?: string[];
  no_effect?: [string, string][];
  trace_sha256?: string;
  repeatable?: boolean;
  custom_block?: string;
  custom_line?: number;
  tried?: boolean;
  others?: boolean;
}

export interface ExamineLesson {
  kind: "ExamineLesson";
  edited: EditedLesson;
  request?: number;
}

export interface ExaminedStep {
  checks?: (Phrase | null)[];
  goals?: string[];
  lines?: string[];
}

export interface ExampleChoice {
  name: string;
  title: string;
  description: string;
  robot: string;
  world: string;
  robots?: number;
  stage?: "coder" | "explorer" | "starter";
  is_first?: boolean;
}

export interface Export {
  kind: "Export";
  format: "bt" | "learnblock" | "py";
  project?: string;
  request?: number;
}

export interface ExportBlockSet {
  kind: "ExportBlockSet";
  set: BlockSet;
  request?: number;
}

export interface ExportCustomBlock {
  kind: "ExportCustomBlock";
  name: string;
  request?: number;
}

export interface ExportLesson {
  kind: "ExportLesson";
  lesson: string;
  for_pupils?: boolean;
  request?: number;
}

export interface ExportTags {
  kind: "ExportTags";
  format?: "csv" | "html" | "toml";
  request?: number;
}

export interface ExportWorld {
  kind: "ExportWorld";
  name: string;
  request?: number;
}

export interface Exportable {
  kind: "Exportable";
  functions: ExportableFunction[];
  own: ExportableBlocks[];
}

export interface ExportableBlocks {
  name: string;
  blocks: string[];
}

export interface ExportableFunction {
  name: string;
  parameters: string[];
  takes_along?: string[];
  problem?: Phrase | null;
}

export interface Failed {
  kind: "Failed";
  message: Phrase;
  refused?: string;
  request?: number;
}

export interface File {
  kind: "File";
  filename: string;
  text: string;
}

export interface FindRobots {
  kind: "FindRobots";
  on: boolean;
  request?: number;
}

export interface Finding {
  name: Phrase;
  contained: boolean;
  reason: Phrase;
}

export interface Format {
  kind: "Format";
  request?: number;
}

export interface GoalNow {
  name: string;
  sort: string;
  state: "failed" | "open" | "reached";
  time: number | null;
}

export interface HandleRobot {
  kind: "HandleRobot";
  how: "back" | "front" | "left" | "level" | "right" | "shake";
  request?: number;
}

export interface History {
  kind: "History";
  versions: Version[];
  runs: PastRun[];
}

export interface HoldKeys {
  kind: "HoldKeys";
  keys: ("0" | "1" | "2" | "3" | "4" | "5" | "6" | "7" | "8" | "9" | "a" | "b" | "c" | "d" | "down" | "e" | "enter" | "f" | "g" | "h" | "i" | "j" | "k" | "l" | "left" | "m" | "n" | "o" | "p" | "q" | "r" | "right" | "s" | "space" | "t" | "u" | "up" | "v" | "w" | "x" | "y" | "z")[];
  request?: number;
}

export interface Import {
  kind: "Import";
  filename: string;
  text: string;
  request?: number;
}

export interface ImportCustomBlock {
  kind: "ImportCustomBlock";
  content: string;
  replace?: boolean;
  request?: number;
}

export interface ImportLesson {
  kind: "ImportLesson";
  filename: string;
  content: string;
  request?: number;
}

export interface ImportLessonFolder {
  kind: "ImportLessonFolder";
  name: string;
  files: Record<string, string>;
  request?: number;
}

export interface ImportLibraries {
  kind: "ImportLibraries";
  files: LibraryFile[];
  replace?: boolean;
  request?: number;
}

export interface ImportOriginal {
  kind: "ImportOriginal";
  filename: string;
  content: string;
  libraries?: Record<string, string>;
  request?: number;
}

export interface ImportWorld {
  kind: "ImportWorld";
  filename: string;
  content: string;
  request?: number;
}

export interface Input {
  block?: Block | null;
  shadow?: Block | null;
  stack?: Block[];
}

export interface InputWanted {
  kind: "InputWanted";
  prompt: string;
}

export interface InstallOffered {
  kind: "InstallOffered";
  request?: number;
}

export interface InstalledLibrary {
  name: string;
  version?: string;
  title?: Record<string, string>;
  description?: string;
  skills?: string[];
  problem?: Phrase | null;
}

export interface Introduce {
  kind: "Introduce";
  browser: string;
  request?: number;
}

export interface KeepPicture {
  kind: "KeepPicture";
  project: string;
  content: string;
  request?: number;
}

export interface KeptRun {
  id: string;
  time: number;
  size?: number;
  name?: string;
  program?: string;
  identity?: string;
  robot?: string;
  world?: string;
  variant?: number;
  seconds?: number;
  ended?: string;
  reached?: string[];
  missed?: number;
  foreign?: boolean;
  damaged?: boolean;
  version?: string;
}

export interface KeptRuns {
  kind: "KeptRuns";
  runs: KeptRun[];
}

export interface KeysWanted {
  kind: "KeysWanted";
  keys: ("0" | "1" | "2" | "3" | "4" | "5" | "6" | "7" | "8" | "9" | "a" | "b" | "c" | "d" | "down" | "e" | "enter" | "f" | "g" | "h" | "i" | "j" | "k" | "l" | "left" | "m" | "n" | "o" | "p" | "q" | "r" | "right" | "s" | "space" | "t" | "u" | "up" | "v" | "w" | "x" | "y" | "z")[];
  programs?: number;
}

export interface KnownRobot {
  robot: string;
  name?: string;
  used?: boolean;
  is_busy?: boolean;
  add_on?: string;
}

export interface LessonAttempt {
  robot: string;
  variant?: number;
  passed?: boolean | null;
  reasons?: Phrase[];
}

export interface LessonChecked {
  kind: "LessonChecked";
  attempts?: LessonAttempt[];
  running?: boolean;
  everywhere?: boolean;
  problem?: Phrase | null;
}

export interface LessonChoice {
  name: string;
  title: string | Record<string, string>;
  level: number;
  minutes: number;
  aims: (string | Record<string, string>)[];
  robots: string[];
  steps: number;
  stars: number;
  picture?: string;
  own?: boolean;
  earned?: number;
  step?: number;
  project?: string;
}

export interface LessonExamined {
  kind: "LessonExamined";
  problems?: LessonProblem[];
  steps?: ExaminedStep[];
  drawings?: Record<string, Workspace>;
  refused?: boolean;
}

export interface LessonExported {
  kind: "LessonExported";
  filename: string;
  content: string;
}

export interface LessonGoal {
  say: LessonWords;
  state?: "failed" | "met" | "open";
  optional?: boolean;
  reason?: Phrase | null;
  earned?: boolean;
  ask?: "" | "bump" | "goal" | "now";
  subject?: string;
}

export interface LessonGoals {
  kind: "LessonGoals";
  goals: LessonGoal[];
  live?: boolean;
  done?: boolean;
  earned?: number;
  steps?: LessonStep[];
}

export interface LessonHint {
  levels: LessonWords[];
}

export interface LessonHints {
  kind: "LessonHints";
  hints?: LessonHint[];
  more?: boolean;
  count?: number;
}

export interface LessonImported {
  kind: "LessonImported";
  lesson: string;
  title: string | Record<string, string>;
}

export interface LessonNotes {
  kind: "LessonNotes";
  lesson: string;
  title: string | Record<string, string>;
  notes?: Record<string, string>;
  drawings?: Record<string, Workspace>;
  steps?: SolvedStep[];
}

export interface LessonProblem {
  path: (string | number)[];
  message: Phrase;
}

export interface LessonPuzzle {
  pieces: string[];
  solved?: boolean;
}

export interface LessonQuiz {
  question: string | Record<string, string>;
  choices: (string | Record<string, string>)[];
  several?: boolean;
  solved?: boolean;
}

export interface LessonSaved {
  kind: "LessonSaved";
  lesson: string;
}

export interface LessonShown {
  kind: "LessonShown";
  name?: string;
  title?: string | Record<string, string>;
  level?: number;
  steps?: LessonStep[];
  step?: number;
  text?: string | Record<string, string>;
  drawings?: Record<string, Workspace>;
  goals?: LessonGoal[];
  attempts?: number;
  everywhere?: boolean;
  hints?: number;
  quiz?: LessonQuiz | null;
  puzzle?: LessonPuzzle | null;
  restarts?: boolean;
}

export interface LessonStep {
  title: string | Record<string, string>;
  phase: "investigate" | "make" | "modify" | "predict" | "run";
  stars?: number;
  earned?: number;
}

export interface LessonToEdit {
  kind: "LessonToEdit";
  edited: EditedLesson;
  skills?: string[];
}

export interface LessonTried {
  kind: "LessonTried";
  programs?: TriedProgram[];
  done?: number;
  count?: number;
  running?: boolean;
  problem?: Phrase | null;
}

export interface LessonWords {
  text?: string | Record<string, string>;
  phrase?: Phrase | null;
}

export interface Lessons {
  kind: "Lessons";
  lessons: LessonChoice[];
  problems?: Phrase[];
}

export interface Libraries {
  kind: "Libraries";
  libraries: InstalledLibrary[];
}

export interface LibrariesRead {
  kind: "LibrariesRead";
  files: LibraryRead[];
}

export interface LibraryConverted {
  kind: "LibraryConverted";
  filename: string;
  content: string;
  changed: Phrase[];
  missing: Phrase[];
}

export interface LibraryFile {
  filename: string;
  content: string;
  renames?: Record<string, string>;
}

export interface LibraryMade {
  kind: "LibraryMade";
  filename: string;
  content: string;
}

export interface LibraryRead {
  filename: string;
  library?: InstalledLibrary | null;
  installed?: string;
  is_newer?: boolean;
  clashes?: SkillClash[];
  problem?: Phrase | null;
}

export interface ListBlockSets {
  kind: "ListBlockSets";
  request?: number;
}

export interface ListCustomBlocks {
  kind: "ListCustomBlocks";
  request?: number;
}

export interface ListExportable {
  kind: "ListExportable";
  request?: number;
}

export interface ListHistory {
  kind: "ListHistory";
  request?: number;
}

export interface ListLessons {
  kind: "ListLessons";
  request?: number;
}

export interface ListLibraries {
  kind: "ListLibraries";
  request?: number;
}

export interface ListProjects {
  kind: "ListProjects";
  request?: number;
}

export interface ListRuns {
  kind: "ListRuns";
  request?: number;
}

export interface LookBack {
  kind: "LookBack";
  time: number;
  event?: number | null;
  step?: number;
  to?: "change" | "event" | "line" | "mark" | "run" | "turn";
  subject?: string;
  request?: number;
}

export interface MakeLesson {
  kind: "MakeLesson";
  request?: number;
}

export interface MakeLibrary {
  kind: "MakeLibrary";
  name: string;
  version: string;
  title?: Record<string, string>;
  functions?: string[];
  own?: string[];
  request?: number;
}

export interface MakeRobot {
  kind: "MakeRobot";
  name: string;
  description: string;
  request?: number;
}

export interface MakeWorld {
  kind: "MakeWorld";
  template: "field" | "maze" | "track";
  size: number;
  seed: number;
  request?: number;
}

export interface NameRobot {
  kind: "NameRobot";
  robot: string;
  name: string;
  request?: number;
}

export interface NameRun {
  kind: "NameRun";
  run: string;
  name: string;
  request?: number;
}

export interface NearbyRobot {
  id: string;
  robot: string;
  way: "bluetooth" | "computer" | "usb" | "wifi";
  place?: string;
}

export interface Network {
  kind: "Network";
  allowed: boolean;
  key?: string;
  reason?: Phrase | null;
}

export interface New {
  kind: "New";
  name?: string;
  example?: string | null;
  robot?: string;
  request?: number;
}

export interface Noted {
  kind: "Noted";
  message: Phrase;
}

export interface OfferedCode {
  name: string;
  source: string;
  replaces: boolean;
}

export interface Open {
  kind: "Open";
  name: string;
  tab?: string;
  request?: number;
}

export interface OpenExample {
  kind: "OpenExample";
  name: string;
  example: string;
  robot?: string;
  request?: number;
}

export interface OpenRun {
  kind: "OpenRun";
  run: string;
  request?: number;
}

export interface OpenTab {
  kind: "OpenTab";
  name: string;
  robot?: string;
  request?: number;
}

export interface Opened {
  kind: "Opened";
  name: string;
  robot: string;
  world: string;
  breakpoints?: string[];
  tab?: string;
}

export interface OriginalImported {
  kind: "OriginalImported";
  filename: string;
  changed: Phrase[];
  missing: Phrase[];
}

export interface PaletteChanged {
  kind: "PaletteChanged";
}

export interface Past {
  kind: "Past";
  time: number;
  event: number;
  line: RunningLine;
  variables: Variables;
  found?: boolean;
  values?: ValueThere[];
  stack?: string[];
  printed?: number;
  telemetry?: Telemetry | null;
  drawing?: Drawing | null;
}

export interface PastRun {
  time: number;
  robot: string;
  world: string;
  ended: string;
  seconds: number;
  goals: string[];
  trace_sha256: string;
  version: string;
}

export interface Pause {
  kind: "Pause";
  request?: number;
}

export type Place = [block: string, blocktext: number, blocktext_end: number, python: number, python_end: number];

export interface PlaceRobot {
  kind: "PlaceRobot";
  x: number;
  y: number;
  heading: number;
  request?: number;
}

export interface Predicted {
  kind: "Predicted";
  way?: [number, number, number, number][];
  parted?: number | null;
  findings?: TwinFinding[];
  unrecorded?: Phrase[];
}

export interface Printed {
  kind: "Printed";
  text: string;
  until?: number;
}

export interface PrintedByRobots {
  kind: "PrintedByRobots";
  parts: PrintedPart[];
}

export interface PrintedPart {
  robot: string;
  text: string;
  until: number;
}

export interface Problem {
  code: string;
  message: Phrase;
  severity: "error" | "warning";
  view: "blocks" | "blocktext" | "python";
  line?: number;
  column?: number;
  end_column?: number;
  block?: string | null;
  in_blocks?: Phrase | null;
}

export interface ProjectEntry {
  name: string;
  changed: number;
  picture: number;
}

export interface ProjectRenamed {
  kind: "ProjectRenamed";
  name: string;
}

export interface Projects {
  kind: "Projects";
  projects: ProjectEntry[];
}

export interface PuzzleJudged {
  kind: "PuzzleJudged";
  right: boolean;
  good?: number;
}

export interface Quantity {
  unit: string;
  lowest: number;
  highest: number;
  digits: number;
}

export interface Questions {
  kind: "Questions";
  questions: Asked[];
  block?: string;
}

export interface QuizJudged {
  kind: "QuizJudged";
  right: boolean;
  because?: Record<string, string | Record<string, string>>;
}

export interface ReadBlockSet {
  kind: "ReadBlockSet";
  filename: string;
  text: string;
  request?: number;
}

export interface ReadCalls {
  kind: "ReadCalls";
  first?: number;
  last?: number | null;
  request?: number;
}

export interface ReadCallsBeside {
  kind: "ReadCallsBeside";
  first: string;
  second: string;
  request?: number;
}

export interface ReadContainment {
  kind: "ReadContainment";
  request?: number;
}

export interface ReadLessonNotes {
  kind: "ReadLessonNotes";
  lesson: string;
  request?: number;
}

export interface ReadLibraries {
  kind: "ReadLibraries";
  files: LibraryFile[];
  request?: number;
}

export interface ReadNetwork {
  kind: "ReadNetwork";
  request?: number;
}

export interface ReadPastPicture {
  kind: "ReadPastPicture";
  time: number;
  request?: number;
}

export interface ReadPrediction {
  kind: "ReadPrediction";
  request?: number;
}

export interface ReadQuestions {
  kind: "ReadQuestions";
  block?: string;
  time?: number | null;
  request?: number;
}

export interface ReadRunsOn {
  kind: "ReadRunsOn";
  request?: number;
}

export interface ReadSettings {
  kind: "ReadSettings";
  robot?: string;
  request?: number;
}

export interface ReadTags {
  kind: "ReadTags";
  filename: string;
  text: string;
  request?: number;
}

export interface ReadTimeline {
  kind: "ReadTimeline";
  request?: number;
}

export interface ReadValues {
  kind: "ReadValues";
  request?: number;
}

export interface ReadWorld {
  kind: "ReadWorld";
  name: string;
  request?: number;
}

export interface RecoverBlocks {
  kind: "RecoverBlocks";
  edit: number;
  workspace: Workspace;
  base: Workspace;
  shown?: number;
  request?: number;
}

export interface RecoverText {
  kind: "RecoverText";
  edit: number;
  notation: "blocktext" | "python";
  text: string;
  base: string;
  shown?: number;
  request?: number;
}

export interface Redo {
  kind: "Redo";
  request?: number;
}

export interface RemoveLibrary {
  kind: "RemoveLibrary";
  name: string;
  request?: number;
}

export interface Rename {
  kind: "Rename";
  sort: "function" | "variable" | "when";
  name: string;
  new: string;
  request?: number;
}

export interface RenameProject {
  kind: "RenameProject";
  name: string;
  project?: string;
  request?: number;
}

export interface RenameTab {
  kind: "RenameTab";
  name: string;
  new: string;
  request?: number;
}

export interface RenameWorld {
  kind: "RenameWorld";
  name: string;
  title: string;
  request?: number;
}

export interface ReopenTab {
  kind: "ReopenTab";
  request?: number;
}

export interface ResetWorld {
  kind: "ResetWorld";
  request?: number;
}

export interface RestartStep {
  kind: "RestartStep";
  request?: number;
}

export interface Restore {
  kind: "Restore";
  version: string;
  request?: number;
}

export interface RestoreCustomBlock {
  kind: "RestoreCustomBlock";
  name: string;
  request?: number;
}

export interface RestoreWorld {
  kind: "RestoreWorld";
  name: string;
  request?: number;
}

export interface Resume {
  kind: "Resume";
  request?: number;
}

export interface Robot {
  name: string;
  x: number;
  y: number;
  heading: number;
  located?: boolean;
  joints?: Record<string, number>;
  leds?: Record<string, [number, number, number]>;
  emotion?: string;
  speed?: [number, number] | null;
  text?: string;
}

export interface RobotBegun {
  kind: "RobotBegun";
  description: string;
}

export interface RobotChoice {
  name: string;
  title: string;
  simulated: boolean;
  lacks?: string[];
  serves?: Record<string, string>;
  given?: string;
}

export interface RobotConnected {
  kind: "RobotConnected";
  state: "connected" | "connecting" | "failed" | "lost" | "none";
  id?: string;
  robot?: string;
  problem?: Phrase | null;
  doing?: string;
  actions?: string[];
  corrects?: boolean;
}

export interface RobotCorrected {
  kind: "RobotCorrected";
  corrections?: Correction[];
  saved?: boolean;
  problem?: Phrase | null;
}

export interface RobotLink {
  kind: "RobotLink";
  state: "simulated" | "disconnected" | "connected" | "weak" | "lost";
  battery?: number | null;
  quality?: number | null;
}

export interface RobotMade {
  kind: "RobotMade";
  name: string;
  files?: string[];
  problems?: RobotProblem[];
}

export interface RobotProblem {
  message: Phrase;
  line?: number;
}

export interface RobotValues {
  kind: "RobotValues";
  sensors?: Sensor[];
  joints?: Record<string, number>;
  speed?: [number, number] | null;
  heading?: number | null;
  weak?: boolean;
  quality?: number | null;
  silence?: number | null;
  round_trip?: number | null;
  battery?: number | null;
  charge?: number | null;
}

export interface Robots {
  kind: "Robots";
  robots: RobotChoice[];
}

export interface RobotsNearby {
  kind: "RobotsNearby";
  found?: NearbyRobot[];
  known?: KnownRobot[];
}

export interface Run {
  kind: "Run";
  paused?: boolean;
  request?: number;
}

export interface RunShown {
  kind: "RunShown";
  run?: KeptRun | null;
  changed?: boolean;
  remarks?: Phrase[];
  printed?: string;
}

export interface RunState {
  kind: "RunState";
  state: "done" | "ended" | "held" | "idle" | "input" | "paused" | "running" | "starting";
  block?: string | null;
  speed?: number | null;
  held_by?: "breakpoint" | "pause" | "step";
}

export interface RunStep {
  phrase: Phrase;
  time: number;
}

export interface RunningLine {
  kind: "RunningLine";
  line: number;
  block?: string | null;
}

export interface RunsCompared {
  kind: "RunsCompared";
  first: ComparedRun;
  second: ComparedRun;
  together?: number | null;
  because?: Phrase | null;
  causes?: Phrase[];
}

export interface RunsOn {
  kind: "RunsOn";
  robots: Verdict[];
}

export interface SaveAs {
  kind: "SaveAs";
  name: string;
  request?: number;
}

export interface SaveBlockSet {
  kind: "SaveBlockSet";
  set: BlockSet;
  replace?: boolean;
  request?: number;
}

export interface SaveCustomBlock {
  kind: "SaveCustomBlock";
  name: string;
  source: string;
  configuration?: string;
  replaces?: string;
  request?: number;
}

export interface SaveLesson {
  kind: "SaveLesson";
  edited: EditedLesson;
  request?: number;
}

export interface SaveTags {
  kind: "SaveTags";
  names: Record<string, number>;
  request?: number;
}

export interface SaveWorld {
  kind: "SaveWorld";
  name: string;
  world: WorldFile;
  replace?: boolean;
  request?: number;
}

export interface Saved {
  kind: "Saved";
  edit: number;
}

export interface Scene {
  kind: "Scene";
  name: string;
  world: WorldFile;
  lines: [number, number][][];
  robots: [string, RobotDescription][];
  cameras?: string[];
  start?: [number, number, number] | null;
  variant?: number;
  real?: boolean;
}

export interface Seen {
  sort: "face" | "line" | "object" | "tag";
  label: string;
  corners: [number, number][];
}

export interface Sensor {
  device: string;
  key: string;
  value: number | boolean | null;
  place?: string;
  number?: number;
}

export interface SetBreakpoints {
  kind: "SetBreakpoints";
  blocks: string[];
  request?: number;
}

export interface SetRobotCount {
  kind: "SetRobotCount";
  name: string;
  count: number;
  request?: number;
}

export interface SetSpeed {
  kind: "SetSpeed";
  factor: number | null;
  request?: number;
}

export interface Setting {
  name: string;
  sort: "boolean" | "choice" | "list" | "number" | "text" | "whole";
  value: unknown;
  default: unknown;
  allowed: Phrase;
  description?: Phrase | null;
  least?: number | null;
  most?: number | null;
  choices?: string[];
  secret?: boolean;
}

export interface Settings {
  kind: "Settings";
  robot: string;
  world: string;
  breakpoints?: string[];
}

export interface SettingsTable {
  kind: "SettingsTable";
  robot: string;
  settings?: Setting[];
  wrong?: Record<string, Phrase>;
  problem?: Phrase | null;
}

export interface ShowStep {
  kind: "ShowStep";
  step: number;
  request?: number;
}

export interface ShowVariant {
  kind: "ShowVariant";
  robot: string;
  variant: number;
  request?: number;
}

export interface SkillClash {
  skill: string;
  place: Phrase;
}

export interface SolvedStep {
  title: string | Record<string, string>;
  solution?: string;
  wrong?: WrongProgram[];
}

export interface Sound {
  kind: "Sound";
  device: string;
  action: string;
  values: unknown[];
}

export interface StartLesson {
  kind: "StartLesson";
  lesson: string;
  name: string;
  robot?: string;
  again?: boolean;
  request?: number;
}

export interface Step {
  kind: "Step";
  over?: boolean;
  request?: number;
}

export interface Stop {
  kind: "Stop";
  request?: number;
}

export interface StopChecking {
  kind: "StopChecking";
  request?: number;
}

export interface StopTrying {
  kind: "StopTrying";
  request?: number;
}

export interface StrokePart {
  stroke: number;
  color: [number, number, number];
  width: number;
  points: [number, number][];
}

export interface Tab {
  name: string;
  robot: string;
  state: "done" | "ended" | "held" | "idle" | "input" | "paused" | "running" | "starting";
  failed?: boolean;
  mistakes?: boolean;
  robots?: TabRobot[];
}

export interface TabOpened {
  kind: "TabOpened";
  tab: string;
  robot: string;
  world: string;
  shown: number;
  breakpoints?: string[];
  shows?: string;
}

export interface TabRobot {
  name: string;
  state: "done" | "ended" | "held" | "idle" | "input" | "paused" | "running" | "starting";
  failed?: boolean;
}

export interface Tabs {
  kind: "Tabs";
  tabs?: Tab[];
  open?: string;
  shows?: string;
}

export interface Tags {
  kind: "Tags";
  names: Record<string, number>;
  problem?: Phrase | null;
}

export interface TagsRead {
  kind: "TagsRead";
  names: Record<string, number>;
}

export interface TakeHint {
  kind: "TakeHint";
  request?: number;
}

export interface TakenIn {
  kind: "TakenIn";
}

export interface Telemetry {
  kind: "Telemetry";
  time: number;
  robots: Robot[];
  pushed?: [number, number, number][];
  sensors?: Sensor[];
  goals?: GoalNow[];
  found?: Seen[] | null;
}

export interface TimeMark {
  time: number;
  sort: "bump" | "emotion" | "error" | "goal" | "message" | "placed" | "print" | "when";
  text: string;
}

export interface Timeline {
  kind: "Timeline";
  end: number;
  exact?: boolean;
  since?: number;
  marks?: TimeMark[];
  way?: [number, number, number][];
}

export interface TriedProgram {
  sort: "none" | "solution" | "wrong";
  step: number;
  right?: number;
  attempts?: number;
  problems?: Phrase[];
}

export interface TryCustomBlock {
  kind: "TryCustomBlock";
  name: string;
  source: string;
  function?: string;
  arguments?: unknown[];
  request?: number;
}

export interface TryLesson {
  kind: "TryLesson";
  edited: EditedLesson;
  request?: number;
}

export interface TryRobot {
  kind: "TryRobot";
  action: "angle" | "beep" | "distance" | "face" | "lamps" | "stop" | "wheels";
  request?: number;
}

export interface TwinFinding {
  phrase: Phrase;
  time: number | null;
}

export interface Undo {
  kind: "Undo";
  request?: number;
}

export interface UnreachableGoal {
  sort: string;
  index: number;
  reason: Phrase;
}

export interface UseLibrary {
  kind: "UseLibrary";
  name: string;
  request?: number;
}

export interface UseRobot {
  kind: "UseRobot";
  request?: number;
}

export interface ValueThere {
  block: string;
  name: string;
  value: string;
}

export interface ValuesThere {
  kind: "ValuesThere";
  values?: ValueThere[];
}

export interface Variable {
  name: string;
  id: string;
}

export interface Variables {
  kind: "Variables";
  local: Record<string, string>;
  shared: Record<string, string>;
  whens?: WhenNow[];
}

export interface Verdict {
  robot: string;
  state: "refused" | "runs" | "unknown" | "without";
  message: Phrase;
}

export interface Version {
  id: string;
  time: number;
  reason: "conflict" | "outside" | "restored" | "run" | "time";
  lines: number;
}

export interface WatchCamera {
  kind: "WatchCamera";
  on: boolean;
  request?: number;
}

export interface Welcome {
  kind: "Welcome";
  version: string;
  robots: RobotChoice[];
  worlds: WorldChoice[];
  examples: ExampleChoice[];
  folder: string;
  read_only?: Phrase | null;
  warns?: boolean;
  teaches?: boolean;
  address?: string | null;
}

export interface WhenNow {
  name: string;
  active: boolean;
  time: number;
}

export interface WhyAnswer {
  kind: "WhyAnswer";
  asked: Asked;
  sentences?: WhySentence[];
  more?: WhySentence[];
}

export interface WhyQuestion {
  ask: "bump" | "emotion" | "end" | "fall" | "goal" | "line" | "long" | "lost" | "movement" | "not-end" | "not-line" | "not-movement" | "not-print" | "not-skill" | "not-when" | "nothing" | "now" | "print" | "printed" | "reached" | "skill" | "speed" | "value" | "when";
  subject: string;
  time: number | null;
}

export interface WhySentence {
  phrase: Phrase;
  time: number | null;
  block: string | null;
  inner: string | null;
}

export interface Work {
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
}

export interface Workspace {
  stacks: Block[][];
  variables: Variable[];
}

export interface WorldChecked {
  kind: "WorldChecked";
  problems: Phrase[];
  lines?: [number, number][][];
  unreachable?: UnreachableGoal[];
  request?: number;
}

export interface WorldChoice {
  name: string;
  title: string;
  own: boolean;
  robots?: number;
}

export interface WorldDeleted {
  kind: "WorldDeleted";
  name: string;
  title: string;
}

export interface WorldExported {
  kind: "WorldExported";
  filename: string;
  content: string;
}

export interface WorldMade {
  kind: "WorldMade";
  world: WorldFile;
}

export interface WorldToEdit {
  kind: "WorldToEdit";
  name: string;
  world: WorldFile;
  lines: [number, number][][];
  save_as: string;
}

export interface Worlds {
  kind: "Worlds";
  worlds: WorldChoice[];
}

export interface WrittenProgram {
  text: string;
  notation?: "blocktext" | "python";
}

export interface WrongProgram {
  program: string;
  check: LessonWords;
  hint?: LessonWords[];
}

export type FromPage =
  | ListBlockSets
  | ReadBlockSet
  | ExportBlockSet
  | ReadContainment
  | ReadNetwork
  | ListCustomBlocks
  | CheckCustomBlock
  | ExportCustomBlock
  | Stop
  | WatchCamera
  | ReadTimeline
  | ReadPrediction
  | LookBack
  | ReadPastPicture
  | ReadValues
  | ReadCalls
  | ReadQuestions
  | AskWhy
  | ListRuns
  | OpenRun
  | CloseRun
  | CompareRuns
  | ReadCallsBeside
  | Introduce
  | ListLessons
  | ListLibraries
  | ListExportable
  | ReadLibraries
  | DownloadLibrary
  | Complete
  | Describe
  | ReadRunsOn
  | ReadWorld
  | CheckWorld
  | MakeWorld
  | ExportWorld
  | Open
  | CloseProject
  | Export
  | ListProjects
  | ListHistory
  | OpenTab
  | ReadTags
  | ExportTags
  | ChooseBlockSet
  | ChooseRobot
  | ChooseWorld
  | Run
  | Pause
  | Resume
  | Step
  | SetSpeed
  | Answer
  | HoldKeys
  | ResetWorld
  | PlaceRobot
  | HandleRobot
  | Drive
  | ShowStep
  | CheckStep
  | StopChecking
  | ShowVariant
  | EditBlocks
  | EditText
  | RecoverBlocks
  | RecoverText
  | Undo
  | Redo
  | Format
  | Rename
  | SetBreakpoints
  | AddTab
  | SetRobotCount
  | CloseTab
  | ReopenTab
  | RenameTab
  | SaveBlockSet
  | DeleteBlockSet
  | InstallOffered
  | SaveCustomBlock
  | TryCustomBlock
  | DuplicateCustomBlock
  | DeleteCustomBlock
  | RestoreCustomBlock
  | ImportCustomBlock
  | NameRun
  | DeleteRun
  | StartLesson
  | RestartStep
  | TakeHint
  | AnswerQuiz
  | AnswerPuzzle
  | ImportLibraries
  | RemoveLibrary
  | MakeLibrary
  | ConvertLibrary
  | UseLibrary
  | SaveWorld
  | ImportWorld
  | RenameWorld
  | DeleteWorld
  | RestoreWorld
  | New
  | OpenExample
  | Import
  | ImportOriginal
  | SaveAs
  | RenameProject
  | CopyProject
  | KeepPicture
  | Delete
  | Restore
  | SaveTags
  | FindRobots
  | ConnectRobot
  | DisconnectRobot
  | TryRobot
  | CorrectRobot
  | NameRobot
  | UseRobot
  | AllowNetwork
  | ImportLesson
  | ImportLessonFolder
  | DeleteLesson
  | MakeLesson
  | ChangeLesson
  | ReadLessonNotes
  | CopyLesson
  | ExamineLesson
  | SaveLesson
  | TryLesson
  | StopTrying
  | ExportLesson
  | BeginRobot
  | MakeRobot
  | ReadSettings
  | ChangeSettings;

export type ToPage =
  | BlockSets
  | BlocksShown
  | BlockSetRead
  | CodeOffered
  | Noted
  | RobotsNearby
  | RobotConnected
  | RobotValues
  | RobotCorrected
  | Containment
  | Network
  | CustomBlocks
  | CustomBlockChecked
  | CustomBlockSaved
  | PaletteChanged
  | RunState
  | InputWanted
  | KeysWanted
  | Printed
  | Bumped
  | PrintedByRobots
  | Ended
  | Variables
  | RunningLine
  | Drawing
  | Telemetry
  | RobotLink
  | Sound
  | CameraFrame
  | Questions
  | WhyAnswer
  | Timeline
  | ValuesThere
  | Predicted
  | Past
  | CallGraph
  | KeptRuns
  | RunShown
  | RunsCompared
  | CallsBeside
  | Lessons
  | LessonShown
  | LessonGoals
  | LessonChecked
  | LessonHints
  | QuizJudged
  | PuzzleJudged
  | LessonImported
  | LessonToEdit
  | LessonNotes
  | LessonExamined
  | LessonSaved
  | LessonTried
  | LessonExported
  | Libraries
  | LibrariesRead
  | Exportable
  | LibraryMade
  | LibraryConverted
  | RunsOn
  | Document
  | Conflict
  | Completions
  | Description
  | Worlds
  | WorldExported
  | WorldDeleted
  | Scene
  | WorldToEdit
  | WorldChecked
  | WorldMade
  | Welcome
  | Projects
  | Opened
  | ProjectRenamed
  | OriginalImported
  | Settings
  | File
  | History
  | Saved
  | TakenIn
  | Failed
  | Done
  | RobotBegun
  | RobotMade
  | Robots
  | AtSeat
  | SettingsTable
  | Tabs
  | TabOpened
  | Tags
  | TagsRead;

export interface Answers {
  CheckCustomBlock: CustomBlockChecked;
  Complete: Completions;
  Describe: Description;
  SaveCustomBlock: CustomBlockChecked;
  SaveWorld: WorldChecked;
}

export const QUANTITIES: Record<string, Quantity> = {
  "DistanceSensors": {
    "unit": "mm",
    "lowest": 0,
    "highest": 2000.0,
    "digits": 0
  },
  "GroundSensors": {
    "unit": "%",
    "lowest": 0,
    "highest": 100,
    "digits": 0
  },
  "Gyroscope": {
    "unit": "°",
    "lowest": -360,
    "highest": 360,
    "digits": 1
  },
  "Accelerometer": {
    "unit": "m/s²",
    "lowest": -20,
    "highest": 20,
    "digits": 2
  },
  "Bumper": {
    "unit": "",
    "lowest": 0,
    "highest": 1,
    "digits": 1
  },
  "LightSensor": {
    "unit": "",
    "lowest": 0,
    "highest": 1023,
    "digits": 0
  },
  "Controller": {
    "unit": "",
    "lowest": 0,
    "highest": 1,
    "digits": 1
  },
  "Infrared": {
    "unit": "",
    "lowest": 0,
    "highest": 255,
    "digits": 0
  }
};

export const LIMITS = {
  "AddTab": {
    "robot": 100
  },
  "AllowNetwork": {
    "key": 100
  },
  "Answer": {
    "text": 10000
  },
  "AnswerPuzzle": {
    "order": 200
  },
  "AnswerQuiz": {
    "choices": 8
  },
  "BlockNames": {
    "categories": 1000,
    "blocks": 1000
  },
  "BlockSet": {
    "name": 60,
    "title": 50,
    "description": 50
  },
  "ChangeSettings": {
    "robot": 100,
    "values": 100
  },
  "CheckCustomBlock": {
    "name": 100,
    "source": 250000,
    "configuration": 250000,
    "replaces": 100,
    "language": 100
  },
  "ChooseRobot": {
    "name": 100
  },
  "ChooseWorld": {
    "name": 100
  },
  "CloseTab": {
    "name": 100
  },
  "Complete": {
    "language": 100
  },
  "ConnectRobot": {
    "id": 400
  },
  "ConvertLibrary": {
    "filename": 100,
    "content": 250000,
    "python": 1000000,
    "configuration": 250000
  },
  "CopyProject": {
    "project": 100,
    "name": 100
  },
  "Delete": {
    "name": 100
  },
  "DeleteBlockSet": {
    "name": 100
  },
  "DeleteCustomBlock": {
    "name": 100
  },
  "DeleteWorld": {
    "name": 100
  },
  "Describe": {
    "language": 100
  },
  "DownloadLibrary": {
    "name": 100
  },
  "DuplicateCustomBlock": {
    "name": 100,
    "new": 100
  },
  "EditText": {
    "text": 250000
  },
  "EditedLesson": {
    "steps": 30,
    "programs": 60,
    "notes": 20
  },
  "Export": {
    "project": 100
  },
  "ExportCustomBlock": {
    "name": 100
  },
  "ExportWorld": {
    "name": 100
  },
  "HoldKeys": {
    "keys": 42
  },
  "Import": {
    "filename": 100,
    "text": 3500000
  },
  "ImportCustomBlock": {
    "content": 1000000
  },
  "ImportLesson": {
    "filename": 100,
    "content": 2500000
  },
  "ImportLessonFolder": {
    "name": 100,
    "files": 300
  },
  "ImportLibraries": {
    "files": 20
  },
  "ImportOriginal": {
    "filename": 100,
    "content": 1000000,
    "libraries": 10
  },
  "ImportWorld": {
    "filename": 100,
    "content": 2625000
  },
  "KeepPicture": {
    "project": 100,
    "content": 80000
  },
  "LibraryFile": {
    "filename": 100,
    "content": 1000000,
    "renames": 200
  },
  "LookBack": {
    "subject": 100
  },
  "MakeLibrary": {
    "name": 100,
    "version": 100,
    "title": 20,
    "functions": 200,
    "own": 200
  },
  "MakeRobot": {
    "name": 100,
    "description": 65536
  },
  "NameRobot": {
    "robot": 100,
    "name": 40
  },
  "NameRun": {
    "name": 60
  },
  "New": {
    "name": 100,
    "robot": 100
  },
  "Open": {
    "name": 100,
    "tab": 100
  },
  "OpenExample": {
    "name": 100,
    "example": 100,
    "robot": 100
  },
  "OpenTab": {
    "name": 100,
    "robot": 100
  },
  "ReadBlockSet": {
    "filename": 100,
    "text": 250000
  },
  "ReadLibraries": {
    "files": 20
  },
  "ReadQuestions": {
    "block": 100
  },
  "ReadSettings": {
    "robot": 100
  },
  "ReadTags": {
    "filename": 100,
    "text": 250000
  },
  "ReadWorld": {
    "name": 100
  },
  "RecoverText": {
    "text": 250000,
    "base": 250000
  },
  "RemoveLibrary": {
    "name": 100
  },
  "Rename": {
    "name": 100,
    "new": 100
  },
  "RenameProject": {
    "name": 100,
    "project": 100
  },
  "RenameTab": {
    "name": 100,
    "new": 100
  },
  "RenameWorld": {
    "name": 100,
    "title": 100
  },
  "Restore": {
    "version": 100
  },
  "RestoreCustomBlock": {
    "name": 100
  },
  "RestoreWorld": {
    "name": 100
  },
  "SaveAs": {
    "name": 100
  },
  "SaveCustomBlock": {
    "name": 100,
    "source": 250000,
    "configuration": 250000,
    "replaces": 100
  },
  "SaveTags": {
    "names": 2000
  },
  "SaveWorld": {
    "name": 100
  },
  "SetBreakpoints": {
    "blocks": 1000
  },
  "SetRobotCount": {
    "name": 100
  },
  "ShowVariant": {
    "robot": 100
  },
  "StartLesson": {
    "name": 100,
    "robot": 100
  },
  "TryCustomBlock": {
    "name": 100,
    "source": 250000,
    "function": 100,
    "arguments": 100
  },
  "UseLibrary": {
    "name": 100
  },
  "WhyQuestion": {
    "subject": 100
  },
  "WrittenProgram": {
    "text": 60000
  }
} as const;

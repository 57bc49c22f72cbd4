/** The conversation with the server; written by `python -m learnblock.server.typescript`. */

import type { Phrase } from "../i18n";

export type Notation = "blocktext" | "python";

export type View = "blocks" | "blocktext" | "python";

export interface AllowNetwork {
  kind: "AllowNetwork";
  allowed: boolean;
  key: string;
}

export interface Answer {
  kind: "Answer";
  text: string;
}

export interface BeginRobot {
  kind: "BeginRobot";
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

export interface CameraFrame {
  kind: "CameraFrame";
  width: number;
  height: number;
  time: number;
  seen?: Seen[];
}

export interface ChangeSettings {
  kind: "ChangeSettings";
  robot: string;
  values: Record<string, unknown>;
  agreed?: boolean;
}

export interface CheckCustomBlock {
  kind: "CheckCustomBlock";
  request: number;
  name: string;
  source: string;
  configuration?: string;
  replaces?: string;
  language?: string;
}

export interface CheckWorld {
  kind: "CheckWorld";
  world: Record<string, unknown>;
}

export interface ChooseBlockSet {
  kind: "ChooseBlockSet";
  set: BlockSet;
}

export interface ChooseRobot {
  kind: "ChooseRobot";
  name: string;
}

export interface ChooseWorld {
  kind: "ChooseWorld";
  name: string;
}

export interface CodeOffered {
  kind: "CodeOffered";
  blocks?: OfferedCode[];
  libraries?: OfferedCode[];
}

export interface Complete {
  kind: "Complete";
  request: number;
  notation: "blocktext" | "python";
  line: number;
  column: number;
  language?: string;
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
}

export interface DeleteBlockSet {
  kind: "DeleteBlockSet";
  name: string;
}

export interface DeleteCustomBlock {
  kind: "DeleteCustomBlock";
  name: string;
}

export interface DeleteWorld {
  kind: "DeleteWorld";
  name: string;
}

export interface Describe {
  kind: "Describe";
  request: number;
  notation: "blocktext" | "python";
  line: number;
  column: number;
  language?: string;
}

export interface Description {
  kind: "Description";
  request: number;
  title?: string;
  text?: string;
  needs?: string[];
  line?: number;
  column?: number;
  from_column?: number;
  to_column?: number;
  sort?: "" | "function" | "variable" | "when";
  name?: string;
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
  can_undo?: boolean;
  can_redo?: boolean;
}

export interface DownloadLibrary {
  kind: "DownloadLibrary";
  name: string;
}

export interface Drive {
  kind: "Drive";
  advance: number;
  rotation: number;
}

export interface DuplicateCustomBlock {
  kind: "DuplicateCustomBlock";
  name: string;
  new: string;
}

export interface EditBlocks {
  kind: "EditBlocks";
  edit: number;
  workspace: Workspace;
  revision?: number;
}

export interface EditText {
  kind: "EditText";
  edit: number;
  notation: "blocktext" | "python";
  text: string;
  revision?: number;
}

export interface Ended {
  kind: "Ended";
  ended: string;
  message?: Phrase | null;
  block?: string | null;
  time?: number;
  distance?: number | null;
  goals?: GoalNow[];
  emotions?: string[];
  no_effect?: [string, string][];
  trace_sha256?: string;
  custom_block?: string;
  custom_line?: number;
  tried?: boolean;
}

export interface ExampleChoice {
  name: string;
  title: string;
  description: string;
  robot: string;
  world: string;
}

export interface Export {
  kind: "Export";
  format: "bt" | "learnblock" | "py";
}

export interface ExportBlockSet {
  kind: "ExportBlockSet";
  set: BlockSet;
}

export interface ExportCustomBlock {
  kind: "ExportCustomBlock";
  name: string;
}

export interface ExportTags {
  kind: "ExportTags";
  format?: "csv" | "html" | "toml";
}

export interface ExportWorld {
  kind: "ExportWorld";
  name: string;
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
  request?: string;
}

export interface File {
  kind: "File";
  filename: string;
  text: string;
}

export interface Finding {
  name: Phrase;
  contained: boolean;
  reason: Phrase;
}

export interface Format {
  kind: "Format";
}

export interface GoalNow {
  name: string;
  sort: string;
  state: "failed" | "open" | "reached";
  time: number | null;
}

export interface History {
  kind: "History";
  versions: Version[];
  runs: PastRun[];
}

export interface Import {
  kind: "Import";
  filename: string;
  text: string;
}

export interface ImportCustomBlock {
  kind: "ImportCustomBlock";
  content: string;
  replace?: boolean;
}

export interface ImportLibraries {
  kind: "ImportLibraries";
  files: LibraryFile[];
  replace?: boolean;
}

export interface ImportOriginal {
  kind: "ImportOriginal";
  filename: string;
  content: string;
  libraries?: Record<string, string>;
}

export interface ImportWorld {
  kind: "ImportWorld";
  filename: string;
  content: string;
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
}

export interface InstalledLibrary {
  name: string;
  version?: string;
  title?: Record<string, string>;
  description?: string;
  skills?: string[];
  problem?: Phrase | null;
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
}

export interface ListCustomBlocks {
  kind: "ListCustomBlocks";
}

export interface ListExportable {
  kind: "ListExportable";
}

export interface ListHistory {
  kind: "ListHistory";
}

export interface ListLibraries {
  kind: "ListLibraries";
}

export interface ListProjects {
  kind: "ListProjects";
}

export interface MakeLibrary {
  kind: "MakeLibrary";
  name: string;
  version: string;
  title?: Record<string, string>;
  functions?: string[];
  own?: string[];
}

export interface MakeRobot {
  kind: "MakeRobot";
  name: string;
  description: string;
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
}

export interface Opened {
  kind: "Opened";
  name: string;
  robot: string;
  world: string;
  breakpoints?: string[];
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
}

export type Place = [block: string, blocktext: number, blocktext_end: number, python: number, python_end: number];

export interface PlaceRobot {
  kind: "PlaceRobot";
  x: number;
  y: number;
  heading: number;
}

export interface Printed {
  kind: "Printed";
  text: string;
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
}

export interface ProjectRenamed {
  kind: "ProjectRenamed";
  name: string;
}

export interface Projects {
  kind: "Projects";
  projects: ProjectEntry[];
}

export interface ReadBlockSet {
  kind: "ReadBlockSet";
  filename: string;
  text: string;
}

export interface ReadContainment {
  kind: "ReadContainment";
}

export interface ReadLibraries {
  kind: "ReadLibraries";
  files: LibraryFile[];
}

export interface ReadNetwork {
  kind: "ReadNetwork";
}

export interface ReadSettings {
  kind: "ReadSettings";
  robot?: string;
}

export interface ReadTags {
  kind: "ReadTags";
  filename: string;
  text: string;
}

export interface ReadWorld {
  kind: "ReadWorld";
  name: string;
}

export interface RecoverBlocks {
  kind: "RecoverBlocks";
  edit: number;
  workspace: Workspace;
  base: Workspace;
}

export interface RecoverText {
  kind: "RecoverText";
  edit: number;
  notation: "blocktext" | "python";
  text: string;
  base: string;
}

export interface Redo {
  kind: "Redo";
}

export interface RemoveLibrary {
  kind: "RemoveLibrary";
  name: string;
}

export interface Rename {
  kind: "Rename";
  sort: "function" | "variable" | "when";
  name: string;
  new: string;
}

export interface RenameProject {
  kind: "RenameProject";
  name: string;
}

export interface RenameWorld {
  kind: "RenameWorld";
  name: string;
  title: string;
}

export interface ResetWorld {
  kind: "ResetWorld";
}

export interface Restore {
  kind: "Restore";
  version: string;
}

export interface RestoreCustomBlock {
  kind: "RestoreCustomBlock";
  name: string;
}

export interface RestoreWorld {
  kind: "RestoreWorld";
  name: string;
}

export interface Resume {
  kind: "Resume";
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
}

export interface RobotBegun {
  kind: "RobotBegun";
  description: string;
}

export interface RobotChoice {
  name: string;
  title: string;
  simulated: boolean;
}

export interface RobotLink {
  kind: "RobotLink";
  state: "connected" | "disconnected" | "lost" | "simulated" | "weak";
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

export interface Robots {
  kind: "Robots";
  robots: RobotChoice[];
}

export interface Run {
  kind: "Run";
  paused?: boolean;
}

export interface RunState {
  kind: "RunState";
  state: "ended" | "held" | "idle" | "input" | "paused" | "running" | "starting";
  block?: string | null;
  speed?: number | null;
}

export interface RunningLine {
  kind: "RunningLine";
  line: number;
  block?: string | null;
}

export interface SaveAs {
  kind: "SaveAs";
  name: string;
}

export interface SaveBlockSet {
  kind: "SaveBlockSet";
  set: BlockSet;
  replace?: boolean;
}

export interface SaveCustomBlock {
  kind: "SaveCustomBlock";
  name: string;
  source: string;
  configuration?: string;
  replaces?: string;
}

export interface SaveTags {
  kind: "SaveTags";
  names: Record<string, number>;
}

export interface SaveWorld {
  kind: "SaveWorld";
  name: string;
  world: Record<string, unknown>;
  replace?: boolean;
}

export interface Saved {
  kind: "Saved";
  edit: number;
}

export interface Scene {
  kind: "Scene";
  name: string;
  world: Record<string, unknown>;
  lines: [number, number][][];
  robots: [string, Record<string, unknown>][];
  cameras?: string[];
  start?: [number, number, number] | null;
  real?: boolean;
}

export interface Seen {
  sort: "face" | "line" | "tag";
  label: string;
  corners: [number, number][];
}

export interface Sensor {
  device: string;
  key: string;
  value: number | boolean | null;
  place?: string;
  number?: number;
  unit?: string;
  lowest?: number;
  highest?: number;
}

export interface SetBreakpoints {
  kind: "SetBreakpoints";
  blocks: string[];
}

export interface SetSpeed {
  kind: "SetSpeed";
  factor: number | null;
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

export interface SkillClash {
  skill: string;
  place: Phrase;
}

export interface Sound {
  kind: "Sound";
  device: string;
  action: string;
  values: unknown[];
}

export interface Step {
  kind: "Step";
  over?: boolean;
}

export interface Stop {
  kind: "Stop";
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
}

export interface TryCustomBlock {
  kind: "TryCustomBlock";
  name: string;
  source: string;
  function?: string;
  arguments?: unknown[];
}

export interface Undo {
  kind: "Undo";
}

export interface UseLibrary {
  kind: "UseLibrary";
  name: string;
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

export interface Version {
  id: string;
  time: number;
  reason: "conflict" | "outside" | "restored" | "run" | "time";
  lines: number;
}

export interface WatchCamera {
  kind: "WatchCamera";
  on: boolean;
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
}

export interface WhenNow {
  name: string;
  active: boolean;
  time: number;
}

export interface Workspace {
  stacks: Block[][];
  variables: Variable[];
}

export interface WorldChecked {
  kind: "WorldChecked";
  problems: Phrase[];
  lines?: [number, number][][];
}

export interface WorldChoice {
  name: string;
  title: string;
  own: boolean;
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

export interface WorldToEdit {
  kind: "WorldToEdit";
  name: string;
  world: Record<string, unknown>;
  lines: [number, number][][];
  save_as: string;
}

export interface Worlds {
  kind: "Worlds";
  worlds: WorldChoice[];
}

export type FromPage =
  | Open
  | New
  | Import
  | ImportOriginal
  | InstallOffered
  | ImportWorld
  | ExportWorld
  | RenameWorld
  | DeleteWorld
  | RestoreWorld
  | SaveAs
  | RenameProject
  | Delete
  | Export
  | ListProjects
  | ListHistory
  | Restore
  | EditBlocks
  | EditText
  | RecoverBlocks
  | RecoverText
  | Undo
  | Redo
  | Format
  | Rename
  | Complete
  | Describe
  | SetBreakpoints
  | ChooseRobot
  | ChooseWorld
  | Run
  | Stop
  | Pause
  | Resume
  | Step
  | SetSpeed
  | Answer
  | ResetWorld
  | PlaceRobot
  | Drive
  | WatchCamera
  | ReadWorld
  | CheckWorld
  | SaveWorld
  | ListCustomBlocks
  | CheckCustomBlock
  | SaveCustomBlock
  | TryCustomBlock
  | DuplicateCustomBlock
  | DeleteCustomBlock
  | RestoreCustomBlock
  | ExportCustomBlock
  | ImportCustomBlock
  | ListBlockSets
  | ChooseBlockSet
  | ReadBlockSet
  | SaveBlockSet
  | DeleteBlockSet
  | ExportBlockSet
  | ReadContainment
  | ReadNetwork
  | AllowNetwork
  | ReadSettings
  | ChangeSettings
  | SaveTags
  | ReadTags
  | ExportTags
  | ListLibraries
  | ListExportable
  | ReadLibraries
  | ImportLibraries
  | RemoveLibrary
  | DownloadLibrary
  | MakeLibrary
  | ConvertLibrary
  | UseLibrary
  | BeginRobot
  | MakeRobot;

export type ToPage =
  | Welcome
  | Worlds
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
  | Document
  | Conflict
  | Completions
  | Description
  | RunState
  | InputWanted
  | Printed
  | Ended
  | Variables
  | RunningLine
  | Telemetry
  | RobotLink
  | Sound
  | CameraFrame
  | Scene
  | WorldToEdit
  | WorldChecked
  | WorldExported
  | WorldDeleted
  | CodeOffered
  | Noted
  | CustomBlocks
  | CustomBlockChecked
  | CustomBlockSaved
  | PaletteChanged
  | BlockSets
  | BlocksShown
  | BlockSetRead
  | Containment
  | Network
  | SettingsTable
  | Tags
  | TagsRead
  | Libraries
  | LibrariesRead
  | Exportable
  | LibraryMade
  | LibraryConverted
  | RobotBegun
  | RobotMade
  | Robots;

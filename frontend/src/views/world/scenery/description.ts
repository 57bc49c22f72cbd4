/** The contents of world and robot files: the values of `Scene.world` and `Scene.robots`. */

export type XY = [number, number];
export type Colour = string | [number, number, number];
export type Theme = "playground" | "city" | "space" | "warehouse" | "garden" | "night" | "maze";

export interface FloorValues {
  size: XY;
  colour: Colour;
  picture: string | null;
  border: number;
}

export interface PartValues {
  forward: number | null;
  turn: number | null;
  radius: number | null;
}

export interface LineValues {
  name: string;
  colour: Colour;
  width: number;
  points: XY[];
  start: [number, number, number];
  path: PartValues[];
  closed: boolean;
}

export interface WallValues {
  points: XY[];
  height: number;
  thickness: number;
  colour: Colour;
}

export interface BoxValues {
  x: number;
  y: number;
  heading: number;
  length: number;
  width: number;
  height: number;
  mass: number | null;
  colour: Colour;
  name: string;
}

export interface CylinderValues {
  x: number;
  y: number;
  radius: number;
  height: number;
  mass: number | null;
  colour: Colour;
  name: string;
}

/** An upright square board: a tag or a face. */
export interface BoardValues {
  x: number;
  y: number;
  heading: number;
  z: number;
  size: number;
}

export interface TagValues extends BoardValues {
  id: number;
}

export interface FaceValues extends BoardValues {
  emotion: string;
}

export interface LampValues {
  x: number;
  y: number;
  z: number;
  brightness: number;
}

export type PropKind =
  | "ball"
  | "barrel"
  | "block"
  | "cone"
  | "crate"
  | "flowers"
  | "house"
  | "lamp"
  | "pile"
  | "planet"
  | "post"
  | "rocket"
  | "tree";

export interface PropValues {
  kind: PropKind;
  x: number;
  y: number;
  heading: number;
  scale: number;
  solid: boolean;
}

export interface StartValues {
  x: number;
  y: number;
  heading: number;
  name: string;
}

interface GoalValues {
  name: string;
  robot: string | null;
  after: string | null;
  time_limit: number | null;
}

export interface ReachValues extends GoalValues {
  x: number;
  y: number;
  radius: number;
}

export interface FollowValues extends GoalValues {
  line: string;
  fraction: number;
  distance: number;
}

export interface VisitValues extends GoalValues {
  id: number;
  distance: number;
  angle: number;
}

export interface TourValues extends GoalValues {
  points: XY[];
  radius: number;
}

export interface StopValues extends GoalValues {
  x: number;
  y: number;
  radius: number;
  heading: number | null;
  angle: number;
  seconds: number;
}

export interface ShowValues extends GoalValues {
  emotion: string;
  x: number;
  y: number;
  radius: number | null;
}

export interface AvoidValues extends GoalValues {
  distance: number;
}

export interface GoalLists {
  reach: ReachValues[];
  follow: FollowValues[];
  visit: VisitValues[];
  tour: TourValues[];
  stop: StopValues[];
  show: ShowValues[];
  avoid: AvoidValues[];
}

/** The largest differences between a world and its variants. */
export interface VaryValues {
  start: number;
  heading: number;
  light: number;
  noise: number;
  slip: number;
  thing: { name: string; distance: number }[];
}

export interface WorldValues {
  title: string;
  theme: Theme;
  ambient_light: number;
  sensor_noise: number;
  floor: FloorValues;
  line: LineValues[];
  wall: WallValues[];
  box: BoxValues[];
  cylinder: CylinderValues[];
  tag: TagValues[];
  face: FaceValues[];
  light: LampValues[];
  prop: PropValues[];
  start: StartValues[];
  goal: GoalLists;
  vary: VaryValues | null;
}

export interface BodyValues {
  shape: "disc" | "box";
  height: number;
  radius: number | null;
  length: number | null;
  width: number | null;
  offset: number;
  colour: Colour;
}

export interface DistanceValues {
  direction: number;
  sides: string[];
  x: number;
  y: number;
  maximum: number;
  beam: number;
}

export interface RobotValues {
  name: string;
  title: string;
  body: BodyValues;
  wheels: { radius: number; track: number };
  distance: DistanceValues[];
  ground: { side: string; x: number; y: number }[];
  camera: { key: string; x: number; z: number; pitch: number; joint: string | null }[];
  joint: { key: string; minimum: number; maximum: number }[];
  display: { kind: "screen" | "leds" } | null;
  led: { slot: string; kind: "rgb" | "single" }[];
}

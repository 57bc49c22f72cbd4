/** The contents of world and robot files: the values of `Scene.world` and `Scene.robots`. */

export type XY = [number, number];
export type Colour = string | [number, number, number];

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

export interface StartValues {
  x: number;
  y: number;
  heading: number;
  name: string;
}

interface GoalValues {
  name: string;
  robot: string | null;
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

export interface WorldValues {
  title: string;
  ambient_light: number;
  floor: FloorValues;
  line: LineValues[];
  wall: WallValues[];
  box: BoxValues[];
  cylinder: CylinderValues[];
  tag: TagValues[];
  face: FaceValues[];
  light: LampValues[];
  start: StartValues[];
  goal: { reach: ReachValues[]; follow: FollowValues[]; visit: VisitValues[] };
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
  camera: { key: string; x: number; z: number; pitch: number; joint: string | null }[];
  joint: { key: string; minimum: number; maximum: number }[];
  display: { kind: "screen" | "leds" } | null;
  led: { slot: string; kind: "rgb" | "single" }[];
}

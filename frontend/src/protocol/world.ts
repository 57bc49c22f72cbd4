/** Worlds and robots as in their files; by `python -m learnblock.server.typescript world`. */

export type Colour = "black" | "blue" | "brown" | "green" | "grey" | "orange" | "purple" | "red" | "white" | "yellow" | [number, number, number];

export type PropKind = "ball" | "barrel" | "block" | "cone" | "crate" | "flowers" | "house" | "lamp" | "pile" | "planet" | "post" | "rocket" | "tree";

export type Theme = "city" | "garden" | "maze" | "night" | "playground" | "space" | "warehouse";

export interface Accelerometer {
  noise: number;
}

export interface Avoid {
  name: string;
  robot: string | null;
  after: string | null;
  time_limit: number | null;
  distance: number;
}

export interface Body {
  shape: "box" | "disc";
  height: number;
  mass: number;
  radius: number | null;
  length: number | null;
  width: number | null;
  offset: number;
  colour: "black" | "blue" | "brown" | "green" | "grey" | "orange" | "purple" | "red" | "white" | "yellow" | [number, number, number];
}

export interface Box {
  x: number;
  y: number;
  heading: number;
  length: number;
  width: number;
  height: number;
  mass: number | null;
  colour: "black" | "blue" | "brown" | "green" | "grey" | "orange" | "purple" | "red" | "white" | "yellow" | [number, number, number];
  name: string;
}

export interface Bumper {
  x: number;
  width: number;
  travel: number;
}

export interface Camera {
  z: number;
  focal: number;
  key: string;
  x: number;
  pitch: number;
  joint: string | null;
  width: number;
  height: number;
  noise: number;
  rate: number;
}

export interface Cylinder {
  x: number;
  y: number;
  radius: number;
  height: number;
  mass: number | null;
  colour: "black" | "blue" | "brown" | "green" | "grey" | "orange" | "purple" | "red" | "white" | "yellow" | [number, number, number];
  name: string;
}

export interface Display {
  kind: "leds" | "screen";
}

export interface DistanceSensor {
  direction: number;
  sides: ("back" | "front" | "left" | "right")[];
  x: number;
  y: number;
  minimum: number;
  maximum: number;
  beam: number;
  noise: number;
}

export interface Face {
  emotion: "anger" | "disgust" | "fear" | "joy" | "neutral" | "sadness" | "surprise";
  x: number;
  y: number;
  heading: number;
  z: number;
  size: number;
}

export interface Floor {
  size: [number, number];
  colour: "black" | "blue" | "brown" | "green" | "grey" | "orange" | "purple" | "red" | "white" | "yellow" | [number, number, number];
  picture: string | null;
  border: number;
  slip: number;
}

export interface Follow {
  name: string;
  robot: string | null;
  after: string | null;
  time_limit: number | null;
  line: string;
  fraction: number;
  distance: number;
}

export interface Goals {
  reach: Reach[];
  follow: Follow[];
  visit: Visit[];
  tour: Tour[];
  stop: Stop[];
  show: Show[];
  avoid: Avoid[];
}

export interface GroundSensor {
  side: "central" | "left" | "right";
  x: number;
  y: number;
  kind: "cliff" | "reflected";
  spot: number;
  noise: number;
}

export interface Gyroscope {
  key: string;
  drift: number;
  noise: number;
}

export interface Joint {
  key: string;
  minimum: number;
  maximum: number;
  speed: number;
}

export interface Lamp {
  x: number;
  y: number;
  z: number;
  brightness: number;
}

export interface Led {
  slot: string;
  kind: "rgb" | "single";
}

export interface LightSensor {
  x: number;
  y: number;
  noise: number;
}

export interface Line {
  name: string;
  colour: "black" | "blue" | "brown" | "green" | "grey" | "orange" | "purple" | "red" | "white" | "yellow" | [number, number, number];
  width: number;
  points: [number, number][];
  start: [number, number, number];
  path: Part[];
  closed: boolean;
}

export interface Moved {
  name: string;
  distance: number;
}

export interface Part {
  forward: number | null;
  turn: number | null;
  radius: number | null;
}

export interface Prop {
  kind: "ball" | "barrel" | "block" | "cone" | "crate" | "flowers" | "house" | "lamp" | "pile" | "planet" | "post" | "rocket" | "tree";
  x: number;
  y: number;
  heading: number;
  scale: number;
  solid: boolean;
}

export interface Reach {
  name: string;
  robot: string | null;
  after: string | null;
  time_limit: number | null;
  x: number;
  y: number;
  radius: number;
  object: string | null;
  together: boolean;
  alone: boolean;
}

export interface RobotDescription {
  body: Body;
  wheels: Wheels;
  title: string;
  world: string;
  distance: DistanceSensor[];
  ground: GroundSensor[];
  gyroscope: Gyroscope | null;
  accelerometer: Accelerometer | null;
  bumper: Bumper | null;
  light: LightSensor | null;
  camera: Camera[];
  joint: Joint[];
  display: Display | null;
  led: Led[];
  outputs: ("Animator" | "Infrared" | "MP3" | "Matrix" | "Speaker" | "Speaker:play" | "Speaker:say" | "Speaker:tone")[];
  name: string;
}

export interface Show {
  name: string;
  robot: string | null;
  after: string | null;
  time_limit: number | null;
  emotion: "anger" | "disgust" | "fear" | "joy" | "neutral" | "sadness" | "surprise";
  x: number;
  y: number;
  radius: number | null;
}

export interface Start {
  x: number;
  y: number;
  heading: number;
  name: string;
}

export interface Stop {
  name: string;
  robot: string | null;
  after: string | null;
  time_limit: number | null;
  x: number;
  y: number;
  radius: number;
  heading: number | null;
  angle: number;
  seconds: number;
}

export interface Tag {
  id: number;
  x: number;
  y: number;
  heading: number;
  z: number;
  size: number;
}

export interface Tour {
  name: string;
  robot: string | null;
  after: string | null;
  time_limit: number | null;
  points: [number, number][];
  radius: number;
}

export interface Vary {
  start: number;
  heading: number;
  light: number;
  noise: number;
  slip: number;
  thing: Moved[];
}

export interface Visit {
  name: string;
  robot: string | null;
  after: string | null;
  time_limit: number | null;
  id: number;
  distance: number;
  angle: number;
}

export interface Wall {
  points: [number, number][];
  height: number;
  thickness: number;
  colour: "black" | "blue" | "brown" | "green" | "grey" | "orange" | "purple" | "red" | "white" | "yellow" | [number, number, number];
}

export interface Wheels {
  radius: number;
  track: number;
  maximum_speed: number;
  acceleration: number;
  error: number;
  encoders: boolean;
}

export interface WorldFile {
  title: string;
  theme: "city" | "garden" | "maze" | "night" | "playground" | "space" | "warehouse";
  ambient_light: number;
  sensor_noise: number;
  floor: Floor;
  line: Line[];
  wall: Wall[];
  box: Box[];
  cylinder: Cylinder[];
  tag: Tag[];
  face: Face[];
  light: Lamp[];
  prop: Prop[];
  start: Start[];
  goal: Goals;
  vary: Vary | null;
}

/** The contents of world and robot files, under the names that the drawing of a world uses. */

import type { Collectable, Face, Tag } from "../../../protocol/world";

export type {
  Avoid as AvoidValues,
  Body as BodyValues,
  Box as BoxValues,
  Collectable as CollectableValues,
  Colour,
  Cylinder as CylinderValues,
  DistanceSensor as DistanceValues,
  Door as DoorValues,
  Face as FaceValues,
  Floor as FloorValues,
  Follow as FollowValues,
  GameRules as GameValues,
  Goals as GoalLists,
  Lamp as LampValues,
  Line as LineValues,
  Mover as MoverValues,
  Part as PartValues,
  Prop as PropValues,
  PropKind,
  RaceGate as GateValues,
  Reach as ReachValues,
  RobotDescription as RobotValues,
  Show as ShowValues,
  Start as StartValues,
  Stop as StopValues,
  Switch as SwitchValues,
  Tag as TagValues,
  Team as TeamValues,
  Theme,
  Tour as TourValues,
  Vary as VaryValues,
  Visit as VisitValues,
  Wall as WallValues,
  WorldFile as WorldValues,
  Zone as ZoneValues,
} from "../../../protocol/world";

export type XY = [number, number];
export type CollectableKind = Collectable["kind"];
/** An upright square board: a tag or a face. */
export type BoardValues = Pick<Face & Tag, "x" | "y" | "heading" | "z" | "size">;

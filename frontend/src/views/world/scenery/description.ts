/** The contents of world and robot files, under the names that the drawing of a world uses. */

import type { Face, Tag } from "../../../protocol/world";

export type {
  Avoid as AvoidValues,
  Body as BodyValues,
  Box as BoxValues,
  Colour,
  Cylinder as CylinderValues,
  DistanceSensor as DistanceValues,
  Face as FaceValues,
  Floor as FloorValues,
  Follow as FollowValues,
  Goals as GoalLists,
  Lamp as LampValues,
  Line as LineValues,
  Part as PartValues,
  Prop as PropValues,
  PropKind,
  Reach as ReachValues,
  RobotDescription as RobotValues,
  Show as ShowValues,
  Start as StartValues,
  Stop as StopValues,
  Tag as TagValues,
  Theme,
  Tour as TourValues,
  Vary as VaryValues,
  Visit as VisitValues,
  Wall as WallValues,
  WorldFile as WorldValues,
} from "../../../protocol/world";

export type XY = [number, number];
/** An upright square board: a tag or a face. */
export type BoardValues = Pick<Face & Tag, "x" | "y" | "heading" | "z" | "size">;

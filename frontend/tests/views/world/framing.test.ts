import { PerspectiveCamera, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { FIELD, frame, INNER, type Subject } from "../../../src/views/world/framing";

const EBO: Subject = { x: -400, y: 0, heading: 0, reach: 75, height: 120, goal: [410, 0] };
const SMALL: Subject = { x: -100, y: 100, heading: 0, reach: 55, height: 75, goal: [900, -800] };
const LONELY: Subject = { x: 0, y: 0, heading: 90, reach: 75, height: 120, goal: null };

function cameraFor(subject: Subject, aspect: number): PerspectiveCamera {
  const { place, target } = frame(subject, aspect);
  const camera = new PerspectiveCamera(FIELD, aspect, 20, 40_000);
  camera.up.set(0, 0, 1);
  camera.position.copy(place);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  return camera;
}

function shareOf({ x, y, height }: Subject, camera: PerspectiveCamera): number {
  const [foot, head] = [0, height].map((z) => new Vector3(x, y, z).project(camera).y) as [number, number];
  return (head - foot) / 2;
}

describe.each([
  ["a wide picture", 2.2],
  ["a usual picture", 1.3],
  ["a tall picture", 0.7],
])("in %s", (_, aspect) => {
  it.each([
    ["with a goal ahead", EBO],
    ["with a goal far to the side", SMALL],
    ["without a goal", LONELY],
  ])("a robot %s is large enough", (_, subject) => {
    // The height alone, without the body's depth.
    expect(shareOf(subject, cameraFor(subject, aspect))).toBeGreaterThan(0.05);
  });

  it.each([
    ["ahead", EBO],
    ["far to the side", SMALL],
  ])("robot and a goal %s are in the inner part", (_, subject) => {
    const camera = cameraFor(subject, aspect);
    for (const [x, y] of [[subject.x, subject.y], subject.goal ?? [0, 0]] as const) {
      const seen = new Vector3(x, y, 0).project(camera);
      expect(Math.max(Math.abs(seen.x), Math.abs(seen.y))).toBeLessThan(INNER);
    }
  });

  it("the camera looks down by 25 to 35 degrees", () => {
    const { place, target } = frame(EBO, aspect);
    const down = Math.atan2(place.z, Math.hypot(place.x - target.x, place.y - target.y));
    expect((down * 180) / Math.PI).toBeGreaterThanOrEqual(25);
    expect((down * 180) / Math.PI).toBeLessThanOrEqual(35);
  });
});

/** The questions that find out why a robot is not found, in the order in which to ask them. */

/** What is most often wrong comes first. */
const STEPS: Readonly<Record<string, readonly string[]>> = {
  cozmo: ["on", "charged", "wifi", "other", "again"],
  thymio: ["on", "charged", "cable", "permission", "other"],
  ev3: ["on", "charged", "system", "network", "setup"],
  create3: ["on", "charged", "mode", "bluetooth", "other"],
  root: ["on", "charged", "bluetooth", "other"],
  spike: ["on", "charged", "pybricks", "bluetooth", "other"],
  legoed: ["on", "charged", "card", "bluetooth", "other"],
  ebo: ["on", "charged", "wifi", "other", "again"],
  rcis: ["started", "computer"],
  coppeliasim: ["started", "service", "other"],
};
const OWN = ["on", "charged", "network", "other"];

/** The codes of a robot's questions; each is followed by `-do`, what to do if the answer is no. */
export function questions(robot: string): readonly string[] {
  const known = STEPS[robot];
  return (known ?? OWN).map((step) => `page-connect-help-${known ? robot : "own"}-${step}`);
}

/** Which robots can share a program. */

import type { Page } from "../../model/page";

/** Whether several robots of a kind can be in one project: of a real one there is only one. */
export function canShare({ project }: Page, robot: string): boolean {
  return project.welcome.value?.robots.find(({ name }) => name === robot)?.simulated ?? false;
}

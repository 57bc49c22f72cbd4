/** Prints the programs of all pupils, a page for each. */

import { language, t } from "../../i18n";
import type { ClassPrograms, PupilProgram } from "../../protocol/classroom";
import { type PrintedProgram, printPrograms } from "../share/print";

/** Print the newest program of each pupil; return whether there are any. */
export async function printClass(): Promise<boolean> {
  const reply = await fetch("programs.json");
  const { title, programs } = (await reply.json()) as ClassPrograms;
  if (programs.length) await printPrograms(programs.map((one) => printed(one, title)));
  return programs.length > 0;
}

function printed({ pupil, project, blocktext, blocks, places }: PupilProgram, title: string): PrintedProgram {
  const day = new Date().toLocaleDateString(language.value);
  return {
    workspace: blocks ?? { stacks: [], variables: [] },
    blocktext,
    places: places ?? [],
    title: pupil,
    about: project,
    name: [t("page-class-title", { title }), day].join(" · "),
  };
}

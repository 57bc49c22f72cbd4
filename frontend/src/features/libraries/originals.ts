/** The libraries of the original LearnBlock, each of up to three files with one name. */

import { ORIGINAL_LIBRARY, stemOf, withEnding } from "../../model/upload";
import type { ConvertLibrary } from "../../protocol/messages";
import { inBase64 } from "../../ui/files";

export interface Original {
  readonly text: File;
  readonly python: File | undefined;
  readonly configuration: File | undefined;
}

/** The libraries among these files. */
export function originalsIn(files: readonly File[]): Original[] {
  const [texts, pythons, configurations] = ORIGINAL_LIBRARY.map((ending) => withEnding(files, [ending]));
  return texts!.map((text) => ({
    text,
    python: pythons!.find(belongsTo(text)),
    configuration: configurations!.find(belongsTo(text)),
  }));
}

/** A file whose library is missing. */
export function looseIn(files: readonly File[]): File | undefined {
  const texts = withEnding(files, [ORIGINAL_LIBRARY[0]]);
  return withEnding(files, ORIGINAL_LIBRARY).find((file) => !texts.some(belongsTo(file)));
}

/** The request to convert a library. */
export async function conversion({ text, python, configuration }: Original): Promise<ConvertLibrary> {
  return {
    kind: "ConvertLibrary",
    filename: text.name,
    content: await inBase64(text),
    python: python ? await inBase64(python) : null,
    configuration: configuration ? await inBase64(configuration) : null,
  };
}

function belongsTo(one: File): (other: File) => boolean {
  return (other) => stemOf(other) === stemOf(one);
}

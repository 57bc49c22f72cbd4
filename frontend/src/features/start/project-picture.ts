import type { ProjectEntry } from "../../protocol/messages";

/** The address of a project's picture; undefined if it has none. A later picture has another address. */
export function projectPicture({ name, picture = 0 }: ProjectEntry): string | undefined {
  return picture ? `projects/${encodeURIComponent(name)}/picture.jpg?v=${picture}` : undefined;
}

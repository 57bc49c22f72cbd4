/** The user's worlds as files: imported, downloaded, renamed, deleted. */

import { t } from "../../i18n";
import type { Connection } from "../../protocol/connection";
import { LIMITS } from "../../protocol/messages";
import { bytesOf, inBase64, saveFile } from "../../ui/files";
import type { Toasts } from "../../ui/toasts";
import type { WorldPictures } from "./pictures";

/** The files of worlds: the second has a floor picture too. */
export const WORLD_FILES = [".toml", ".zip"];
const { filename: LONGEST_NAME, content: LARGEST } = LIMITS.ImportWorld;

export class Worlds {
  constructor(
    private readonly connection: Connection,
    private readonly toasts: Toasts,
  ) {
    connection.on("WorldExported", ({ filename, content }) =>
      saveFile(filename, bytesOf(content), filename.endsWith(".zip") ? "application/zip" : "text/plain"),
    );
    connection.on("WorldDeleted", ({ name, title }) => this.deleted(name, title));
  }

  async import(file: File): Promise<void> {
    if (file.size > LARGEST) return this.toasts.error(t("page-worlds-large-file", { name: file.name }));
    const filename = file.name.slice(-LONGEST_NAME);
    this.connection.send({ kind: "ImportWorld", filename, content: await inBase64(file) });
  }

  export(name: string): void {
    this.connection.send({ kind: "ExportWorld", name });
  }

  rename(name: string, title: string): void {
    this.connection.send({ kind: "RenameWorld", name, title });
  }

  delete(name: string): void {
    this.connection.send({ kind: "DeleteWorld", name });
  }

  private deleted(name: string, title: string): void {
    const restore = () => this.connection.send({ kind: "RestoreWorld", name });
    this.toasts.show({
      sort: "note",
      text: t("page-worlds-deleted", { title }),
      action: { text: t("page-worlds-restore"), run: restore },
    });
  }
}

declare module "../../model/page" {
  interface Page {
    readonly worlds: Worlds;
    readonly worldPictures: WorldPictures;
  }
}

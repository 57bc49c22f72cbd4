/** What contains programs on the server's computer, and whether the project's may use the network. */

import { signal } from "@preact/signals";

import { t } from "../../i18n";
import { DialogRequests } from "../../model/dialog-requests";
import type { Connection } from "../../protocol/connection";
import type { AttemptResult, Network, Welcome } from "../../protocol/messages";
import type { Toasts } from "../../ui/toasts";

export class Containment {
  /** Null until the server has sent them. */
  readonly findings = signal<readonly AttemptResult[] | null>(null);
  /** What the server said last about the open project. */
  readonly network = signal<Network | null>(null);
  readonly requests: DialogRequests;
  /** Whether the user does not know yet what does not contain programs. */
  private warns = false;

  constructor(
    private readonly connection: Connection,
    private readonly toasts: Toasts,
    private readonly showDialog: () => void,
  ) {
    this.requests = new DialogRequests(connection);
    connection.on("Containment", ({ findings }) => this.found(findings));
    connection.on("Network", (network) => (this.network.value = network));
  }

  connected({ warns = false }: Welcome): void {
    this.warns = warns;
  }

  reset(): void {
    if (this.warns) this.survey();
  }

  read(): void {
    this.network.value = null;
    void this.requests.ask({ kind: "ReadNetwork" });
    this.survey();
  }

  async allowNetwork(allowed: boolean): Promise<void> {
    const key = this.network.value?.key ?? "";
    if (await this.requests.ask({ kind: "AllowNetwork", allowed, key })) return;
    // Draws the box again, because the browser has already ticked it.
    if (this.network.value) this.network.value = { ...this.network.value };
  }

  private survey(): void {
    this.connection.send({ kind: "ReadContainment" });
  }

  private found(findings: readonly AttemptResult[]): void {
    this.findings.value = findings;
    if (this.warns && !isContained(findings)) this.warn();
    this.warns = false;
  }

  private warn(): void {
    const action = { text: t("page-containment-details"), run: this.showDialog };
    this.toasts.show({ sort: "error", text: t("page-containment-warning"), action });
  }
}

export function isContained(findings: readonly AttemptResult[]): boolean {
  return findings.every((one) => one.contained);
}

declare module "../../model/page" {
  interface Page {
    readonly containment: Containment;
  }
}

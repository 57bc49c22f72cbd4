/** What contains programs on the server's computer, and whether the project's may use the network. */

import { signal } from "@preact/signals";

import { type Phrase, t } from "../../i18n";
import type { Connection } from "../../protocol/connection";
import type { Finding, FromPage, Network } from "../../protocol/messages";
import { provided } from "../../ui/provided";
import type { Toasts } from "../../ui/toasts";

const REQUESTS = ["ReadContainment", "ReadNetwork", "AllowNetwork"] as const satisfies readonly FromPage["kind"][];

export class Containment {
  /** Null until the server has sent them. */
  readonly findings = signal<readonly Finding[] | null>(null);
  /** What the server said last about the open project. */
  readonly network = signal<Network | null>(null);
  /** Why the server refused the last request. */
  readonly refusal = signal<Phrase | string>("");
  /** Whether the user does not know yet what does not contain programs. */
  private warns = false;

  constructor(
    private readonly connection: Connection,
    private readonly toasts: Toasts,
    private readonly showDialog: () => void,
  ) {
    connection.on("Welcome", ({ warns = false }) => (this.warns = warns));
    // The survey takes a moment, so the project comes first.
    connection.on("Opened", () => this.warns && this.survey());
    connection.on("Containment", ({ findings }) => this.found(findings));
    connection.on("Network", (network) => (this.network.value = network));
    connection.onRefused(REQUESTS, (reason) => this.refused(reason));
  }

  read(): void {
    this.refusal.value = "";
    this.network.value = null;
    this.connection.send({ kind: "ReadNetwork" });
    this.survey();
  }

  allowNetwork(allowed: boolean): void {
    this.refusal.value = "";
    this.connection.send({ kind: "AllowNetwork", allowed, key: this.network.value?.key ?? "" });
  }

  private survey(): void {
    this.connection.send({ kind: "ReadContainment" });
  }

  private found(findings: readonly Finding[]): void {
    this.findings.value = findings;
    if (this.warns && !isContained(findings)) this.warn();
    this.warns = false;
  }

  private refused(reason: Phrase): void {
    this.refusal.value = reason;
    // Draws the box again, because the browser has already ticked it.
    if (this.network.value) this.network.value = { ...this.network.value };
  }

  private warn(): void {
    const action = { text: t("page-containment-details"), run: this.showDialog };
    this.toasts.show({ sort: "error", text: t("page-containment-warning"), action });
  }
}

export function isContained(findings: readonly Finding[]): boolean {
  return findings.every((one) => one.contained);
}

export const [ContainmentProvider, useContainment] = provided<Containment>("Containment");

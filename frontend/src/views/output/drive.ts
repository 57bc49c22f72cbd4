/** Manual driving while no program runs. */

import "./panel.css";
import "./drive.css";

import { effect } from "@preact/signals";
import { t } from "../../i18n";
import type { Context } from "../../model/context";
import type { Island } from "../../ui/island";
import { element } from "./elements";
import { type Push, Stick } from "./stick";

/** Milliseconds between two commands; the robot stops after 0.5 s without one. */
const PERIOD = 100;

class Drive implements Island {
  readonly dom = element("section", { class: "robot-panel drive" });
  private readonly stick = new Stick((push) => this.drive(push));
  private readonly hint = element("p", { class: "hint", id: "drive-hint" });
  private readonly dispose: () => void;
  private push: Push | null = null;
  private timer = 0;

  constructor(private readonly context: Context) {
    this.dom.append(this.stick.dom, this.hint);
    this.stick.dom.setAttribute("aria-describedby", this.hint.id);
    this.dispose = effect(() => {
      const runs = context.running.active.value;
      const real = context.running.scene.value?.real ?? false;
      this.stick.enable(!runs && !real);
      this.hint.textContent = t(real ? "page-link-drive-simulated" : runs ? "page-drive-runs" : "page-drive-keys");
      this.dom.classList.toggle("disabled", runs || real);
      this.dom.setAttribute("aria-label", t("page-drive-title"));
      this.stick.dom.setAttribute("aria-label", t("page-drive-stick"));
    });
  }

  destroy(): void {
    this.dispose();
    this.stick.release();
  }

  /** Sends the first command at once, then ten per second, and one to stop. */
  private drive(push: Push | null): void {
    this.push = push;
    if (push && !this.timer) {
      this.send();
      this.timer = window.setInterval(() => this.send(), PERIOD);
    }
    if (!push) {
      clearInterval(this.timer);
      this.timer = 0;
      this.send();
    }
  }

  private send(): void {
    const { forward, right } = this.push ?? { forward: 0, right: 0 };
    this.context.connection.send({ kind: "Drive", advance: forward, rotation: right });
  }
}

/** A joystick that drives the robot. */
export function createDrive(context: Context): Island {
  return new Drive(context);
}

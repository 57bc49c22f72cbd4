/** Driving by hand, while no program runs. */

import "./panel.css";
import "./drive.css";

import { effect } from "@preact/signals";

import type { Context } from "../context";
import { t } from "../i18n";
import type { Island } from "../island";
import { element } from "./elements";
import { Stick, type Push } from "./stick";

/** Milliseconds between two orders; the robot stops by itself after half a second without one. */
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
      this.stick.enable(!runs);
      this.hint.textContent = t(runs ? "drive.runs" : "drive.keys");
      this.dom.classList.toggle("disabled", runs);
      this.dom.setAttribute("aria-label", t("drive.title"));
      this.stick.dom.setAttribute("aria-label", t("drive.stick"));
    });
  }

  destroy(): void {
    this.dispose();
    this.stick.release();
  }

  /** The first order at once, then ten a second, and one to stop. */
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

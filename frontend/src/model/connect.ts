/** The real robots near this computer, and the page's connection to one of them. */

import { computed, signal } from "@preact/signals";
import type { Connection } from "../protocol/connection";
import type {
  AddOn,
  KnownRobot,
  NearbyRobot,
  RobotConnected,
  RobotCorrected,
  RobotsNearby,
  RobotValues,
  TryRobot,
} from "../protocol/messages";
import { DialogRequests } from "./dialog-requests";

const NONE: RobotConnected = { kind: "RobotConnected", state: "none" };

/** A robot of the lists: one that answers, or a kind that does not. */
export interface Listed {
  /** What the server calls it. */
  readonly id: string;
  readonly robot: string;
  readonly name: string;
  readonly isBusy: boolean;
  /** The packages that it lacks; null if it has them. */
  readonly addOn: AddOn | null;
  /** Whether the first look for it has not ended. */
  readonly isLooking: boolean;
  /** How it is reached; null if it does not answer. */
  readonly found: NearbyRobot | null;
}

export class Connect {
  /** Whether the robots are being looked for. */
  readonly searching = signal(false);
  /** Null before the first answer. */
  readonly nearby = signal<RobotsNearby | null>(null);
  readonly state = signal<RobotConnected>(NONE);
  readonly values = signal<RobotValues | null>(null);
  readonly corrected = signal<RobotCorrected | null>(null);
  /** The robot that was tried and is used from then on, with its charge, 0 to 1; null if it is unknown. */
  readonly used = signal<{ readonly robot: string; readonly charge: number | null } | null>(null);
  readonly requests: DialogRequests;

  readonly lists = computed(() => lists(this.nearby.value, this.state.value));
  readonly isConnected = computed(() => this.state.value.state === "connected");
  /** Whether the robot moves or shows something. */
  readonly isActing = computed(() => !!this.state.value.doing);

  constructor(private readonly connection: Connection) {
    this.requests = new DialogRequests(connection);
    connection.on("RobotsNearby", (nearby) => (this.nearby.value = nearby));
    connection.on("RobotConnected", (state) => {
      if (state.state !== "connected") this.values.value = null;
      this.state.value = state;
    });
    connection.on("RobotValues", (values) => (this.values.value = values));
    connection.on("RobotCorrected", (corrected) => (this.corrected.value = corrected));
  }

  /** The server has forgotten the robot and the search if the connection to it was lost. */
  connected(): void {
    this.state.value = NONE;
    if (this.searching.value) this.connection.send({ kind: "FindRobots", on: true });
  }

  begin(): void {
    this.requests.refuse("");
    this.searching.value = true;
    this.connection.send({ kind: "FindRobots", on: true });
  }

  /** Stop looking; a connected robot stops. */
  end(): void {
    this.searching.value = false;
    this.connection.send({ kind: "FindRobots", on: false });
    this.disconnect();
  }

  connect(id: string): void {
    this.corrected.value = null;
    void this.requests.ask({ kind: "ConnectRobot", id });
  }

  disconnect(): void {
    if (this.state.value.state === "none") return;
    this.connection.send({ kind: "DisconnectRobot" });
    // One that is gone already is not reported again.
    if (this.state.value.state === "lost" || this.state.value.state === "failed") this.state.value = NONE;
  }

  /** Install what a robot needs, or stop installing it. */
  install(robot: string, on = true): void {
    void this.requests.ask({ kind: "InstallAddOn", robot, on });
  }

  act(action: TryRobot["action"]): void {
    void this.requests.ask({ kind: "TryRobot", action });
  }

  correct(distance: number, angle: number, save: boolean): void {
    void this.requests.ask({ kind: "CorrectRobot", distance, angle, save });
  }

  rename(robot: string, name: string): void {
    void this.requests.ask({ kind: "NameRobot", robot, name });
  }

  use(): void {
    const { robot = "" } = this.state.value;
    this.used.value = { robot, charge: this.values.value?.charge ?? null };
    void this.requests.ask({ kind: "UseRobot" });
  }
}

/** The robots that answer, those used before, and all other kinds. */
export function lists(nearby: RobotsNearby | null, state: RobotConnected) {
  const { found = [], known = [] } = nearby ?? {};
  const kinds = new Map(known.map((one) => [one.robot, one]));
  const present: Listed[] = found.map((one) => listed(one.id, one.robot, kinds.get(one.robot), one));
  const held = state.id && state.robot && state.state !== "none" ? state : null;
  // One that is reached by its settings was not found, but it is here.
  if (held?.state === "connected" && !present.some((one) => one.id === held.id))
    present.unshift(listed(held.id!, held.robot!, kinds.get(held.robot!), null));
  const here = new Set(present.map((one) => one.robot));
  const away = known.filter((one) => !here.has(one.robot)).map((one) => listed(one.robot, one.robot, one, null));
  const used = new Set(known.flatMap((one) => (one.used ? [one.robot] : [])));
  return {
    found: present,
    before: away.filter((one) => used.has(one.robot)),
    others: away.filter((one) => !used.has(one.robot)),
  };
}

function listed(id: string, robot: string, known: KnownRobot | undefined, found: NearbyRobot | null): Listed {
  const { name = "", is_busy: isBusy = false, add_on: addOn = null, looking: isLooking = false } = known ?? {};
  return { id, robot, name, isBusy, addOn, isLooking, found };
}

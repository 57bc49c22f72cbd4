// @vitest-environment happy-dom

import { type Signal, signal } from "@preact/signals";
import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { keepPictures } from "../../src/features/start/keep-pictures";
import type { Page } from "../../src/model/page";
import { FakeConnection } from "../fake-connection";

const drawWorld = vi.hoisted(() => vi.fn(() => false));
vi.mock("../../src/features/share/frame", () => ({ drawWorld, fillSky: () => {}, newBrush: () => ({}) }));

const PROJECTS = { kind: "Projects", projects: [{ name: "square", picture: 0 }] } as const;

const list = vi.fn();
let scene: Signal<object | null>;
let areLoaded: Signal<boolean>;
let connection: FakeConnection;

beforeEach(() => {
  vi.useFakeTimers();
  vi.clearAllMocks();
  scene = signal(null);
  areLoaded = signal(false);
  connection = new FakeConnection();
  keepPictures({
    context: { connection: connection.real, program: { readOnly: signal(false) }, running: { scene } },
    project: { name: signal("square"), list },
    views: { world: signal({}), areLoaded },
  } as unknown as Page);
});

afterEach(() => {
  vi.useRealTimers();
});

test("a project that is opened is drawn before a picture of its world stops the page for a moment", () => {
  connection.tell(PROJECTS);
  vi.advanceTimersByTime(10_000);
  connection.tell(PROJECTS);
  expect(drawWorld).not.toHaveBeenCalled();
});

test("a world that has been shown for some seconds is drawn for the list of projects, once", () => {
  areLoaded.value = true;
  scene.value = {};
  vi.advanceTimersByTime(3000);
  expect(list).toHaveBeenCalledOnce();
  for (const _ of "12") connection.tell(PROJECTS);
  expect(drawWorld).toHaveBeenCalledOnce();
});

// @vitest-environment happy-dom

import { fireEvent, render, screen, waitFor } from "@testing-library/preact";
import { expect, test, vi } from "vitest";

import { JoinPage } from "../../src/features/class-page/join";
import { Joining } from "../../src/features/class-page/joining";
import type { AboutClass, Join } from "../../src/protocol/classroom";
import { button, press, write } from "../dialog";

const WORD = "koala 47";

/** A class that knows the word, asks about names of two words, and gives new pupils pictures. */
function answer(about: Partial<AboutClass>, sent: Join[]) {
  return async (path: string, { body = "" }: RequestInit = {}): Promise<Response> => {
    const refuse = (code: string) => Response.json({ message: { code } }, { status: 403 });
    if (path === "about.json") {
      return Response.json({ title: "7b", open: true, teacher: false, pupil: "", address: "", ...about });
    }
    const message = JSON.parse(String(body)) as Join;
    if (message.word !== WORD) return refuse("class-wrong-word");
    if (path === "word") return new Response(null, { status: 204 });
    sent.push(message);
    if (message.name.includes(" ") && !message.is_first_name) return refuse("class-only-first-name");
    if (message.pictures) return refuse("class-wrong-pictures");
    return Response.json({ address: "p/x/", pictures: ["fish", "moon", "key", "sun"] });
  };
}

async function open(word = "", about: Partial<AboutClass> = {}) {
  const sent: Join[] = [];
  vi.stubGlobal("fetch", answer(about, sent));
  render(<JoinPage joining={new Joining(word)} />);
  await screen.findByRole("heading", { name: "Join class 7b" });
  return sent;
}

const typed = (name: RegExp) => screen.getByLabelText<HTMLInputElement>(name);

test("the word in a link is known, and the name is typed at once", async () => {
  await open(WORD);
  await waitFor(() => expect(document.activeElement).toBe(typed(/first name/)));
  await waitFor(() => expect(typed(/Join word/).closest("label")!.className).toContain("right"));
});

test("a wrong word is refused before the rest is typed", async () => {
  await open();
  write(typed(/Join word/), "koala 48");
  fireEvent.change(typed(/Join word/));
  await waitFor(() => expect(typed(/Join word/).getAttribute("aria-invalid")).toBe("true"));
  expect(screen.getByRole("alert").textContent).toContain("not the join word");
  write(typed(/Join word/), WORD);
  expect(screen.getByRole("alert").textContent).toBe("");
});

test("pictures are numbered as they are tapped, and Join says how many are missing", async () => {
  const sent = await open(WORD);
  write(typed(/first name/), "Inés");
  press("I have been here before");
  press("Fish");
  press("Moon");
  expect(button(/^Moon/).textContent).toBe("Moon2");
  expect(button("Join · 2 more").getAttribute("aria-disabled")).toBe("true");
  press(/^Moon/);
  press("Key");
  expect(button(/^Key/).textContent).toBe("Key2");
  press("Take the last picture back");
  expect(button(/^Key/).textContent).toBe("Key");
  for (const name of ["Moon", "Key", "Sun"]) press(name);
  expect(document.activeElement).toBe(button("Join"));
  press("Join");
  await screen.findByText(/don't belong together/);
  await waitFor(() => expect(document.activeElement).toBe(button("Apple")));
  expect(sent[0]?.pictures).toEqual(["fish", "moon", "key", "sun"]);
});

test("a new pupil confirms a first name of two words", async () => {
  const sent = await open(WORD);
  write(typed(/first name/), "José Luis");
  press("I am new here");
  press("Join");
  fireEvent.click(await screen.findByText("José Luis is my first name"));
  await screen.findByText("Welcome, José Luis!");
  expect(sent.map(({ is_first_name }) => is_first_name)).toEqual([false, true]);
});

test("the button leads to what is missing", async () => {
  await open(WORD);
  press("Join");
  expect(document.activeElement).toBe(typed(/first name/));
  write(typed(/first name/), "Ana");
  press("Join");
  expect(document.activeElement).toBe(button("I am new here"));
});

test("once new pupils can't join, all have been here before", async () => {
  await open(WORD, { open: false });
  expect(screen.queryByText("I am new here")).toBeNull();
  expect(screen.getAllByRole("button", { name: /^(Apple|Umbrella)$/ })).toHaveLength(2);
});

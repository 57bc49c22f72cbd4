import { expect, test } from "vitest";

import { lessonFolderOf } from "../../src/features/lessons/folder";

function chosen(...paths: string[]): File[] {
  return paths.map((path) => {
    const file = new File([], path.split("/").at(-1) ?? "");
    return Object.defineProperty(file, "webkitRelativePath", { value: path });
  });
}

test("a folder with lesson.toml is a lesson, with its files by their paths inside", () => {
  const folder = lessonFolderOf(chosen("mine/programs/start.bt", "mine/lesson.toml", "mine/teacher/notes.md"));
  expect(folder?.name).toBe("mine");
  expect([...(folder?.files.keys() ?? [])]).toEqual(["programs/start.bt", "lesson.toml", "teacher/notes.md"]);
});

test("hidden files are left out", () => {
  const folder = lessonFolderOf(chosen("mine/lesson.toml", "mine/.git/objects/1", "mine/pictures/.DS_Store"));
  expect([...(folder?.files.keys() ?? [])]).toEqual(["lesson.toml"]);
});

test("a folder of lessons, another folder and loose files are no lesson", () => {
  expect(lessonFolderOf(chosen("lessons/1-03-square/lesson.toml"))).toBeNull();
  expect(lessonFolderOf(chosen("programs/a.bt", "programs/b.bt"))).toBeNull();
  expect(lessonFolderOf([new File([], "lesson.toml")])).toBeNull();
});

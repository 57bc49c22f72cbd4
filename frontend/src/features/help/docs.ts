/** The docs in the help: their sections, found by their words. */

import { plain } from "../../ui/plain";

/** A section of a page of the docs. */
export interface Section {
  /** Of the page. */
  readonly page: string;
  readonly heading: string;
  /** Markdown. */
  readonly text: string;
}

/** The pages for people who use LearnBlock; the others are for its developers. */
const PAGES = import.meta.glob<string>(
  [
    "../../../../docs/{blocks,cameras,class,containment,first-hour,games,grading,language,lessons,page,projects}.md",
    "../../../../docs/{one-program-every-robot,running,simulator,why}.md",
    "../../../../docs/robots/*.md",
  ],
  { query: "?raw", import: "default" },
);
const HEADING = /^#{1,4} (.+)$/;

let loaded: Promise<readonly Section[]> | null = null;

/** All sections; the docs are only loaded once. */
export function docs(): Promise<readonly Section[]> {
  loaded ??= Promise.all(Object.values(PAGES).map((load) => load())).then((pages) => pages.flatMap(sectionsOf));
  return loaded;
}

/** The sections of a page in Markdown; what is between fences has no headings. */
export function sectionsOf(markdown: string): Section[] {
  const sections: { page: string; heading: string; lines: string[] }[] = [];
  let isCode = false;
  for (const line of markdown.split("\n")) {
    if (line.startsWith("```")) isCode = !isCode;
    const heading = isCode ? null : HEADING.exec(line)?.[1]?.replaceAll("`", "");
    if (heading) sections.push({ page: sections[0]?.heading ?? heading, heading, lines: [] });
    else sections.at(-1)?.lines.push(line);
  }
  return sections
    .map(({ lines, ...section }) => ({ ...section, text: withoutLinks(lines.join("\n").trim()) }))
    .filter(({ text }) => text);
}

/** Links lead to files that a browser doesn't have. */
function withoutLinks(markdown: string): string {
  return markdown.replace(/!\[[^\]]*\]\([^)]*\)/g, "").replace(/\[([^\]]+)\]\((?!https?:)[^)]*\)/g, "$1");
}

/** The sections with all of the words, those with the words in their heading first. */
export function matching(sections: readonly Section[], words: string, most: number): readonly Section[] {
  const parts = plain(words).split(/\s+/).filter(Boolean);
  const says = (text: string) => {
    const spaced = ` ${plain(text).replaceAll(/[^\p{L}\p{N}]+/gu, " ")}`;
    return parts.every((part) => spaced.includes(` ${part}`));
  };
  const inHeading = sections.filter(({ heading }) => says(heading));
  const inText = sections.filter(
    (section) => !inHeading.includes(section) && says(`${section.heading} ${section.text}`),
  );
  return parts.length ? [...inHeading, ...inText].slice(0, most) : [];
}

/** Whether two texts are one program in Block-Text: comments and spaces make no difference. */
export function isSameProgram(one: string, other: string): boolean {
  return statements(one) === statements(other);
}

function statements(text: string): string {
  return text
    .replace(/^\s*#.*$/gm, "")
    .replace(/\s+/g, " ")
    .trim();
}

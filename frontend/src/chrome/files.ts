/** Files that the user chooses. */

/** Ask for a file with one of the endings, such as `.toml,.csv`. */
export function chooseFile(endings: string, take: (file: File) => void): void {
  const input = document.createElement("input");
  input.type = "file";
  input.accept = endings;
  input.onchange = () => {
    const file = input.files?.[0];
    if (file) take(file);
  };
  input.click();
}

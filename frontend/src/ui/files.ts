/** Choosing and saving files. */

/** Ask for a file with one of the extensions, such as `.toml,.csv`. */
export function chooseFile(endings: string, take: (file: File) => void): void {
  ask({ accept: endings }, ([file]) => file && take(file));
}

/** Ask for several files. */
export function chooseFiles(endings: string, take: (files: readonly File[]) => void): void {
  ask({ accept: endings, multiple: true }, (files) => files.length && take(files));
}

/** Ask for a folder, and take the files in it and in its folders. */
export function chooseFolder(take: (files: readonly File[]) => void): void {
  ask({ webkitdirectory: true }, take);
}

/** Let the browser save a file. */
export function saveFile(filename: string, content: BlobPart, type: string): void {
  const address = URL.createObjectURL(new Blob([content], { type }));
  const link = document.createElement("a");
  link.href = address;
  link.download = filename;
  link.click();
  URL.revokeObjectURL(address);
}

/** The text of a file; null if it is not UTF-8: its letters would be lost. */
export async function readText(file: Blob): Promise<string | null> {
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(await file.arrayBuffer());
  } catch (error) {
    if (error instanceof TypeError) return null;
    throw error;
  }
}

/** The content of a file in base64. */
export async function inBase64(file: File): Promise<string> {
  const letters = Array.from(new Uint8Array(await file.arrayBuffer()), (byte) => String.fromCharCode(byte));
  return btoa(letters.join(""));
}

/** The bytes in base64. */
export function bytesOf(content: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(content), (letter) => letter.charCodeAt(0));
}

function ask(
  options: Partial<Pick<HTMLInputElement, "accept" | "multiple" | "webkitdirectory">>,
  take: (files: readonly File[]) => void,
): void {
  const input = Object.assign(document.createElement("input"), { type: "file", ...options });
  input.onchange = () => take([...(input.files ?? [])]);
  input.click();
}

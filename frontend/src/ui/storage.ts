/** What the browser keeps for the page. */

/**
 * A text in the browser's storage. Where storage is full or disabled, it lasts until the page is closed.
 *
 * Even to name a disabled storage is an error: hence the function.
 */
export class Stored {
  private unkept: string | null = null;

  constructor(
    private readonly key: string,
    private readonly storage: () => Storage,
  ) {}

  /** The text; null if there is none. */
  read(): string | null {
    if (this.unkept !== null) return this.unkept;
    try {
      return this.storage().getItem(this.key);
    } catch {
      return null;
    }
  }

  write(text: string): void {
    try {
      this.storage().setItem(this.key, text);
      this.unkept = null;
    } catch {
      this.unkept = text;
    }
  }

  /** The JSON value; null if there is none, or the text is another program's. */
  readValue(): unknown {
    try {
      return JSON.parse(this.read() ?? "null");
    } catch {
      return null;
    }
  }

  writeValue(value: unknown): void {
    this.write(JSON.stringify(value));
  }
}

/** A text that all tabs share, and that the browser keeps. */
export function inBrowser(key: string): Stored {
  return new Stored(key, () => localStorage);
}

/** A text that is kept while its tab is open. */
export function inTab(key: string): Stored {
  return new Stored(key, () => sessionStorage);
}

/** Unsaved edits by the names of what is edited, kept while the tab is open. */
export class UnsavedEdits<Edit> {
  private readonly stored: Stored;

  constructor(key: string) {
    this.stored = inTab(key);
  }

  /** The edit of this name; null if there is none. */
  read(name: string): Edit | null {
    const all = this.all();
    // Every object inherits a property "constructor", which is not an edit.
    return Object.hasOwn(all, name) ? (all[name] as Edit) : null;
  }

  keep(name: string, edit: Edit): void {
    this.stored.writeValue({ ...this.all(), [name]: edit });
  }

  drop(name: string): void {
    const { [name]: _dropped, ...others } = this.all();
    this.stored.writeValue(others);
  }

  private all(): Readonly<Record<string, Edit>> {
    return (this.stored.readValue() ?? {}) as Record<string, Edit>;
  }
}

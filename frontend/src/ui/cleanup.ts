/** What must end together with a part of the page: effects, listeners, observers. */

export class Cleanup {
  private readonly ends: (() => void)[];

  constructor(...ends: (() => void)[]) {
    this.ends = ends;
  }

  add(...ends: (() => void)[]): void {
    this.ends.push(...ends);
  }

  /** End everything; a second call does nothing. */
  dispose(): void {
    for (const end of this.ends.splice(0)) end();
  }
}

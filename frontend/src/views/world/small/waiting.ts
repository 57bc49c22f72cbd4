/** Waits until the pictures in a world have loaded. */

import type { Loading } from "../scenery/pictures";

export class Waiting implements Loading {
  private count = 0;
  private wake: () => void = () => undefined;

  begin(): void {
    this.count += 1;
  }

  end(): void {
    this.count -= 1;
    if (this.count === 0) this.wake();
  }

  /** Wait until nothing is being loaded, at most so many ms. */
  async done(most: number): Promise<void> {
    if (this.count === 0) return;
    await new Promise<void>((resolve) => {
      this.wake = resolve;
      setTimeout(resolve, most);
    });
  }
}

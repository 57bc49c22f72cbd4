/** Does something at most every so often; what came last is always done. */
export class Throttle {
  private timer = 0;
  private waiting: (() => void) | null = null;

  /** @param period ms between two doings. */
  constructor(private readonly period: number) {}

  do(action: () => void): void {
    if (this.timer) {
      this.waiting = action;
      return;
    }
    action();
    this.timer = window.setTimeout(() => this.next(), this.period);
  }

  cancel(): void {
    clearTimeout(this.timer);
    this.timer = 0;
    this.waiting = null;
  }

  private next(): void {
    const action = this.waiting;
    this.cancel();
    if (action) this.do(action);
  }
}

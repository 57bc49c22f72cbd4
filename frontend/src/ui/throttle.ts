/** Limits how often actions happen; the last one always happens. */
export class Throttle {
  private timer = 0;
  private waiting: (() => void) | null = null;

  /** @param period ms between two actions. */
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

/**
 * Sends one task at a time and forgets all but the newest of those that wait:
 * a drag asks faster than forms are computed, and only the last place matters.
 */
export class LatestWins<T> {
  private running: Promise<void> | null = null;
  private waiting: { value: T } | null = null;

  constructor(private readonly send: (value: T) => Promise<void>) {}

  /** Sends now, or as soon as the task under way is over. */
  push(value: T): void {
    this.waiting = { value };
    this.running ??= this.drain();
  }

  /** Resolves when nothing runs and nothing waits. */
  async idle(): Promise<void> {
    while (this.running) await this.running;
  }

  private async drain(): Promise<void> {
    while (this.waiting) {
      const { value } = this.waiting;
      this.waiting = null;
      await this.send(value);
    }
    this.running = null;
  }
}

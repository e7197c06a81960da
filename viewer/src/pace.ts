// How sharply to draw: less so while pictures follow each other too slowly, fully at rest.

// Pictures farther apart than this were not meant to follow each other.
const MOVING_MS = 400;
const SLOW_MS = 60;
const FAST_MS = 25;
// So many slow pictures, one after the other, and the next is coarser.
const PATIENCE = 3;
const LEAST = 0.5;
const REST_MS = 500;

export class Pace {
  /** In parts of the screen's own resolution. */
  scale = 1;
  private last = -Infinity;
  private slow = 0;
  private rest = 0;

  /** Calls back when the scene has come to rest and was drawn coarsely before. */
  constructor(private readonly rested: () => void) {}

  /** A picture is drawn now (in milliseconds); whether the scale has changed for it. */
  picture(now: number): boolean {
    const gap = now - this.last;
    this.last = now;
    const before = this.scale;
    if (gap < MOVING_MS) {
      this.slow = gap > SLOW_MS ? this.slow + 1 : gap < FAST_MS ? this.slow - 1 : this.slow;
      if (this.slow >= PATIENCE) this.coarser();
    }
    clearTimeout(this.rest);
    if (this.scale < 1) {
      this.rest = window.setTimeout(() => {
        this.scale = 1;
        this.slow = 0;
        this.last = -Infinity;
        this.rested();
      }, REST_MS);
    }
    return this.scale !== before;
  }

  stop(): void {
    clearTimeout(this.rest);
  }

  private coarser(): void {
    this.scale = Math.max(LEAST, this.scale / Math.SQRT2);
    this.slow = 0;
  }
}

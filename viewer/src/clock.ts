// The time that everything on the page shows.

type Listener = (t: number) => void;

// Playing the whole takes about this long at first.
const PLAYING_S = 15;
const SPEEDS = [0.01, 0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 10000];

export class Clock {
  t: number;
  playing = false;
  speed: number;
  readonly speeds = SPEEDS;
  private readonly listeners: Listener[] = [];
  private readonly stateListeners: (() => void)[] = [];
  private last = 0;

  constructor(readonly t0: number, readonly t1: number) {
    this.t = t0;
    const wanted = (t1 - t0) / PLAYING_S;
    const distance = (s: number): number => Math.abs(Math.log(s / wanted));
    this.speed = SPEEDS.reduce((a, b) => (distance(b) < distance(a) ? b : a));
  }

  /** Called with each new time. */
  onTime(listener: Listener): void {
    this.listeners.push(listener);
  }

  /** Called when it starts, stops or changes its speed. */
  onState(listener: () => void): void {
    this.stateListeners.push(listener);
  }

  seek(t: number): void {
    this.t = Math.min(Math.max(t, this.t0), this.t1);
    for (const listener of this.listeners) listener(this.t);
  }

  setSpeed(speed: number): void {
    this.speed = speed;
    this.changed();
  }

  /** To the next speed, or the one before. */
  shift(by: number): void {
    const at = SPEEDS.indexOf(this.speed) + by;
    this.setSpeed(SPEEDS[Math.min(Math.max(at, 0), SPEEDS.length - 1)]);
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  play(): void {
    if (this.t >= this.t1) this.seek(this.t0);
    this.playing = true;
    this.last = performance.now();
    this.changed();
    requestAnimationFrame(this.frame);
  }

  pause(): void {
    this.playing = false;
    this.changed();
  }

  private readonly frame = (now: number): void => {
    if (!this.playing) return;
    const step = Math.max(now - this.last, 0) / 1000;
    this.last = now;
    this.seek(this.t + step * this.speed);
    if (this.t >= this.t1) this.pause();
    else requestAnimationFrame(this.frame);
  };

  private changed(): void {
    for (const listener of this.stateListeners) listener();
  }
}

import { nearestIndex } from "./geometry.ts";

/** A whole run takes about this long to watch, s; short runs and long ones stay within the rates below. */
const watchingTime = 8;
const slowest = 5;
const fastest = 30;

/** Which frame is shown, and how that moves on: by hand, by playing, or with the newest while a job runs. */
export class Playback {
  times: readonly number[] = [];
  index = -1;
  playing = false;
  /** Whether the newest frame is shown as it comes. */
  following = true;

  private timer = 0;

  constructor(private readonly changed: () => void) {}

  get time(): number {
    return this.times[this.index] ?? 0;
  }

  setTimes(times: readonly number[]): void {
    if (times.length === this.times.length) return;
    this.times = times;
    if (this.following || this.index < 0) this.index = times.length - 1;
    this.changed();
  }

  /** Shows a frame chosen by hand; the last one means to follow again. */
  seek(index: number): void {
    this.index = Math.min(Math.max(0, index), this.times.length - 1);
    this.following = this.index === this.times.length - 1;
    this.changed();
  }

  seekTime(time: number): void {
    this.seek(nearestIndex(this.times, time));
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  pause(): void {
    window.clearInterval(this.timer);
    this.playing = false;
    this.changed();
  }

  private play(): void {
    if (this.times.length < 2) return;
    if (this.index === this.times.length - 1) this.index = 0;
    this.playing = true;
    this.following = false;
    const rate = Math.min(fastest, Math.max(slowest, this.times.length / watchingTime));
    this.timer = window.setInterval(() => this.advance(), 1000 / rate);
    this.changed();
  }

  private advance(): void {
    if (this.index + 1 < this.times.length) {
      this.index += 1;
      this.changed();
    } else {
      this.following = true;
      this.pause();
    }
  }

  dispose(): void {
    window.clearInterval(this.timer);
  }
}

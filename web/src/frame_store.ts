import { getFrame } from "./api.ts";
import type { Frame } from "./model.ts";

/** Frames with particles weigh a few hundred kB each. */
const keptWithParticles = 60;
const parallel = 3;

/** The frames of a job: fetched once, outlines kept for good, particles while they are likely to be seen again. */
export class FrameStore {
  private outlines = new Map<number, Frame>();
  private full = new Map<number, Frame>();
  private wanted: { index: number; particles: boolean }[] = [];
  private underWay = new Set<string>();
  private abort = new AbortController();

  constructor(
    private readonly id: string,
    private readonly arrived: () => void,
  ) {}

  /** The frame if it is here, and with particles if those are; asks for what is missing, ahead of all else. */
  get(index: number, particles: boolean): Frame | undefined {
    const found = this.full.get(index);
    if (found) return found;
    if (particles) this.want(index, true, true);
    const outlines = this.outlines.get(index);
    if (!outlines && !particles) this.want(index, false, true);
    return outlines;
  }

  /** Asks for the outlines of these frames when there is nothing more urgent. */
  prefetch(indices: Iterable<number>): void {
    for (const index of indices) {
      if (!this.full.has(index) && !this.outlines.has(index)) this.want(index, false, false);
    }
  }

  private want(index: number, particles: boolean, urgent: boolean): void {
    if (this.underWay.has(`${index} ${particles}`)) return;
    const queued = this.wanted.findIndex((w) => w.index === index && w.particles === particles);
    if (queued >= 0 && !urgent) return;
    if (queued >= 0) this.wanted.splice(queued, 1);
    // Only the particles now on show are worth their weight: playback has passed those asked for before.
    if (particles) this.wanted = this.wanted.filter((w) => !w.particles);
    if (urgent) this.wanted.unshift({ index, particles });
    else this.wanted.push({ index, particles });
    this.pump();
  }

  private pump(): void {
    while (this.underWay.size < parallel) {
      const next = this.wanted.shift();
      if (!next) return;
      void this.load(next.index, next.particles);
    }
  }

  private async load(index: number, particles: boolean): Promise<void> {
    const key = `${index} ${particles}`;
    this.underWay.add(key);
    try {
      const frame = await getFrame(this.id, index, particles ? "outlines,particles" : "outlines", this.abort.signal);
      if (particles) this.keep(index, frame);
      this.outlines.set(index, { time: frame.time, cells: frame.cells });
      this.arrived();
    } catch {
      // While a job runs only its newest frame has particles. Outlines that do not come are asked for
      // again when they are next to be shown.
      if (particles && !this.abort.signal.aborted) this.prefetch([index]);
    } finally {
      this.underWay.delete(key);
      if (!this.abort.signal.aborted) this.pump();
    }
  }

  private keep(index: number, frame: Frame): void {
    this.full.set(index, frame);
    const oldest = this.full.keys().next();
    if (this.full.size > keptWithParticles && !oldest.done) this.full.delete(oldest.value);
  }

  dispose(): void {
    this.wanted = [];
    this.abort.abort();
  }
}

import { getFrame } from "./api.ts";
import type { Particles } from "./model.ts";

/** The particles of a frame weigh a few hundred kB. */
const kept = 60;

/** The particles of a job's frames, fetched when they are to be shown and kept while they are likely to be again. */
export class ParticleStore {
  private here = new Map<number, Particles>();
  private wanted: number | undefined;
  private loading = false;
  private abort = new AbortController();

  constructor(
    private readonly id: string,
    private readonly arrived: () => void,
  ) {}

  /** The particles if they are here; else asks for them. */
  get(index: number): Particles | undefined {
    const found = this.here.get(index);
    if (!found) {
      this.wanted = index;
      void this.load();
    }
    return found;
  }

  /** One at a time, the one asked for last: a film that runs has passed those before. */
  private async load(): Promise<void> {
    if (this.loading || this.wanted === undefined) return;
    const index = this.wanted;
    this.wanted = undefined;
    this.loading = true;
    try {
      // While a job runs only its newest frame has particles.
      const { particles } = await getFrame(this.id, index, this.abort.signal);
      if (particles) this.keep(index, particles);
    } catch {
      // Asked for again when the frame is next shown.
    }
    this.loading = false;
    if (!this.abort.signal.aborted) await this.load();
  }

  private keep(index: number, particles: Particles): void {
    this.here.set(index, particles);
    const oldest = this.here.keys().next();
    if (this.here.size > kept && !oldest.done) this.here.delete(oldest.value);
    this.arrived();
  }

  dispose(): void {
    this.wanted = undefined;
    this.abort.abort();
  }
}

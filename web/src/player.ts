import { onThemeChange, speedColour } from "./colours.ts";
import { h, setText } from "./dom.ts";
import * as format from "./format.ts";
import { niceStep, trailIndices } from "./geometry.ts";
import type { Case, FrameList, JobError, Outline, Particles } from "./model.ts";
import { ParticleStore } from "./particle_store.ts";
import { Playback } from "./playback.ts";
import type { Point } from "./vessel_shape.ts";
import { VesselView } from "./vessel_view.ts";

/** At most this many past outlines; the study's figures show as many. */
const trailLength = 10; /** So many frames the particles may lag behind while those of the frame on show are fetched: it would flicker else. */
const longestLag = 3;

function fastest(particles: Particles): number {
  let top = 0;
  particles.u?.forEach((u, i) => (top = Math.max(top, Math.hypot(u, particles.v?.[i] ?? 0))));
  return top;
}

/** The vessel with the controls of its film. */
export class Player {
  readonly element: HTMLElement;
  readonly playback: Playback;

  private readonly view = new VesselView();
  private readonly store: ParticleStore;
  private readonly playButton = h("button", { type: "button" });
  private readonly scrubber = h("input", {
    type: "range",
    min: 0,
    max: 0,
    step: 1,
    "aria-label": "Simulated time",
  });
  private readonly clock = h("span", { class: "clock" });
  private readonly closeUp = h("input", { type: "checkbox" });
  private readonly flow = h("input", { type: "checkbox" });
  private readonly trail = h("input", { type: "checkbox", checked: true });
  private readonly topLabel = h("span");
  private readonly scale = h("span", { class: "scale", hidden: true });
  private readonly stopTheme: () => void;
  private outlines: Outline[][] = [];
  private particles: Particles | undefined;
  private particlesOf = 0;
  private topSpeed = 0;
  private breach: Point | undefined;

  constructor(
    id: string,
    private readonly scene: Case,
    private readonly moved: () => void,
  ) {
    this.store = new ParticleStore(id, () => this.draw());
    this.playback = new Playback(() => {
      this.update();
      this.moved();
    });
    // Without cells the flow is all there is to see.
    this.flow.checked = !scene.cells?.length;
    this.playButton.addEventListener("click", () => this.playback.toggle());
    this.scrubber.addEventListener("input", () => {
      if (this.playback.playing) this.playback.pause();
      this.playback.seek(Number(this.scrubber.value));
    });
    for (const option of [this.closeUp, this.flow, this.trail])
      option.addEventListener("change", () => this.draw());
    this.stopTheme = onThemeChange(() => this.view.redraw());

    const gradient = [0, 0.25, 0.5, 0.75, 1].map(speedColour).join(", ");
    const bar = h("span", { class: "bar" });
    bar.style.background = `linear-gradient(to right, ${gradient})`;
    this.scale.append("0", bar, this.topLabel);

    this.element = h(
      "section",
      { class: "player", "aria-label": "Cells in the vessel" },
      this.view.element,
      h("div", { class: "controls" }, this.playButton, this.scrubber, this.clock),
      h(
        "div",
        { class: "options" },
        h("label", {}, this.trail, "Trail"),
        h("label", {}, this.closeUp, "Close-up"),
        h("label", {}, this.flow, "Flow by speed"),
        this.scale,
      ),
    );
    this.update();
  }

  get frames(): number {
    return this.outlines.length;
  }

  /** Takes in the frames that have come since. */
  append(list: FrameList): void {
    if (list.outlines.length === 0 || list.from !== this.outlines.length) return;
    this.outlines.push(...list.outlines);
    this.playback.setTimes(list.times.slice(0, this.outlines.length));
  }

  /** Shows with the last frame where the run went unstable. */
  mark(error: JobError | null | undefined): void {
    if (this.breach || error?.x === undefined || error.y === undefined) return;
    this.breach = { x: error.x, y: error.y };
    this.draw();
  }

  private trailOf(index: number): number[] {
    const step = niceStep(this.scene.duration, trailLength);
    return trailIndices(this.playback.times.slice(0, index + 1), step).filter((k) => k < index);
  }

  private update(): void {
    const { playback } = this;
    const last = Math.max(0, playback.times.length - 1);
    setText(this.playButton, playback.playing ? "Pause" : "Play");
    this.playButton.disabled = playback.times.length < 2;
    this.scrubber.disabled = playback.times.length < 2;
    this.scrubber.max = String(last);
    this.scrubber.value = String(Math.max(0, playback.index));
    const text = playback.index < 0 ? "no frame yet" : format.milliseconds(playback.time);
    setText(this.clock, text);
    this.scrubber.setAttribute("aria-valuetext", text);
    this.draw();
  }

  private draw(): void {
    const { index } = this.playback;
    if (this.flow.checked && index >= 0) {
      const particles = this.store.get(index);
      if (particles) {
        this.particles = particles;
        this.particlesOf = index;
        this.topSpeed = Math.max(this.topSpeed, fastest(particles));
      }
    }
    if (!this.flow.checked || Math.abs(index - this.particlesOf) > longestLag) this.particles = undefined;
    this.scale.hidden = !this.particles;
    setText(this.topLabel, format.speed(this.topSpeed));
    this.view.show({
      vessel: this.scene,
      cells: this.outlines[index] ?? [],
      trail: this.trail.checked ? this.trailOf(index).map((k) => this.outlines[k] ?? []) : [],
      particles: this.particles,
      topSpeed: this.topSpeed || 1,
      closeUp: this.closeUp.checked,
      breach: index === this.outlines.length - 1 ? this.breach : undefined,
    });
  }

  dispose(): void {
    this.stopTheme();
    this.playback.dispose();
    this.store.dispose();
    this.view.dispose();
  }
}

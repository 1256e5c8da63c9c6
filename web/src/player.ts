import { onThemeChange, speedColour } from "./colours.ts";
import { h, setText } from "./dom.ts";
import * as format from "./format.ts";
import { FrameStore } from "./frame_store.ts";
import { niceStep, trailIndices } from "./geometry.ts";
import type { Case, Frame, Particles } from "./model.ts";
import { Playback } from "./playback.ts";
import { VesselView } from "./vessel_view.ts";

/** At most this many past outlines; the study's figures show as many. */
const trailLength = 10;
/** Longer runs are prefetched with gaps, so that opening one does not ask for thousands of frames. */
const prefetched = 400;

function fastest(particles: Particles): number {
  let top = 0;
  particles.u.forEach((u, i) => (top = Math.max(top, Math.hypot(u, particles.v[i]!))));
  return top;
}

/** The vessel with the controls of its film. */
export class Player {
  readonly element: HTMLElement;
  readonly playback: Playback;

  private readonly view = new VesselView();
  private readonly store: FrameStore;
  private readonly playButton = h("button", { type: "button" });
  private readonly scrubber = h("input", { type: "range", min: 0, max: 0, step: 1, "aria-label": "Simulated time" });
  private readonly clock = h("output", { class: "clock" });
  private readonly closeUp = h("input", { type: "checkbox" });
  private readonly flow = h("input", { type: "checkbox" });
  private readonly trail = h("input", { type: "checkbox", checked: true });
  private readonly topLabel = h("span");
  private readonly scale = h("span", { class: "scale", hidden: true });
  private readonly stopTheme: () => void;
  private shown: Frame | undefined;
  private topSpeed = 0;

  constructor(
    id: string,
    private readonly scene: Case,
    private readonly moved: () => void,
  ) {
    this.store = new FrameStore(id, () => this.draw());
    this.playback = new Playback(() => {
      this.update();
      this.moved();
    });
    this.playButton.addEventListener("click", () => this.playback.toggle());
    this.scrubber.addEventListener("input", () => {
      if (this.playback.playing) this.playback.pause();
      this.playback.seek(Number(this.scrubber.value));
    });
    for (const option of [this.closeUp, this.flow, this.trail]) option.addEventListener("change", () => this.draw());
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

  /** The times of the frames there are, s. */
  setTimes(times: readonly number[]): void {
    if (times.length === this.playback.times.length) return;
    this.playback.setTimes(times);
    this.store.prefetch(this.trailOf(times.length - 1));
    const stride = Math.ceil(times.length / prefetched);
    this.store.prefetch(Array.from({ length: Math.ceil(times.length / stride) }, (_, k) => k * stride));
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
    // Until a frame is here the one before stays, so that the film does not flicker.
    const frame = index < 0 ? undefined : this.store.get(index, this.flow.checked);
    if (frame) this.shown = frame;
    if (this.shown?.particles) this.topSpeed = Math.max(this.topSpeed, fastest(this.shown.particles));
    this.scale.hidden = !this.flow.checked || this.topSpeed === 0;
    setText(this.topLabel, format.speed(this.topSpeed));
    const past = this.trail.checked ? this.trailOf(index).map((k) => this.store.get(k, false)) : [];
    this.view.show({
      vessel: this.scene,
      frame: this.shown && !this.flow.checked ? { time: this.shown.time, cells: this.shown.cells } : this.shown,
      trail: past.filter((past) => past !== undefined),
      closeUp: this.closeUp.checked,
      topSpeed: this.topSpeed || 1,
    });
  }

  dispose(): void {
    this.stopTheme();
    this.playback.dispose();
    this.store.dispose();
    this.view.dispose();
  }
}

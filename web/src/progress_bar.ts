import { h, setText } from "./dom.ts";
import * as format from "./format.ts";
import type { Job } from "./model.ts";

export interface ProgressBar {
  element: HTMLElement;
  update(job: Job): void;
}

/** A bar with the fraction done and the time left beside it; empty where there is nothing to tell. */
export function progressBar(): ProgressBar {
  const bar = h("progress", { max: 1, value: 0, "aria-label": "Progress" });
  const text = h("span", { class: "progress-text" });
  const element = h("div", { class: "progress" }, bar, text);

  function update(job: Job): void {
    const fraction = job.state === "succeeded" ? 1 : (job.progress?.fraction ?? 0);
    bar.value = fraction;
    element.dataset.state = job.state;
    const left = job.state === "running" ? format.timeLeft(job.progress?.eta_s) : "";
    const done = job.state === "queued" ? "waiting for its turn" : format.percent(fraction);
    setText(text, [done, left].filter(Boolean).join(" · "));
  }

  return { element, update };
}

const labels: Record<Job["state"], string> = {
  queued: "queued",
  running: "running",
  paused: "paused",
  cancelling: "cancelling",
  succeeded: "succeeded",
  failed: "failed",
  cancelled: "cancelled",
};

/** A coloured word for a state; colour is never the only sign of it. */
export function stateBadge(): { element: HTMLElement; update(job: Job): void } {
  const element = h("span", { class: "state" });
  return {
    element,
    update(job) {
      element.dataset.state = job.state;
      setText(element, labels[job.state] ?? job.state);
    },
  };
}

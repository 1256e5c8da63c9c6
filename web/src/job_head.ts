import { cancelJob } from "./api.ts";
import { fill, h, setText } from "./dom.ts";
import { downloads } from "./downloads.ts";
import * as format from "./format.ts";
import { hasEnded, type Job } from "./model.ts";
import { problemBox } from "./problem_box.ts";
import { progressBar, stateBadge } from "./progress_bar.ts";
import { errorBox, summaryBox } from "./summary_box.ts";

/** What a job is and how it fares: name, state, progress, cancel, and how it ended. */
export class JobHead {
  private readonly title = h("h1", {}, "Job");
  private readonly state = stateBadge();
  private readonly progress = progressBar();
  private readonly times = h("p", { class: "quiet" });
  private readonly cancel = h("button", { type: "button", hidden: true }, "Cancel");
  private readonly failure = h("div");
  private readonly outcome = h("div");
  private readonly downloads;
  private told: string | undefined;
  readonly element: HTMLElement;

  constructor(id: string, changed: () => void) {
    this.downloads = downloads(id);
    this.state.element.setAttribute("role", "status");
    this.cancel.addEventListener("click", async () => {
      this.cancel.disabled = true;
      try {
        this.update(await cancelJob(id));
        changed();
      } catch (problem) {
        fill(this.failure, problemBox(problem));
      } finally {
        this.cancel.disabled = false;
      }
    });
    this.element = h(
      "header",
      {},
      h("p", {}, h("a", { href: "#/" }, "← Jobs")),
      h("div", { class: "heading" }, this.title, this.state.element, this.cancel),
      this.progress.element,
      this.times,
      this.failure,
      this.outcome,
      this.downloads.element,
    );
  }

  update(job: Job): void {
    const name = job.name || `job ${job.id.slice(0, 8)}`;
    document.title = `${name} – Rouleau`;
    setText(this.title, name);
    this.state.update(job);
    this.progress.update(job);
    this.progress.element.hidden = job.state === "succeeded";
    this.cancel.hidden = hasEnded(job.state) || job.state === "cancelling";
    this.downloads.update(job);
    this.showTimes(job);
    const outcome = JSON.stringify([job.summary, job.error]);
    if (this.told !== outcome) {
      this.told = outcome;
      fill(this.outcome, job.error && errorBox(job.error), job.summary && summaryBox(job.summary));
    }
  }

  private showTimes(job: Job): void {
    const parts = [`created ${format.ago(job.created_at, Date.now())}`];
    const wall = format.wallTime(job, Date.now());
    if (wall !== undefined)
      parts.push(`${hasEnded(job.state) ? "took" : "running for"} ${format.duration(wall)}`);
    const { progress } = job;
    if (progress && job.state === "running") {
      parts.push(
        `${format.milliseconds(progress.simulated_time)} of ${format.milliseconds(progress.duration)}`,
      );
      if (progress.steps_per_second > 0) parts.push(format.stepRate(progress.steps_per_second));
    }
    setText(this.times, parts.join(" · "));
  }

  showFailure(problem: unknown): void {
    fill(this.failure, problem !== undefined && problemBox(problem));
  }
}

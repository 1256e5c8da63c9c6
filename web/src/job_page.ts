import { getJob, getOutlines, getSeries, Problem } from "./api.ts";
import { Curves } from "./curves.ts";
import { h, type View } from "./dom.ts";
import { JobHead } from "./job_head.ts";
import { hasEnded, type Job } from "./model.ts";
import { Player } from "./player.ts";
import { poll } from "./poll.ts";
import { SeriesTable } from "./series_table.ts";

/** One job, live while it runs: its head, its cells in the vessel and its curves. */
export function jobPage(id: string): View {
  const table = new SeriesTable();
  const head = new JobHead(id, restart);
  const curves = new Curves(id, table, (time) => player?.playback.seekTime(time));
  const element = h("section", { class: "job" }, head.element, curves.element);
  let player: Player | undefined;
  let attempt: number | undefined;
  let stop = () => {};

  function showPlayer(job: Job): void {
    if (job.attempt !== attempt) {
      table.clear();
      player?.dispose();
      player?.element.remove();
      player = undefined;
      attempt = job.attempt;
    }
    if (player || !job.case) return;
    player = new Player(id, job.case, () => curves.update(player?.playback.time));
    curves.element.before(player.element);
  }

  async function readResults(signal: AbortSignal): Promise<void> {
    const [series, frames] = await Promise.all([
      getSeries(id, table.lastTime, signal),
      getOutlines(id, player?.frames ?? 0, signal),
    ]);
    table.append(series);
    player?.append(frames);
    curves.update(player?.playback.time);
  }

  function restart(): void {
    stop();
    stop = poll(
      async (signal) => {
        const job = await getJob(id, signal);
        head.update(job);
        showPlayer(job);
        player?.mark(job.error);
        // A job that has not started has no results, and one that did not succeed may have lost them.
        if (job.started_at) {
          try {
            await readResults(signal);
          } catch (problem) {
            if (!(problem instanceof Problem && [404, 409].includes(problem.status))) throw problem;
          }
        }
        return hasEnded(job.state) ? "done" : "again";
      },
      (problem) => head.showFailure(problem),
    );
  }

  document.title = "Job – Rouleau";
  restart();
  return {
    element,
    dispose() {
      stop();
      player?.dispose();
      curves.dispose();
    },
  };
}

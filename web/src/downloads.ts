import { getSeriesCsv, jobPath } from "./api.ts";
import { fill, h } from "./dom.ts";
import { hasEnded, type Job } from "./model.ts";
import { problemBox } from "./problem_box.ts";

/** The series is negotiated by its Accept header, which a plain link cannot send. */
async function saveSeries(id: string): Promise<void> {
  const address = URL.createObjectURL(await getSeriesCsv(id));
  h("a", { href: address, download: `${id}.csv` }).click();
  window.setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/** Links to what a job leaves behind, as far as it is there. */
export function downloads(id: string): { element: HTMLElement; update(job: Job): void } {
  const failure = h("div");
  const archive = h(
    "a",
    { href: `${jobPath(id)}/archive.h5`, download: `${id}.h5`, hidden: true },
    "archive.h5",
  );
  const series = h("button", { type: "button", class: "link", hidden: true }, "series.csv");
  series.addEventListener("click", async () => {
    try {
      await saveSeries(id);
      fill(failure);
    } catch (problem) {
      fill(failure, problemBox(problem));
    }
  });
  const element = h(
    "div",
    { class: "downloads" },
    h("span", { class: "quiet" }, "Download"),
    archive,
    series,
    failure,
  );
  element.hidden = true;
  return {
    element,
    update(job) {
      archive.hidden = !job.summary;
      series.hidden = !job.started_at || (hasEnded(job.state) && archive.hidden);
      element.hidden = archive.hidden && series.hidden;
    },
  };
}

import { listJobs } from "./api.ts";
import { fill, h, setText, type View } from "./dom.ts";
import { exampleButton } from "./example.ts";
import * as format from "./format.ts";
import type { Job } from "./model.ts";
import { poll } from "./poll.ts";
import { problemBox } from "./problem_box.ts";
import { progressBar, stateBadge } from "./progress_bar.ts";
import { jobHref, olderHref } from "./route.ts";

interface Row {
  element: HTMLElement;
  update(job: Job, now: number): void;
}

function jobRow(id: string): Row {
  const link = h("a", { href: jobHref(id) });
  const state = stateBadge();
  const progress = progressBar();
  const created = h("time");
  const wall = h("span");
  const element = h(
    "tr",
    {},
    h("td", { class: "name" }, link),
    h("td", {}, state.element),
    h("td", {}, progress.element),
    h("td", { "data-label": "created" }, created),
    h("td", { "data-label": "wall time" }, wall),
  );

  function update(job: Job, now: number): void {
    setText(link, job.name || `job ${job.id.slice(0, 8)}`);
    state.update(job);
    progress.update(job);
    created.dateTime = job.created_at;
    created.title = new Date(job.created_at).toLocaleString();
    setText(created, format.ago(job.created_at, now));
    const seconds = format.wallTime(job, now);
    setText(wall, seconds === undefined ? "–" : format.duration(seconds));
  }

  return { element, update };
}

function emptyState(): HTMLElement {
  return h(
    "div",
    { class: "empty" },
    h("h2", {}, "No jobs yet"),
    h(
      "p",
      {},
      "A job is one scene computed: a vessel, what narrows it and the red cells that pass. ",
      "The example sends one cell past a thrombus and takes about a minute; you can watch it as it runs.",
    ),
    exampleButton(),
    h("p", {}, "Your own scene is a JSON file. Submit it from the command line:"),
    h("pre", {}, h("code", {}, "rouleau submit my_case.json")),
  );
}

/** The jobs, newest first, kept up to date. */
export function jobsPage(pageToken: string | undefined): View {
  const failure = h("div");
  const body = h("tbody");
  const pages = h("nav", { class: "pages", "aria-label": "Pages" });
  const table = h(
    "table",
    { class: "jobs", "aria-label": "Jobs, newest first" },
    h(
      "thead",
      {},
      h(
        "tr",
        {},
        ...["Name", "State", "Progress", "Created", "Wall time"].map((title) =>
          h("th", { scope: "col" }, title),
        ),
      ),
    ),
    body,
  );
  const heading = h("div", { class: "heading" }, h("h1", {}, "Jobs"));
  const list = h("div", { "aria-busy": "true" });
  const element = h("section", {}, heading, failure, list);

  let rows = new Map<string, Row>();
  let shape: "empty" | "table" | undefined;

  function arrange(wanted: "empty" | "table"): void {
    if (shape === wanted) return;
    shape = wanted;
    list.removeAttribute("aria-busy");
    if (wanted === "empty") {
      fill(heading, h("h1", {}, "Jobs"));
      fill(list, emptyState());
    } else {
      fill(heading, h("h1", {}, "Jobs"), exampleButton());
      fill(list, table, pages);
    }
  }

  function update(jobs: Job[], next: string | undefined): void {
    if (jobs.length === 0 && !pageToken) {
      arrange("empty");
      return;
    }
    arrange("table");
    const now = Date.now();
    const kept = new Map<string, Row>();
    for (const job of jobs) {
      const row = rows.get(job.id) ?? jobRow(job.id);
      row.update(job, now);
      kept.set(job.id, row);
    }
    const order = [...kept.values()].map((row) => row.element);
    // Moving a row would take the keyboard's focus from it, so rows stay where nothing changed.
    if (order.length !== body.children.length || order.some((row, i) => body.children[i] !== row)) {
      fill(body, ...order);
    }
    rows = kept;
    const links = `${pageToken ?? ""} ${next ?? ""}`;
    if (pages.dataset.links !== links) {
      pages.dataset.links = links;
      fill(
        pages,
        pageToken && h("a", { href: "#/" }, "Newest"),
        next && h("a", { href: olderHref(next) }, "Older"),
      );
    }
  }

  document.title = "Jobs – Rouleau";
  const stop = poll(
    async (signal) => {
      const { jobs, next_page_token } = await listJobs(pageToken, signal);
      update(jobs, next_page_token);
      return "again";
    },
    (problem) => fill(failure, problem !== undefined && problemBox(problem)),
  );
  return { element, dispose: stop };
}

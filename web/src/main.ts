import "./style.css";
import "./layout.css";
import { fill, type View } from "./dom.ts";
import { jobPage } from "./job_page.ts";
import { jobsPage } from "./jobs_page.ts";
import { parseRoute } from "./route.ts";

const content = document.getElementById("content")!;
let shown: View | undefined;

function show(): void {
  const route = parseRoute(location.hash);
  shown?.dispose();
  shown = route.page === "job" ? jobPage(route.id) : jobsPage(route.pageToken);
  fill(content, shown.element);
}

window.addEventListener("hashchange", () => {
  show();
  window.scrollTo(0, 0);
  content.focus({ preventScroll: true });
});
show();

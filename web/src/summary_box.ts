import { h } from "./dom.ts";
import * as format from "./format.ts";
import type { CellSummary, JobError, Summary } from "./model.ts";
import { faultList } from "./problem_box.ts";

function facts(pairs: [string, string][]): HTMLElement {
  return h(
    "dl",
    { class: "facts" },
    ...pairs.map(([term, value]) => h("div", {}, h("dt", {}, term), h("dd", {}, value))),
  );
}

function departureFact(cell: CellSummary, term: string): [string, string][] {
  return cell.departure ? [[term, `at ${format.milliseconds(cell.departure.time)}`]] : [];
}

/** What an ended run comes to. */
export function summaryBox(summary: Summary): HTMLElement {
  const many = summary.cells.length > 1;
  const ofCells = summary.cells.flatMap((cell, k): [string, string][] => {
    const suffix = many ? ` of cell ${k}` : "";
    return [
      [
        `Peak velocity${suffix}`,
        `${format.speed(cell.peak_velocity)} at ${format.micrometres(cell.peak_velocity_x)}`,
      ],
      [`τ${suffix}, least to peak`, `${cell.least_tau.toFixed(3)} to ${cell.peak_tau.toFixed(3)}`],
      [`Enclosed area${suffix}`, `held within ${(cell.area_deviation * 100).toFixed(2)} %`],
      ...departureFact(cell, many ? `Cell ${k} left` : "Left the vessel"),
    ];
  });
  return h(
    "section",
    { class: "summary", "aria-label": "Summary" },
    summary.reason && h("p", { class: "quiet" }, format.sentence(summary.reason)),
    facts([
      ...ofCells,
      ["Simulated", format.milliseconds(summary.simulated_time)],
      ["Computed in", `${format.duration(summary.wall_time)} (${format.stepRate(summary.steps_per_second)})`],
    ]),
    ...(summary.warnings ?? []).map((warning) =>
      h("p", { class: "quiet" }, h("strong", {}, "Warning: "), format.sentence(warning)),
    ),
  );
}

const kinds: Record<JobError["kind"], string> = {
  case: "The case cannot be computed",
  engine: "The run went unstable",
  infrastructure: "The service could not go on",
  timeout: "The run took too long",
};

/** What was exceeded, when and where, as far as the service knows. */
function breachFacts(error: JobError): [string, string][] {
  const found: [string, string][] = [];
  const unit = error.unit === "1" ? "" : (error.unit ?? "");
  const number = (value: number) => `${Number(value.toPrecision(4))} ${unit}`.trim();
  if (error.quantity && error.value !== undefined)
    found.push([`Found: ${error.quantity}`, number(error.value)]);
  if (error.bound !== undefined) found.push(["Allowed", number(error.bound)]);
  if (error.simulated_time !== undefined) {
    const step = error.step === undefined ? "" : ` (step ${error.step})`;
    found.push(["When", format.milliseconds(error.simulated_time, 3) + step]);
  }
  if (error.x !== undefined && error.y !== undefined) {
    found.push(["Where", `x = ${format.micrometres(error.x)}, y = ${format.micrometres(error.y)}`]);
  }
  if (error.particle !== undefined && error.particle >= 0) {
    const owner = error.cell === undefined || error.cell < 0 ? "of the plasma" : `of cell ${error.cell}`;
    found.push(["Particle", `${error.particle} ${owner}`]);
  } else if (error.cell !== undefined && error.cell >= 0) {
    found.push(["Cell", `${error.cell}`]);
  }
  return found;
}

/** Why a job failed. */
export function errorBox(error: JobError): HTMLElement {
  const breach = breachFacts(error);
  return h(
    "div",
    { class: "notice bad", role: "alert" },
    h("strong", {}, kinds[error.kind] ?? "The job failed"),
    h("p", {}, format.sentence(error.message)),
    error.errors && faultList(error.errors),
    breach.length > 0 && facts(breach),
  );
}

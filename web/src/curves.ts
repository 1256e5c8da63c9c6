import { Chart, type ChartData, type Mark } from "./chart.ts";
import { h } from "./dom.ts";
import { nearestIndex } from "./geometry.ts";
import { joinCurves, onlyForward, valueAt, type SeriesTable } from "./series_table.ts";

type Abscissa = "position" | "time";
type Values = (number | null)[];

const scaled = (values: Values, factor: number): Values =>
  values.map((v) => (v === null ? null : v * factor));

interface Quantity {
  name: string;
  /** From SI to what the chart's label says. */
  factor: number;
}

/** The cells' tau and velocity, over their position or over time. */
export class Curves {
  readonly element: HTMLElement;
  private readonly select = h(
    "select",
    {},
    h("option", { value: "position" }, "position"),
    h("option", { value: "time" }, "time"),
  );
  private readonly charts: { chart: Chart; quantity: Quantity; values?: ChartData["values"] }[];
  private drawnRows = -1;
  private time = 0;

  constructor(
    id: string,
    private readonly table: SeriesTable,
    private readonly picked: (time: number) => void,
  ) {
    const pick = (x: number) => this.pick(x);
    this.charts = [
      {
        chart: new Chart("Deformation factor τ", "τ", "", 3, id, pick),
        quantity: { name: "tau", factor: 1 },
      },
      { chart: new Chart("Axial velocity", "u", "mm/s", 2, id, pick), quantity: { name: "u", factor: 1e3 } },
    ];
    this.select.addEventListener("change", () => {
      this.drawnRows = -1;
      this.update();
    });
    this.element = h(
      "section",
      { class: "curves", "aria-label": "Curves", hidden: true },
      h("div", { class: "options" }, h("label", {}, "Curves over", this.select)),
      h("div", { class: "charts" }, ...this.charts.map(({ chart }) => chart.element)),
    );
  }

  private get abscissa(): Abscissa {
    return this.select.value as Abscissa;
  }

  /** Draws what has come since, with the marks at the time of the frame on show. */
  update(time = this.time): void {
    this.time = time;
    const { cells, rows } = this.table;
    this.element.hidden = cells === 0 || rows === 0;
    if (this.element.hidden) {
      this.drawnRows = -1;
      return;
    }
    for (const entry of this.charts) {
      if (this.drawnRows !== rows || !entry.values) entry.values = this.values(entry.quantity);
      entry.chart.show({
        xLabel: this.abscissa === "position" ? "x (µm)" : "time (ms)",
        values: entry.values,
        marks: this.marks(entry.quantity),
      });
    }
    this.drawnRows = rows;
  }

  private x(cell: number): Values {
    return this.abscissa === "position"
      ? scaled(this.table.column(`cell${cell}.x`), 1e6)
      : scaled(this.table.column("time"), 1e3);
  }

  private values({ name, factor }: Quantity): ChartData["values"] {
    const curves = Array.from({ length: this.table.cells }, (_, cell) =>
      onlyForward(this.x(cell), scaled(this.table.column(`cell${cell}.${name}`), factor)),
    );
    return joinCurves(curves);
  }

  private marks({ name, factor }: Quantity): (Mark | undefined)[] {
    const time = this.table.column("time");
    // The newest frame may be a little ahead of the newest row.
    const shown = Math.min(this.time, this.table.lastTime ?? 0);
    return Array.from({ length: this.table.cells }, (_, cell) => {
      const x = valueAt(time, this.x(cell), shown);
      const y = valueAt(time, this.table.column(`cell${cell}.${name}`), shown);
      return x === undefined || y === undefined ? undefined : { x, y: y * factor };
    });
  }

  /** A place on the abscissa as a time: with positions, when the first cell was there. */
  private pick(x: number): void {
    const [xs, times] = onlyForward(this.x(0), this.table.column("time"));
    const index = nearestIndex(xs, x);
    const time = times[index];
    if (time != null) this.picked(time);
  }

  dispose(): void {
    for (const { chart } of this.charts) chart.dispose();
  }
}

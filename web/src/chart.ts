import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { onThemeChange, readTheme } from "./colours.ts";
import { h } from "./dom.ts";
import { axisRange, nearestIndex } from "./geometry.ts";

const height = 220;

/** A point on a curve that stands for the instant shown in the vessel. */
export interface Mark {
  x: number;
  y: number;
}

export interface ChartData {
  xLabel: string;
  /** `[x, y0, y1, ...]`, in the units of the labels. */
  values: [number[], ...(number | null)[][]];
  marks: (Mark | undefined)[];
}

/** A chart with one curve a cell; pointing at it and dragging picks an abscissa. */
export class Chart {
  readonly element: HTMLElement;
  private readonly holder = h("div", { class: "plot" });
  private readonly observer = new ResizeObserver(() => this.resize());
  private readonly stopTheme: () => void;
  private plot: uPlot | undefined;
  private data: ChartData | undefined;
  private dragging = false;

  constructor(
    private readonly title: string,
    private readonly yName: string,
    private readonly yUnit: string,
    private readonly digits: number,
    private readonly syncKey: string,
    private readonly picked: (x: number) => void,
  ) {
    this.element = h("figure", { class: "chart" }, h("figcaption", {}, title), this.holder);
    this.observer.observe(this.holder);
    this.stopTheme = onThemeChange(() => this.plot?.redraw());
  }

  show(data: ChartData): void {
    const same =
      this.plot && this.data?.xLabel === data.xLabel && this.data.values.length === data.values.length;
    const grown = this.data?.values !== data.values;
    this.data = data;
    if (!same) this.make();
    else if (grown) this.plot!.setData(data.values as uPlot.AlignedData);
    else this.plot!.redraw(false);
    this.showMarkedValues();
  }

  private make(): void {
    const data = this.data!;
    this.plot?.destroy();
    if (this.holder.clientWidth === 0) {
      this.plot = undefined;
      return;
    }
    const axis = (label: string): uPlot.Axis => ({
      label,
      labelSize: 20,
      labelFont: "12px system-ui, sans-serif",
      font: "12px system-ui, sans-serif",
      stroke: () => readTheme().quiet,
      grid: { stroke: () => readTheme().line, width: 1 },
      ticks: { stroke: () => readTheme().line, width: 1, size: 4 },
    });
    const yLabel = this.yUnit ? `${this.yName} (${this.yUnit})` : this.yName;
    const value = (_: uPlot, y: number | null) => (y == null ? "–" : y.toFixed(this.digits));
    const options: uPlot.Options = {
      width: this.holder.clientWidth,
      height,
      scales: {
        x: { time: false, range: (_, low, high) => axisRange(low, high, 0) },
        y: { range: (_, low, high) => axisRange(low, high, 0.1) },
      },
      axes: [
        { ...axis(data.xLabel), size: 30 },
        { ...axis(yLabel), size: 50 },
      ],
      series: [
        { label: data.xLabel, value: (_, x) => (x == null ? "–" : x.toFixed(2)) },
        ...data.values.slice(1).map((_, k) => ({
          label: data.values.length > 2 ? `cell ${k}` : yLabel,
          stroke: () => this.cellColour(k),
          width: 2,
          points: { show: false },
          value,
        })),
      ],
      cursor: { sync: { key: this.syncKey }, drag: { x: false, y: false }, y: false },
      legend: { live: true },
      hooks: { draw: [() => this.drawMarks()], setCursor: [() => this.showMarkedValues()] },
    };
    this.plot = new uPlot(options, data.values as uPlot.AlignedData, this.holder);
    this.plot.root.querySelector("canvas")?.setAttribute("role", "img");
    this.plot.root.querySelector("canvas")?.setAttribute("aria-label", this.title);
    this.listen(this.plot);
  }

  private listen(plot: uPlot): void {
    const pick = (event: PointerEvent) => {
      const left = event.clientX - plot.over.getBoundingClientRect().left;
      this.picked(plot.posToVal(left, "x"));
    };
    plot.over.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      this.dragging = true;
      plot.over.setPointerCapture(event.pointerId);
      pick(event);
    });
    plot.over.addEventListener("pointermove", (event) => {
      if (this.dragging) pick(event);
    });
    const end = () => (this.dragging = false);
    plot.over.addEventListener("pointerup", end);
    plot.over.addEventListener("pointercancel", end);
  }

  private cellColour(k: number): string {
    const { cells } = readTheme();
    return cells[k % cells.length]!;
  }

  private drawMarks(): void {
    const { plot, data } = this;
    if (!plot || !data) return;
    const { ctx, bbox } = plot;
    const ratio = window.devicePixelRatio || 1;
    ctx.save();
    data.marks.forEach((mark, k) => {
      if (!mark) return;
      const x = plot.valToPos(mark.x, "x", true);
      if (x < bbox.left - 1 || x > bbox.left + bbox.width + 1) return;
      const y = plot.valToPos(mark.y, "y", true);
      ctx.strokeStyle = readTheme().quiet;
      ctx.lineWidth = ratio;
      ctx.setLineDash([4 * ratio, 4 * ratio]);
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
      ctx.fillStyle = this.cellColour(k);
      ctx.beginPath();
      ctx.arc(x, y, 4 * ratio, 0, 2 * Math.PI);
      ctx.fill();
    });
    ctx.restore();
  }

  /** While nobody points at the chart its legend tells of the instant shown in the vessel. */
  private showMarkedValues(): void {
    const { plot, data } = this;
    const first = data?.marks.find((mark) => mark !== undefined);
    if (!plot || !data || !first || (plot.cursor.left ?? -1) >= 0) return;
    const index = nearestIndex(data.values[0], first.x);
    if (index >= 0) plot.setLegend({ idx: index }, false);
  }

  private resize(): void {
    const width = this.holder.clientWidth;
    if (width === 0 || !this.data) return;
    if (!this.plot) this.make();
    else if (this.plot.width !== width) this.plot.setSize({ width, height });
  }

  dispose(): void {
    this.stopTheme();
    this.observer.disconnect();
    this.plot?.destroy();
  }
}

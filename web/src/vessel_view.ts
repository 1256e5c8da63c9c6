import { readTheme, speedColour, type Theme } from "./colours.ts";
import { h } from "./dom.ts";
import { areaAndCentroid, mapToWidth, niceStep, stretchAbout, type Mapping } from "./geometry.ts";
import type { Case, Outline, Particles } from "./model.ts";
import { imagesInSight, vesselShape, type Point, type VesselShape } from "./vessel_shape.ts";

const margins = { left: 14, right: 14, top: 8, bottom: 34 };
/** Thickness of the wall as drawn, px. */
const wall = 5;
/** The vessel is drawn no taller than this, px. */
const tallest = 640;
/** Of the ring about the place of a breach, px. */
const breachRadius = 12;
/** Width of the close-up, in vessel diameters. */
const closeUpWidth = 4;
const colourSteps = 24;

export interface Scene {
  vessel: Case;
  cells: Outline[];
  /** The outlines at earlier instants. */
  trail: Outline[][];
  particles: Particles | undefined;
  /** Whether the window stays close about the first cell still in it instead of showing the whole vessel. */
  closeUp: boolean;
  /** The speed that the last colour stands for, m/s. */
  topSpeed: number;
  /** Where the run went unstable, if that is to be seen. */
  breach: Point | undefined;
}

function trace(context: CanvasRenderingContext2D, map: Mapping, shape: VesselShape, outline: Outline): void {
  context.beginPath();
  for (const [dx, dy] of imagesInSight(outline, shape)) {
    outline.x.forEach((x, i) => {
      const [left, up] = [map.toX(x + dx), map.toY(outline.y[i]! + dy)];
      if (i === 0) context.moveTo(left, up);
      else context.lineTo(left, up);
    });
    context.closePath();
  }
}

function tracePoints(context: CanvasRenderingContext2D, map: Mapping, points: Point[]): void {
  context.beginPath();
  for (const { x, y } of points) context.lineTo(map.toX(x), map.toY(y));
}

function drawParticles(
  context: CanvasRenderingContext2D,
  map: Mapping,
  particles: Particles,
  topSpeed: number,
  size: number,
): void {
  const paths = Array.from({ length: colourSteps }, () => new Path2D());
  particles.x.forEach((x, i) => {
    const fraction = Math.hypot(particles.u?.[i] ?? 0, particles.v?.[i] ?? 0) / (topSpeed || 1);
    const step = Math.min(colourSteps - 1, Math.floor(fraction * colourSteps));
    const [left, up] = [map.toX(x), map.toY(particles.y[i]!)];
    paths[step]!.moveTo(left + size / 2, up);
    paths[step]!.arc(left, up, size / 2, 0, 2 * Math.PI);
  });
  paths.forEach((path, step) => {
    context.fillStyle = speedColour(step / (colourSteps - 1));
    context.fill(path);
  });
}

function drawPastCell(
  context: CanvasRenderingContext2D,
  map: Mapping,
  shape: VesselShape,
  outline: Outline,
  colour: string,
): void {
  trace(context, map, shape, outline);
  context.globalAlpha = 0.5;
  context.strokeStyle = colour;
  context.lineWidth = 1;
  context.stroke();
  context.globalAlpha = 1;
}

/** Over the particles' many colours a cell is an outline with a halo; else it is filled as well. */
function drawCell(
  context: CanvasRenderingContext2D,
  map: Mapping,
  shape: VesselShape,
  outline: Outline,
  colour: string,
  overParticles: boolean,
): void {
  trace(context, map, shape, outline);
  if (overParticles) {
    context.strokeStyle = "white";
    context.lineWidth = 5;
    context.stroke();
  } else {
    context.globalAlpha = 0.25;
    context.fillStyle = colour;
    context.fill();
    context.globalAlpha = 1;
  }
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.stroke();
}

/** Whole discs: the half behind the wall is clipped away. */
function drawThrombi(context: CanvasRenderingContext2D, map: Mapping, shape: VesselShape, theme: Theme): void {
  context.fillStyle = theme.tissue;
  context.strokeStyle = theme.text;
  context.lineWidth = 1.5;
  for (const { x, y, radius } of shape.thrombi) {
    context.beginPath();
    context.arc(map.toX(x), map.toY(y), radius * map.scale, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  }
}

function strokeWalls(
  context: CanvasRenderingContext2D,
  map: Mapping,
  shape: VesselShape,
  colour: string,
  width: number,
): void {
  context.strokeStyle = colour;
  context.lineWidth = width;
  for (const points of shape.walls) {
    tracePoints(context, map, points);
    context.stroke();
  }
}

function drawBreach(context: CanvasRenderingContext2D, map: Mapping, breach: Point, theme: Theme): void {
  context.beginPath();
  context.arc(map.toX(breach.x), map.toY(breach.y), breachRadius, 0, 2 * Math.PI);
  context.strokeStyle = theme.lumen;
  context.lineWidth = 5;
  context.stroke();
  context.strokeStyle = theme.text;
  context.lineWidth = 2;
  context.stroke();
}

function drawAxis(
  context: CanvasRenderingContext2D,
  map: Mapping,
  from: number,
  to: number,
  bottom: number,
  theme: Theme,
): void {
  const pixels = (to - from) * map.scale;
  const step = niceStep(to - from, Math.max(2, Math.floor(pixels / 85)));
  const y = bottom + wall;
  context.fillStyle = theme.quiet;
  context.strokeStyle = theme.quiet;
  context.lineWidth = 1;
  context.font = "12px system-ui, sans-serif";
  context.textBaseline = "top";
  for (let k = Math.ceil(from / step - 1e-9); k * step <= to * (1 + 1e-9); k++) {
    const x = map.toX(k * step);
    context.beginPath();
    context.moveTo(x, y + 2);
    context.lineTo(x, y + 6);
    context.stroke();
    const last = (k + 1) * step > to * (1 + 1e-9);
    context.textAlign = last && map.toX(to) - x < 24 ? "right" : k === 0 ? "left" : "center";
    const text = Number((k * step * 1e6).toPrecision(6)).toString();
    context.fillText(
      last ? `${text} µm` : text,
      x + (last && context.textAlign === "right" ? margins.right - 2 : 0),
      y + 9,
    );
  }
}

/** The vessel to scale: walls, thrombi, particles coloured by speed, the cells and where they were, in a periodic
 * vessel beyond the seam, too. */
export class VesselView {
  readonly canvas = h("canvas", { role: "img", "aria-label": "The vessel and its cells" });
  private scene: Scene | undefined;
  private request = 0;
  private readonly observer = new ResizeObserver(() => this.redraw());
  readonly element = h("div", { class: "vessel" }, this.canvas);

  constructor() {
    this.observer.observe(this.element);
  }

  show(scene: Scene): void {
    this.scene = scene;
    const ring = scene.breach ? "; the ring is where the run went unstable" : "";
    this.canvas.setAttribute("aria-label", `The vessel and its cells${ring}`);
    this.redraw();
  }

  redraw(): void {
    cancelAnimationFrame(this.request);
    this.request = requestAnimationFrame(() => this.draw());
  }

  private window(scene: Scene, shape: VesselShape): [number, number] {
    if (!scene.closeUp) return [shape.x0, shape.x1];
    const first = scene.cells.find((cell) => cell.x.length > 0);
    const centre = first ? areaAndCentroid(first.x, first.y).x : (scene.vessel.cells?.[0]?.x ?? 0);
    return stretchAbout(centre, closeUpWidth * shape.diameter, shape.x1);
  }

  private draw(): void {
    const { scene, canvas } = this;
    const width = this.element.clientWidth;
    if (!scene || width === 0) return;
    const shape = vesselShape(scene.vessel);
    const [x0, x1] = this.window(scene, shape);
    const { y0, y1 } = shape;
    const spare = Math.max(0, width - margins.left - margins.right - (tallest * (x1 - x0)) / (y1 - y0)) / 2;
    const sides = { ...margins, left: margins.left + spare, right: margins.right + spare };
    const map = mapToWidth({ x0, x1, y0, y1 }, width, sides);
    const ratio = window.devicePixelRatio || 1;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(map.height * ratio);
    canvas.style.height = `${map.height}px`;
    const context = canvas.getContext("2d")!;
    context.scale(ratio, ratio);

    const theme = readTheme();
    const [left, right] = [map.toX(x0), map.toX(x1)];
    const [top, bottom] = [map.toY(y1), map.toY(y0)];
    context.save();
    context.beginPath();
    const [from, to] = [x0 > shape.x0 ? left : left - wall, x1 < shape.x1 ? right : right + wall];
    context.rect(from, top - wall, to - from, bottom - top + 2 * wall);
    context.clip();
    strokeWalls(context, map, shape, theme.tissue, 2 * wall);

    context.save();
    tracePoints(context, map, shape.lumen);
    context.fillStyle = theme.lumen;
    context.fill();
    context.clip();
    if (scene.particles) {
      const spacing = Math.sqrt(shape.area / scene.particles.x.length);
      drawParticles(context, map, scene.particles, scene.topSpeed, Math.max(1, spacing * map.scale));
    }
    drawThrombi(context, map, shape, theme);
    const colour = (k: number) => theme.cells[k % theme.cells.length]!;
    const overParticles = scene.particles !== undefined;
    for (const past of scene.trail) {
      past.forEach((cell, k) => drawPastCell(context, map, shape, cell, overParticles ? "white" : colour(k)));
    }
    scene.cells.forEach((cell, k) => drawCell(context, map, shape, cell, colour(k), overParticles));
    context.restore();

    strokeWalls(context, map, shape, theme.text, 1.5);
    if (scene.breach) drawBreach(context, map, scene.breach, theme);
    context.restore();
    drawAxis(context, map, x0, x1, bottom, theme);
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    this.observer.disconnect();
  }
}

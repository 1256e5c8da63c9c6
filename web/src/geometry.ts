/** Metres in the vessel to pixels on a canvas. y points up in the vessel and down on the canvas. */
export interface Mapping {
  /** px/m */
  scale: number;
  toX(x: number): number;
  toY(y: number): number;
}

/** A rectangle of the vessel, m. */
export interface Window {
  x0: number;
  x1: number;
  y0: number;
  y1: number;
}

export interface Margins {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** Shows `window` to scale over the whole width; its height follows. */
export function mapToWidth(window: Window, width: number, margins: Margins): Mapping & { height: number } {
  const scale = (width - margins.left - margins.right) / (window.x1 - window.x0);
  return {
    scale,
    toX: (x) => margins.left + (x - window.x0) * scale,
    toY: (y) => margins.top + (window.y1 - y) * scale,
    height: margins.top + (window.y1 - window.y0) * scale + margins.bottom,
  };
}

/** A stretch of `[0, length]` of the given width, about `centre` as far as the ends allow. */
export function stretchAbout(centre: number, width: number, length: number): [number, number] {
  if (width >= length) return [0, length];
  const start = Math.min(Math.max(0, centre - width / 2), length - width);
  return [start, start + width];
}

/** Area and centroid of a closed polygon, m2 and m; the area is positive if it runs counter-clockwise. */
export function areaAndCentroid(x: number[], y: number[]): { area: number; x: number; y: number } {
  // About the first corner: squares of micrometres far from the origin would cancel.
  const x0 = x[0] ?? 0;
  const y0 = y[0] ?? 0;
  let twice = 0;
  let sumX = 0;
  let sumY = 0;
  for (let i = 0, j = x.length - 1; i < x.length; j = i++) {
    const ax = x[j]! - x0;
    const ay = y[j]! - y0;
    const bx = x[i]! - x0;
    const by = y[i]! - y0;
    const cross = ax * by - bx * ay;
    twice += cross;
    sumX += (ax + bx) * cross;
    sumY += (ay + by) * cross;
  }
  if (twice === 0) return { area: 0, x: x0, y: y0 };
  return { area: twice / 2, x: x0 + sumX / (3 * twice), y: y0 + sumY / (3 * twice) };
}

/** Index of the value closest to `wanted` in an ascending list; -1 if it is empty. */
export function nearestIndex(ascending: ArrayLike<number>, wanted: number): number {
  let low = 0;
  let high = ascending.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (ascending[middle]! < wanted) low = middle + 1;
    else high = middle;
  }
  if (low === ascending.length) return low - 1;
  if (low === 0) return 0;
  return wanted - ascending[low - 1]! <= ascending[low]! - wanted ? low - 1 : low;
}

/** The least of 1, 2, 5 times a power of ten that cuts `span` into at most `parts`. */
export function niceStep(span: number, parts: number): number {
  const raw = span / parts;
  const power = 10 ** Math.floor(Math.log10(raw));
  // The slack keeps a span of exactly 1, 2 or 5 from the next step up.
  const factor = [1, 2, 5].find((f) => f * power >= raw * (1 - 1e-9)) ?? 10;
  return factor * power;
}

/**
 * What an axis shows of values from `low` to `high`: `room` (a fraction of their span) more at both sides, and
 * never less than a hundredth of the values' size, for a curve that is flat but for rounding is to look flat.
 */
export function axisRange(low: number | null, high: number | null, room: number): [number, number] {
  if (low === null || high === null || !Number.isFinite(low) || !Number.isFinite(high)) return [0, 1];
  const size = Math.max(Math.abs(low), Math.abs(high)) || 1;
  const half = Math.max((high - low) * (0.5 + room), size * 0.005);
  const middle = (low + high) / 2;
  return [middle - half, middle + half];
}

/** Indices of the times nearest to whole steps, one each: the instants whose outlines stay as a trail. */
export function trailIndices(times: ArrayLike<number>, step: number): number[] {
  const last = times[times.length - 1] ?? 0;
  const indices: number[] = [];
  for (let k = 0; k * step <= last * (1 + 1e-9); k++) {
    const index = nearestIndex(times, k * step);
    if (index >= 0 && Math.abs(times[index]! - k * step) <= step / 2 && !indices.includes(index))
      indices.push(index);
  }
  return indices;
}

import type { Series } from "./model.ts";

type Value = number | null;

/** The series so far, column by column; grows as rows arrive. */
export class SeriesTable {
  private columns = new Map<string, Value[]>();
  private count = 0;

  get rows(): number {
    return this.count;
  }

  /** s; undefined before the first row. */
  get lastTime(): number | undefined {
    return this.column("time").at(-1) ?? undefined;
  }

  clear(): void {
    this.columns.clear();
    this.count = 0;
  }

  append(series: Series): void {
    for (const name of series.columns) {
      if (!this.columns.has(name)) this.columns.set(name, []);
    }
    series.columns.forEach((name, k) => {
      const column = this.columns.get(name)!;
      for (const row of series.rows) column.push(row[k] ?? null);
    });
    this.count += series.rows.length;
  }

  column(name: string): Value[] {
    return this.columns.get(name) ?? [];
  }

  get cells(): number {
    let cells = 0;
    while (this.columns.has(`cell${cells}.x`)) cells++;
    return cells;
  }
}

/**
 * The rows in which the cell is further along than ever before: a curve over position needs ascending
 * positions, and a cell that is held up may be pushed back a little.
 */
export function onlyForward(x: Value[], y: Value[]): [number[], Value[]] {
  const xs: number[] = [];
  const ys: Value[] = [];
  let furthest = -Infinity;
  x.forEach((position, i) => {
    if (position === null || position <= furthest) return;
    furthest = position;
    xs.push(position);
    ys.push(y[i] ?? null);
  });
  return [xs, ys];
}

/**
 * Curves of different abscissas on one: `[x, y0, y1, ...]`. Each is linear between its own points and null
 * beyond them.
 */
export function joinCurves(curves: [number[], Value[]][]): [number[], ...Value[][]] {
  const xs = [...new Set(curves.flatMap(([x]) => x))].sort((a, b) => a - b);
  return [xs, ...curves.map(([x, y]) => valuesAt(x, y, xs))];
}

/** A curve's values at ascending abscissas; null outside of it or beside a missing value. */
function valuesAt(x: number[], y: Value[], wanted: number[]): Value[] {
  let right = 0;
  return wanted.map((place) => {
    while (right < x.length && x[right]! < place) right++;
    if (x[right] === place) return y[right] ?? null;
    const [before, after] = [y[right - 1], y[right]];
    if (before == null || after == null) return null;
    return before + ((after - before) * (place - x[right - 1]!)) / (x[right]! - x[right - 1]!);
  });
}

/** Linear between the rows; undefined outside of them or where a value is missing. */
export function valueAt(time: Value[], values: Value[], wanted: number): number | undefined {
  const [times, present] = onlyForward(time, values);
  return valuesAt(times, present, [wanted])[0] ?? undefined;
}

import type { Case, Outline, Tube, Vessel } from "./model.ts";

export interface Point {
  x: number;
  y: number;
}

/** What there is to draw of a vessel; m. */
export interface VesselShape {
  /** The closed outline of the fluid, counter-clockwise. */
  lumen: Point[];
  walls: Point[][];
  x0: number;
  x1: number;
  y0: number;
  y1: number;
  /** Across, where the flow comes in. */
  diameter: number;
  /** Of the fluid, thrombi not taken off; m2. */
  area: number;
  /** By how much it repeats along an axis; 0: not at all. */
  periodX: number;
  periodY: number;
  thrombi: (Point & { radius: number })[];
}

type Drawn = Pick<VesselShape, "lumen" | "walls" | "diameter" | "periodX" | "periodY">;

function parallelWalls(length: number, height: number): { lumen: Point[]; walls: Point[][] } {
  const lumen = [
    { x: 0, y: 0 },
    { x: length, y: 0 },
    { x: length, y: height },
    { x: 0, y: height },
  ];
  return { lumen, walls: [lumen.slice(0, 2), lumen.slice(2)] };
}

function box(vessel: Vessel): Drawn {
  const [width, height] = [vessel.width ?? 0, vessel.height ?? 0];
  const { lumen } = parallelWalls(width, height);
  const repeats = vessel.ends === "periodic";
  return {
    lumen,
    walls: repeats ? [] : [[...lumen, lumen[0]!]],
    diameter: height,
    periodX: repeats ? width : 0,
    periodY: repeats ? height : 0,
  };
}

/** The inner walls of the branches run beside the outer ones and meet in the apex. */
function bifurcation(vessel: Vessel, trunk: Tube): Drawn {
  const given = vessel.branches;
  const [lower, upper] = Array.isArray(given) ? given : [given, given];
  const angle = ((vessel.half_angle ?? 30) * Math.PI) / 180;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const branch = (tube: Tube | undefined, y: number, up: number) => {
    const { length, diameter } = tube ?? trunk;
    const outer = { x: trunk.length + length * c, y: y + up * length * s };
    return { outer, inner: { x: outer.x + diameter * s, y: outer.y - up * diameter * c } };
  };
  const low = branch(lower, 0, -1);
  const high = branch(upper, trunk.diameter, 1);
  const slope = s / c;
  const x = (low.inner.x + high.inner.x - (high.inner.y - low.inner.y) / slope) / 2;
  const apex = { x, y: low.inner.y + (low.inner.x - x) * slope };
  const walls = [
    [{ x: 0, y: 0 }, { x: trunk.length, y: 0 }, low.outer],
    [low.inner, apex, high.inner],
    [high.outer, { x: trunk.length, y: trunk.diameter }, { x: 0, y: trunk.diameter }],
  ];
  return { lumen: walls.flat(), walls, diameter: trunk.diameter, periodX: 0, periodY: 0 };
}

function drawn(vessel: Vessel): Drawn {
  if (vessel.shape === "box") return box(vessel);
  if (vessel.shape === "bifurcation" && vessel.trunk) return bifurcation(vessel, vessel.trunk);
  const [length, diameter] = [vessel.length ?? 0, vessel.diameter ?? 0];
  const periodX = vessel.ends === "periodic" ? length : 0;
  return { ...parallelWalls(length, diameter), diameter, periodX, periodY: 0 };
}

/** Where the wall that a thrombus stands on is at its x. */
function heightOf(wall: Point[], x: number): number {
  for (let i = 1; i < wall.length; i++) {
    const [a, b] = [wall[i - 1]!, wall[i]!];
    if (Math.min(a.x, b.x) <= x && x <= Math.max(a.x, b.x) && a.x !== b.x)
      return a.y + ((b.y - a.y) * (x - a.x)) / (b.x - a.x);
  }
  return wall[0]?.y ?? 0;
}

function areaOf(points: Point[]): number {
  return points.reduce((sum, a, i) => {
    const b = points[(i + 1) % points.length]!;
    return sum + (a.x * b.y - b.x * a.y) / 2;
  }, 0);
}

/** The vessel of a case as the service resolved it. */
export function vesselShape(scene: Case): VesselShape {
  const shape = drawn(scene.vessel);
  const xs = shape.lumen.map((point) => point.x);
  const ys = shape.lumen.map((point) => point.y);
  const thrombi = (scene.thrombi ?? []).map(({ wall, x, radius }) => ({
    x,
    y: heightOf((wall === "lower" ? shape.walls[0] : shape.walls.at(-1)) ?? [], x),
    radius,
  }));
  return {
    ...shape,
    x0: Math.min(...xs),
    x1: Math.max(...xs),
    y0: Math.min(...ys),
    y1: Math.max(...ys),
    area: areaOf(shape.lumen),
    thrombi,
  };
}

/** Displacements at which a cell is in sight: of one across the seam of a periodic vessel, its images' too. */
export function imagesInSight(outline: Outline, shape: VesselShape): [number, number][] {
  const steps = (positions: number[], period: number, from: number, to: number): number[] => {
    if (period === 0 || positions.length === 0) return [0];
    const [least, most] = [Math.min(...positions), Math.max(...positions)];
    return [-period, 0, period].filter((away) => most + away > from && least + away < to);
  };
  const along = steps(outline.x, shape.periodX, shape.x0, shape.x1);
  const across = steps(outline.y, shape.periodY, shape.y0, shape.y1);
  return along.flatMap((dx) => across.map((dy): [number, number] => [dx, dy]));
}

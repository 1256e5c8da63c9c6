import assert from "node:assert/strict";
import { test } from "node:test";
import type { Case, Vessel } from "../../../web/src/model.ts";
import { imagesInSight, vesselShape } from "../../../web/src/vessel_shape.ts";

const shapeOf = (vessel: Vessel, more: Partial<Case> = {}) => vesselShape({ vessel, duration: 1, ...more });
const close = (found: number | undefined, wanted: number) =>
  assert.ok(found !== undefined && Math.abs(found - wanted) < 1e-9, `${found} is not ${wanted}`);

test("a straight vessel has two walls and repeats along x if it is periodic", () => {
  const open = shapeOf({ shape: "straight", length: 8, diameter: 2, ends: "open" });
  assert.deepEqual([open.x0, open.x1, open.y0, open.y1], [0, 8, 0, 2]);
  assert.deepEqual([open.walls.length, open.area, open.periodX, open.periodY], [2, 16, 0, 0]);
  assert.equal(shapeOf({ length: 8, diameter: 2, ends: "periodic" }).periodX, 8);
});

test("a box is closed, or has no wall at all", () => {
  const closed = shapeOf({ shape: "box", width: 3, height: 2, ends: "closed" });
  assert.equal(closed.walls.length, 1);
  assert.deepEqual(closed.walls[0]![0], closed.walls[0]!.at(-1));
  const periodic = shapeOf({ shape: "box", width: 3, height: 2, ends: "periodic" });
  assert.deepEqual([periodic.walls.length, periodic.periodX, periodic.periodY], [0, 3, 2]);
});

test("a bifurcation's branches have their length, width and angle, and meet in the apex", () => {
  const trunk = { length: 4, diameter: 2 };
  const [lower, upper] = [
    { length: 5, diameter: 1 },
    { length: 3, diameter: 1.2 },
  ];
  const shape = shapeOf({ shape: "bifurcation", trunk, branches: [lower, upper], half_angle: 30 });
  const [low, inner, high] = shape.walls;
  const [lowEnd, highEnd] = [low![2]!, high![0]!];
  const [lowInner, apex, highInner] = inner!;
  close(Math.hypot(lowEnd.x - 4, lowEnd.y), 5);
  close(Math.hypot(highEnd.x - 4, highEnd.y - 2), 3);
  close(Math.hypot(lowEnd.x - lowInner!.x, lowEnd.y - lowInner!.y), 1);
  close(Math.hypot(highEnd.x - highInner!.x, highEnd.y - highInner!.y), 1.2);
  const tangent = Math.tan(Math.PI / 6);
  close((highInner!.y - apex!.y) / (highInner!.x - apex!.x), tangent);
  close((lowInner!.y - apex!.y) / (lowInner!.x - apex!.x), -tangent);
  assert.ok(shape.area > 8 + 0.8 * (5 + 3 * 1.2) && shape.area < 8 + 2 + 5 + 3 * 1.2, `area ${shape.area}`);
  assert.equal(shape.y0, Math.min(lowEnd.y, lowInner!.y));
});

test("branches alike may be given once, and a thrombus stands on its wall", () => {
  const vessel: Vessel = { shape: "bifurcation", trunk: { length: 4, diameter: 2 }, branches: { length: 5, diameter: 1 } };
  const thrombi: Case["thrombi"] = [
    { wall: "upper", x: 2, radius: 0.5 },
    { wall: "lower", x: 6, radius: 0.3 },
  ];
  const shape = shapeOf(vessel, { thrombi });
  close(shape.y0 + shape.y1, 2);
  close(shape.thrombi[0]!.y, 2);
  close(shape.thrombi[1]!.y, -2 * Math.tan(Math.PI / 6));
});

test("a cell across a seam is in sight twice, at a corner of a periodic box four times", () => {
  const outline = { x: [-1, 1, 1, -1], y: [-1, -1, 1, 1] };
  const tube = shapeOf({ length: 8, diameter: 4, ends: "periodic" });
  assert.deepEqual(imagesInSight(outline, tube), [
    [0, 0],
    [8, 0],
  ]);
  assert.equal(imagesInSight(outline, shapeOf({ shape: "box", width: 8, height: 8, ends: "periodic" })).length, 4);
  assert.deepEqual(imagesInSight({ x: [3, 4], y: [1, 2] }, tube), [[0, 0]]);
  assert.deepEqual(imagesInSight(outline, shapeOf({ length: 8, diameter: 4 })), [[0, 0]]);
});

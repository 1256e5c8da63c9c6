import assert from "node:assert/strict";
import { test } from "node:test";
import {
  areaAndCentroid,
  axisRange,
  mapToWidth,
  nearestIndex,
  niceStep,
  stretchAbout,
  trailIndices,
} from "../../../web/src/geometry.ts";

const close = (found: number, wanted: number) =>
  assert.ok(Math.abs(found - wanted) <= 1e-9 * Math.max(1e-6, Math.abs(wanted)), `${found} is not ${wanted}`);

test("the vessel fills the width, to scale, with y upwards", () => {
  const margins = { left: 10, right: 30, top: 5, bottom: 20 };
  const map = mapToWidth({ x0: 20e-6, x1: 60e-6, y0: 0, y1: 10e-6 }, 840, margins);
  close(map.scale, 20e6);
  close(map.toX(20e-6), 10);
  close(map.toX(60e-6), 810);
  close(map.toY(10e-6), 5);
  close(map.toY(0), 205);
  close(map.height, 225);
});

test("a close-up stays inside the vessel", () => {
  assert.deepEqual(stretchAbout(5, 4, 20), [3, 7]);
  assert.deepEqual(stretchAbout(1, 4, 20), [0, 4]);
  assert.deepEqual(stretchAbout(19.5, 4, 20), [16, 20]);
  assert.deepEqual(stretchAbout(2, 30, 20), [0, 20]);
});

test("area and centroid of a polygon far from the origin", () => {
  const { area, x, y } = areaAndCentroid([1000, 1002, 1002, 1000], [50, 50, 53, 53]);
  close(area, 6);
  close(x, 1001);
  close(y, 51.5);
  close(areaAndCentroid([0, 0, 1], [0, 1, 0]).area, -0.5);
});

test("the nearest of ascending values", () => {
  assert.equal(nearestIndex([], 1), -1);
  assert.equal(nearestIndex([0, 1, 2], -5), 0);
  assert.equal(nearestIndex([0, 1, 2], 1.4), 1);
  assert.equal(nearestIndex([0, 1, 2], 1.6), 2);
  assert.equal(nearestIndex([0, 1, 2], 9), 2);
});

test("steps are 1, 2 or 5 times a power of ten", () => {
  close(niceStep(0.009, 10), 1e-3);
  close(niceStep(0.01, 10), 1e-3);
  close(niceStep(0.015, 10), 2e-3);
  close(niceStep(80e-6, 16), 5e-6);
  close(niceStep(80e-6, 9), 10e-6);
});

test("an axis leaves room about its values, and more about those that differ by rounding alone", () => {
  const [low, high] = axisRange(1, 2, 0.1);
  close(low, 0.9);
  close(high, 2.1);
  const [flatLow, flatHigh] = axisRange(1, 1 + 1e-16, 0.1);
  close(flatLow, 0.995);
  close(flatHigh, 1.005);
  assert.deepEqual(axisRange(0, 0, 0), [-0.005, 0.005]);
  assert.deepEqual(axisRange(null, null, 0), [0, 1]);
});

test("the trail keeps the frames nearest to whole steps, each once", () => {
  const times = Array.from({ length: 26 }, (_, k) => k * 1e-4);
  assert.deepEqual(trailIndices(times, 1e-3), [0, 10, 20]);
  assert.deepEqual(trailIndices([0, 0.9e-3, 2.2e-3], 1e-3), [0, 1, 2]);
  assert.deepEqual(trailIndices([0, 3e-3], 1e-3), [0, 1]);
  assert.deepEqual(trailIndices([], 1e-3), []);
});

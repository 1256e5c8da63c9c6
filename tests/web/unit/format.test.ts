import assert from "node:assert/strict";
import { test } from "node:test";
import * as format from "../../../web/src/format.ts";

test("wall times use the units a person would", () => {
  assert.equal(format.duration(0), "0.0 s");
  assert.equal(format.duration(9.94), "9.9 s");
  assert.equal(format.duration(9.96), "10 s");
  assert.equal(format.duration(59.4), "59 s");
  assert.equal(format.duration(59.6), "1 min 0 s");
  assert.equal(format.duration(200), "3 min 20 s");
  assert.equal(format.duration(7500), "2 h 5 min");
  assert.equal(format.duration(NaN), "–");
});

test("time left is told in whole seconds, and not at all where it is unknown", () => {
  assert.equal(format.timeLeft(12.4), "12 s left");
  assert.equal(format.timeLeft(1.2), "1 s left");
  assert.equal(format.timeLeft(0.2), "about done");
  assert.equal(format.timeLeft(75), "1 min 15 s left");
  assert.equal(format.timeLeft(null), "");
  assert.equal(format.timeLeft(-1), "");
});

test("a running job never shows 100 %", () => {
  assert.equal(format.percent(0.999), "99 %");
  assert.equal(format.percent(0.29), "29 %");
  assert.equal(format.percent(1), "100 %");
  assert.equal(format.percent(1.2), "100 %");
});

test("quantities come in µm, ms and mm/s", () => {
  assert.equal(format.micrometres(33.14e-6), "33.1 µm");
  assert.equal(format.milliseconds(0.00231), "2.31 ms");
  assert.equal(format.speed(0.0072), "7.20 mm/s");
});

test("slow runs keep a digit more", () => {
  assert.equal(format.stepRate(3.07), "3.1 steps/s");
  assert.equal(format.stepRate(412.3), "412 steps/s");
});

test("a moment is told from now, and as a date after a day", () => {
  const now = Date.parse("2024-05-02T12:00:00Z");
  assert.equal(format.ago("2024-05-02T11:59:57.250Z", now), "just now");
  assert.equal(format.ago("2024-05-02T11:59:15Z", now), "45 s ago");
  assert.equal(format.ago("2024-05-02T11:00:01Z", now), "59 min ago");
  assert.equal(format.ago("2024-05-01T13:00:00Z", now), "23 h ago");
  assert.match(format.ago("2024-04-29T12:00:00Z", now), /2024/);
  assert.equal(format.ago("no time", now), "–");
});

test("wall time runs until the job ends", () => {
  const now = Date.parse("2024-05-02T12:00:00Z");
  assert.equal(format.wallTime({ started_at: null }, now), undefined);
  assert.equal(format.wallTime({ started_at: "2024-05-02T11:59:30Z" }, now), 30);
  assert.equal(
    format.wallTime({ started_at: "2024-05-02T11:00:00Z", ended_at: "2024-05-02T11:01:00Z" }, now),
    60,
  );
});

import assert from "node:assert/strict";
import { test } from "node:test";
import { pause } from "../../../web/src/poll.ts";
import { jobHref, olderHref, parseRoute } from "../../../web/src/route.ts";

test("an address leads where its link was made for", () => {
  assert.deepEqual(parseRoute(""), { page: "jobs" });
  assert.deepEqual(parseRoute("#/"), { page: "jobs" });
  assert.deepEqual(parseRoute(jobHref("0193-ab")), { page: "job", id: "0193-ab" });
  assert.deepEqual(parseRoute(olderHref("a+b/c=&d")), { page: "jobs", pageToken: "a+b/c=&d" });
});

test("looks are a second apart, rarer when hidden and after failures, but never given up", () => {
  assert.equal(pause(0, false), 1000);
  assert.equal(pause(2, false), 4000);
  assert.equal(pause(50, false), 15_000);
  assert.equal(pause(0, true), 10_000);
  assert.equal(pause(50, true), 15_000);
});

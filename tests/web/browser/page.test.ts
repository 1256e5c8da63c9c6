import assert from "node:assert/strict";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { chromium, type BrowserContext, type Page } from "playwright-core";
import { cellPixels } from "./pixels.ts";
import { startServer, type Server } from "./server.ts";

const flags = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];
const patience = 30_000;
const longestRun = 150_000;

let server: Server;
let profile: string;
let context: BrowserContext;
let page: Page;
let complaints: string[] = [];

/** Lets the page's next submission through with another case in it, so that the button itself is what is tested. */
async function changeNextCase(change: (scene: Record<string, unknown>) => void): Promise<void> {
  await page.route(
    "**/v1/jobs",
    async (route) => {
      const body = route.request().postDataJSON();
      change(body.case);
      await route.continue({ postData: JSON.stringify(body) });
    },
    { times: 1 },
  );
}

/** The state that the job on show ends in. */
async function endState(timeout = patience): Promise<string | undefined> {
  const ended = ["succeeded", "failed", "cancelled"]
    .map((state) => `.job .state[data-state="${state}"]`)
    .join(", ");
  await page.locator(ended).waitFor({ timeout });
  return (await page.locator(ended).textContent()) ?? undefined;
}

before(async () => {
  const { ROULEAU_BINARY: program, CHROMIUM: browser } = process.env;
  assert.ok(program && browser, "ROULEAU_BINARY and CHROMIUM name the programs to test with");
  server = await startServer(program);
  profile = await mkdtemp(join(tmpdir(), "rouleau-chromium-"));
  context = await chromium.launchPersistentContext(profile, {
    executablePath: browser,
    headless: true,
    args: flags,
    viewport: { width: 1100, height: 900 },
    acceptDownloads: true,
  });
  context.setDefaultTimeout(patience);
  page = context.pages()[0] ?? (await context.newPage());
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.stack ?? String(error)));
  page.on("request", (request) => {
    const url = request.url();
    if (!url.startsWith(server.address) && !/^(data|blob):/.test(url)) complaints.push(`asked for ${url}`);
  });
});

after(async () => {
  await context?.close();
  if (profile) await rm(profile, { recursive: true, force: true });
  if (server) assert.equal(await server.stop(), 0, "the server drains and ends well");
});

test("an empty service says what to do, and shows every fault of a refused case", async () => {
  await page.goto(server.address);
  await page.getByRole("heading", { name: "No jobs yet" }).waitFor();
  await changeNextCase((scene) => {
    scene.duration = -1;
    scene.colour = "red";
  });
  await page.getByRole("button", { name: "Run the example" }).click();
  const alert = page.getByRole("alert");
  await alert.waitFor();
  const text = (await alert.textContent()) ?? "";
  assert.match(text, /duration/);
  assert.match(text, /colour/);
  // The browser itself notes that answer on its console.
  assert.equal(complaints.length, 1, complaints.join("\n"));
  assert.match(complaints[0]!, /status of 422/);
  complaints = [];
});

test("the example runs to its end while its cell and curves are drawn", async () => {
  await changeNextCase((scene) => {
    scene.duration = 4e-4;
    scene.numerics = { preset: "draft", refine: "off" };
    scene.output = { series_interval: 2e-5, frame_interval: 1e-4 };
  });
  await page.getByRole("button", { name: "Run the example" }).click();
  await page.waitForURL(/#\/jobs\/[0-9a-f-]{36}$/);
  await page.getByRole("heading", { name: "single cell, 8 d0 thrombus" }).waitFor();
  assert.equal(await endState(longestRun), "succeeded", await page.locator(".job header").innerText());

  await page.getByText("Peak velocity").waitFor();
  await page.getByText("0.40 ms", { exact: true }).first().waitFor();
  const scrubber = page.getByLabel("Simulated time");
  assert.equal(await scrubber.getAttribute("max"), "4");
  await page.getByLabel("Trail").uncheck();
  await page.waitForTimeout(200);
  const last = await cellPixels(page, ".vessel canvas");
  await scrubber.fill("0");
  await page.getByText("0.00 ms", { exact: true }).waitFor();
  await page.waitForTimeout(200);
  const first = await cellPixels(page, ".vessel canvas");
  assert.ok(first.count > 100 && last.count > 100, `outlines of ${first.count} and ${last.count} pixels`);
  assert.ok(
    Math.abs(first.x - 0.2) < 0.03,
    `the cell starts at ${first.x} of the vessel, not at 16 of 80 µm`,
  );
  assert.ok(last.x > first.x + 0.01, `the cell moved from ${first.x} to ${last.x} of the vessel`);

  for (const k of [1, 2]) {
    const curve = await cellPixels(page, `.chart:nth-child(${k}) canvas`);
    assert.ok(curve.count > 200, `a curve of ${curve.count} pixels`);
    const legend = page.locator(`.chart:nth-child(${k}) .u-legend .u-value`).nth(1);
    assert.match((await legend.textContent()) ?? "", /^-?\d+\.\d+$/);
  }
});

test("the particles, the film and the curves over time work on a finished job", async () => {
  await page.getByLabel("Flow by speed").check();
  await page.locator(".scale").waitFor();
  await page.getByLabel("Curves over").selectOption("time");
  await page.locator(".chart .u-legend", { hasText: "time (ms)" }).first().waitFor();
  await page.getByRole("button", { name: "Play" }).click();
  await page.getByRole("button", { name: "Pause" }).waitFor();
  await page.getByText("0.40 ms", { exact: true }).first().waitFor();
  await page.getByRole("button", { name: "Play" }).waitFor();
});

test("what a job leaves behind can be downloaded", async () => {
  const [series] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "series.csv" }).click(),
  ]);
  const lines = (await readFile(await series.path(), "utf8")).trim().split("\n");
  assert.match(lines[0]!, /^time,cell0\.x,cell0\.y,cell0\.u/);
  assert.ok(lines.length > 10);
  const [archive] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("link", { name: "archive.h5" }).click(),
  ]);
  const start = (await readFile(await archive.path())).subarray(0, 8);
  assert.deepEqual([...start], [0x89, 0x48, 0x44, 0x46, 0x0d, 0x0a, 0x1a, 0x0a]);
});

test("a job is cancelled from the page, and the list shows how both ended, on a narrow screen too", async () => {
  await page.setViewportSize({ width: 400, height: 800 });
  await page.getByRole("link", { name: "Jobs" }).click();
  await page.getByRole("button", { name: "Run the example" }).click();
  await page.waitForURL(/#\/jobs\//);
  await page.getByRole("button", { name: "Cancel" }).click();
  assert.equal(await endState(), "cancelled");
  const tooWide = () => page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  assert.ok((await tooWide()) <= 0, "a job fits the screen");
  await page.getByRole("link", { name: "Jobs" }).click();
  const states = page.locator("table.jobs tbody .state");
  await states.first().waitFor();
  assert.deepEqual(await states.allTextContents(), ["cancelled", "succeeded"]);
  assert.ok((await tooWide()) <= 0, "the list fits the screen");
});

test("a job that went unstable says why, and shows and leaves what it computed", async () => {
  await page.setViewportSize({ width: 1100, height: 900 });
  await changeNextCase((scene) => {
    // Walls drag a limp cell apart until it is too thin for its spacing.
    scene.duration = 3e-3;
    scene.plasma = { kinematic_viscosity: 1e-5 };
    const walls = { lower: -0.05, upper: 0.05 };
    scene.vessel = { length: 20e-6, diameter: 10e-6, ends: "periodic", wall_velocity: walls };
    scene.thrombi = [];
    scene.cells = [
      { x: 10e-6, y: 5e-6, diameter: 6e-6, fill: 1, shape: "circle", stretch_modulus: 1e-9, bend_modulus: 1e-20 },
    ];
    delete scene.inflow;
    delete scene.outflow;
    scene.numerics = { preset: "draft", refine: "off" };
    scene.output = { series_interval: 2e-5, frame_interval: 1e-4 };
  });
  await page.getByRole("button", { name: "Run the example" }).click();
  await page.waitForURL(/#\/jobs\//);
  assert.equal(await endState(longestRun), "failed", await page.locator(".job header").innerText());
  const alert = page.getByRole("alert");
  assert.match((await alert.textContent()) ?? "", /The run went unstable.*Allowed.*When.*Where.*Cell/s);
  await page.getByText("Peak velocity").waitFor();
  assert.ok(Number(await page.getByLabel("Simulated time").getAttribute("max")) >= 2, "it has its frames");
  await page.getByLabel("The vessel and its cells; the ring is where the run went unstable").waitFor();
  await page.getByLabel("Simulated time").fill("0");
  await page.getByLabel("The vessel and its cells", { exact: true }).waitFor();
  await page.getByRole("button", { name: "series.csv" }).waitFor();
  const [archive] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("link", { name: "archive.h5" }).click(),
  ]);
  assert.ok((await readFile(await archive.path())).length > 1000);
});

test("a bifurcation and a box are drawn, too", async () => {
  const shapes = [
    { shape: "bifurcation", trunk: { length: 30e-6, diameter: 16e-6 }, branches: { length: 20e-6, diameter: 8e-6 } },
    { shape: "box", width: 20e-6, height: 20e-6, wall_velocity: { upper: 0.01 } },
  ];
  for (const vessel of shapes) {
    await page.getByRole("link", { name: "Jobs" }).first().click();
    await changeNextCase((scene) => {
      scene.vessel = vessel;
      scene.thrombi = [];
      scene.cells = [{ x: 8e-6, y: 8e-6, diameter: 5e-6 }];
      if (vessel.shape === "box") for (const name of ["inflow", "outflow"]) delete scene[name];
      scene.duration = 5e-5;
      scene.numerics = { preset: "draft" };
      scene.output = { frame_interval: 1e-5 };
    });
    await page.getByRole("button", { name: "Run the example" }).click();
    await page.waitForURL(/#\/jobs\//);
    assert.equal(await endState(longestRun), "succeeded", await page.locator(".job header").innerText());
    await page.waitForTimeout(300);
    const cell = await cellPixels(page, ".vessel canvas");
    assert.ok(cell.count > 100, `${vessel.shape}: an outline of ${cell.count} pixels`);
    const height = await page.locator(".vessel canvas").evaluate((canvas) => canvas.clientHeight);
    assert.ok(height > 300 && height < 700, `${vessel.shape}: ${height} px tall`);
  }
});

test("nothing was complained of, and nothing asked of anyone else", () => {
  assert.deepEqual(complaints, []);
});

// BullMQ over a Redis that answers after its append-only file is on the disk (PORT). Ending jobs is left to a
// Worker with as many jobs at a time as there are clients, as its documentation advises: it ends one and claims
// the next in one call.
import { Queue, Worker } from "bullmq";
import Redis from "ioredis";
import { clients, jobs, measure, payload, report } from "./measure.mjs";

const connect = () => new Redis({ port: Number(process.env.PORT), maxRetriesPerRequest: null });
const check = connect();
for (const [name, value] of [["appendonly", "yes"], ["appendfsync", "always"]]) {
  if ((await check.config("GET", name))[1] !== value) throw new Error(`${name} is not ${value}`);
}
check.disconnect();

const queues = Array.from({ length: clients }, () => new Queue("case", { connection: connect() }));
await Promise.all(queues.map((queue) => queue.waitUntilReady()));
await measure("enqueue", (k, client) => queues[client].add("case", payload(k)));

let [ended, begun] = [0, 0];
const took = [];
await new Promise((done) => {
  const worker = new Worker("case", async () => undefined, { connection: connect(), concurrency: clients, autorun: false });
  worker.on("completed", (job) => {
    took.push(Date.now() - job.processedOn);
    if (++ended === jobs) done();
  });
  worker.waitUntilReady().then(() => {
    begun = performance.now();
    worker.run();
  });
});
report("claim and complete", (performance.now() - begun) / 1000, took);
process.exit(0);

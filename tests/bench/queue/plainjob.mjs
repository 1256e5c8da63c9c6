// plainjob in one process, with the durability that it does not have of itself: it asks SQLite for NORMAL, which
// may lose what was accepted last.
import Database from "better-sqlite3";
import { better, defineQueue } from "plainjob";
import { folder, measure, payload } from "./measure.mjs";

const database = new Database(`${folder}/jobs.sqlite`);
const quiet = { debug() {}, info() {}, warn() {}, error: console.error };
const queue = defineQueue({ connection: better(database), logger: quiet });
database.pragma("synchronous = FULL");
if (database.pragma("synchronous", { simple: true }) !== 2) throw new Error("not FULL");

await measure("enqueue", async (k) => queue.add("case", payload(k)));
await measure("claim and complete", async () => {
  const job = queue.getAndMarkJobAsProcessing("case");
  JSON.parse(queue.getJobById(job.id).data);
  queue.markJobAsDone(job.id);
});
queue.close();

// pg-boss on a PostgreSQL (PORT) that answers after its log is on the disk.
import PgBoss from "pg-boss";
import pg from "pg";
import { clients, measure, payload } from "./measure.mjs";

const address = { host: "127.0.0.1", port: Number(process.env.PORT), user: "postgres", database: "postgres" };
const check = new pg.Client(address);
await check.connect();
for (const name of ["fsync", "synchronous_commit"]) {
  const shown = (await check.query(`SHOW ${name}`)).rows[0][name];
  if (shown !== "on") throw new Error(`${name} is ${shown}`);
}
await check.end();

const boss = new PgBoss({ ...address, max: clients, supervise: false, schedule: false });
await boss.start();
await boss.createQueue("case");
await measure("enqueue", (k) => boss.send("case", payload(k)));
await measure("claim and complete", async () => {
  const [job] = await boss.fetch("case");
  await boss.complete("case", job.id);
});
process.exit(0);

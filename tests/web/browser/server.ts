import { spawn } from "node:child_process";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";

const startTime = 30_000;

export interface Server {
  address: string;
  /** Asks it to drain, and waits until it has. @returns its exit code */
  stop(): Promise<number | null>;
}

/** Starts `rouleau serve` on a free port, with a data folder of its own. */
export async function startServer(program: string): Promise<Server> {
  const folder = await mkdtemp(join(tmpdir(), "rouleau-web-"));
  const portFile = join(folder, "port");
  const options = [
    "--port",
    "0",
    "--port-file",
    portFile,
    "--health-port",
    "0",
    "--data",
    join(folder, "data"),
  ];
  const child = spawn(program, ["serve", ...options, "--workers", "1", "--log-level", "warn"], {
    stdio: ["ignore", "inherit", "inherit"],
  });
  const ended = new Promise<number | null>((resolve) => child.on("close", resolve));
  let running = true;
  void ended.then(() => (running = false));

  async function stop(): Promise<number | null> {
    child.kill("SIGTERM");
    const code = await ended;
    await rm(folder, { recursive: true, force: true });
    return code;
  }

  for (const deadline = Date.now() + startTime; Date.now() < deadline && running; await sleep(50)) {
    const port = await readFile(portFile, "utf8").catch(() => "");
    if (port.endsWith("\n") || /^\d+$/.test(port))
      return { address: `http://127.0.0.1:${port.trim()}`, stop };
  }
  await stop();
  throw new Error(`${program} serve did not start`);
}

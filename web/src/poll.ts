/** What a look at the service says about the next one. */
export type Next = "again" | "done";

const interval = 1000;
const hiddenInterval = 10_000;
const longestInterval = 15_000;

/** Milliseconds to the next look: rarer while nobody watches, and after failures. */
export function pause(failures: number, hidden: boolean): number {
  const base = hidden ? hiddenInterval : interval;
  return Math.max(base, Math.min(longestInterval, interval * 2 ** failures));
}

/**
 * Calls `look` now and about once a second until it answers "done".
 * `onFailure` hears of every failed look, and of undefined once one succeeds again.
 * @returns what stops it and aborts the look under way
 */
export function poll(
  look: (signal: AbortSignal) => Promise<Next>,
  onFailure: (failure: unknown) => void,
): () => void {
  const abort = new AbortController();
  let timer = 0;
  let failures = 0;
  let looking = false;

  async function run(): Promise<void> {
    window.clearTimeout(timer);
    looking = true;
    let next: Next = "again";
    try {
      next = await look(abort.signal);
      if (failures > 0) onFailure(undefined);
      failures = 0;
    } catch (failure) {
      if (abort.signal.aborted) return;
      failures += 1;
      onFailure(failure);
    }
    looking = false;
    if (abort.signal.aborted) return;
    if (next === "done") stop();
    else timer = window.setTimeout(run, pause(failures, document.hidden));
  }

  function onVisible(): void {
    if (!document.hidden && !looking) void run();
  }

  function stop(): void {
    abort.abort();
    window.clearTimeout(timer);
    document.removeEventListener("visibilitychange", onVisible);
  }

  document.addEventListener("visibilitychange", onVisible);
  void run();
  return stop;
}

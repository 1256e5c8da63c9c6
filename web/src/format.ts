/** Numbers and times as a person reads them. */

/** Wall time: "0.8 s", "12 s", "3 min 20 s", "2 h 5 min". */
export function duration(seconds: number): string {
  if (!Number.isFinite(seconds) || seconds < 0) return "–";
  if (seconds < 9.95) return `${seconds.toFixed(1)} s`;
  const whole = Math.round(seconds);
  if (whole < 60) return `${whole} s`;
  if (whole < 3600) return `${Math.floor(whole / 60)} min ${whole % 60} s`;
  const minutes = Math.round(seconds / 60);
  return `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

/** "12 s left"; nothing where it is not known yet. */
export function timeLeft(seconds: number | null | undefined): string {
  if (seconds == null || !Number.isFinite(seconds) || seconds < 0) return "";
  if (seconds < 1) return "about done";
  return `${duration(Math.max(1, Math.round(seconds))).replace(".0 s", " s")} left`;
}

export function percent(fraction: number): string {
  const clamped = Math.min(1, Math.max(0, fraction));
  return `${Math.floor(clamped * 100 + 1e-9)} %`;
}

export function milliseconds(seconds: number, digits = 2): string {
  return `${(seconds * 1e3).toFixed(digits)} ms`;
}

export function micrometres(metres: number, digits = 1): string {
  return `${(metres * 1e6).toFixed(digits)} µm`;
}

export function speed(metresPerSecond: number): string {
  return `${(metresPerSecond * 1e3).toFixed(2)} mm/s`;
}

/** How fast a run goes: "3.1 steps/s", "412 steps/s". */
export function stepRate(stepsPerSecond: number): string {
  return `${stepsPerSecond.toFixed(stepsPerSecond < 10 ? 1 : 0)} steps/s`;
}

/** A sentence as the service words it, with a capital. */
export function sentence(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** When something happened, seen from `now`: "3 min ago", or the date once that says more. */
export function ago(iso: string, now: number): string {
  const then = Date.parse(iso);
  if (Number.isNaN(then)) return "–";
  const seconds = (now - then) / 1000;
  if (seconds < 10) return "just now";
  if (seconds < 60) return `${Math.floor(seconds)} s ago`;
  if (seconds < 3600) return `${Math.floor(seconds / 60)} min ago`;
  if (seconds < 86400) return `${Math.floor(seconds / 3600)} h ago`;
  return new Date(then).toLocaleDateString(undefined, { day: "numeric", month: "short", year: "numeric" });
}

/** How long a job has computed, s; undefined before it starts. */
export function wallTime(
  job: { started_at?: string | null; ended_at?: string | null },
  now: number,
): number | undefined {
  if (!job.started_at) return undefined;
  const until = job.ended_at ? Date.parse(job.ended_at) : now;
  return Math.max(0, (until - Date.parse(job.started_at)) / 1000);
}

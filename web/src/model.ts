/** What the service sends, as docs/api.md describes it. SI units throughout. */

export type JobState = "queued" | "running" | "paused" | "cancelling" | "succeeded" | "failed" | "cancelled";

const ended: ReadonlySet<JobState> = new Set<JobState>(["succeeded", "failed", "cancelled"]);

export function hasEnded(state: JobState): boolean {
  return ended.has(state);
}

export interface Progress {
  simulated_time: number;
  duration: number;
  fraction: number;
  steps: number;
  steps_per_second: number;
  eta_s: number | null;
}

export interface CellSummary {
  peak_velocity: number;
  peak_velocity_x: number;
  peak_tau: number;
  least_tau: number;
  area_deviation: number;
  /** Once it has left the vessel; s. */
  departure?: { time: number; outlet: number } | null;
}

export interface Summary {
  ending: string;
  reason: string;
  simulated_time: number;
  steps: number;
  wall_time: number;
  steps_per_second: number;
  cells: CellSummary[];
  warnings?: string[];
}

export interface JobError {
  kind: "case" | "engine" | "infrastructure" | "timeout";
  message: string;
  /** Of a case that cannot be computed: all its faults. */
  errors?: { pointer: string; message: string }[];
  /** Of a run that went unstable: the quantity that left its bounds, where and when; SI units. */
  quantity?: string;
  value?: number;
  bound?: number;
  unit?: string;
  simulated_time?: number;
  step?: number;
  x?: number;
  y?: number;
  /** -1 if the whole run is meant */
  particle?: number;
  /** -1 for plasma */
  cell?: number;
}

export interface Thrombus {
  wall: "lower" | "upper";
  x: number;
  radius: number;
}

export interface Tube {
  length: number;
  diameter: number;
}

/** Straight with `length` and `diameter`, a box, or a bifurcation. */
export interface Vessel extends Partial<Tube> {
  shape?: "straight" | "box" | "bifurcation";
  ends?: string;
  width?: number;
  height?: number;
  trunk?: Tube;
  branches?: Tube | Tube[];
  /** degrees */
  half_angle?: number;
}

export interface Case {
  name?: string;
  vessel: Vessel;
  thrombi?: Thrombus[];
  cells?: { x: number; y: number }[];
  duration: number;
}

export interface Job {
  id: string;
  state: JobState;
  name: string;
  /** Counts the times it was started; each starts its results afresh. */
  attempt?: number;
  created_at: string;
  started_at?: string | null;
  ended_at?: string | null;
  progress?: Progress | null;
  /** Of a run that came to an end of its own, a bad one too: then there is an archive. */
  summary?: Summary | null;
  error?: JobError | null;
  case?: Case;
}

export interface JobList {
  jobs: Job[];
  next_page_token?: string;
}

export interface Series {
  columns: string[];
  units: Record<string, string>;
  rows: (number | null)[][];
}

/** A closed curve, counter-clockwise, m. */
export interface Outline {
  x: number[];
  y: number[];
}

export interface Particles {
  x: number[];
  y: number[];
  /** What the case's `output.fields` do not name is absent. */
  u?: number[];
  v?: number[];
  p?: number[];
  /** 0 plasma, 1 inside a cell, 2 membrane */
  kind: number[];
}

/** The frames so far, and from frame `from` on the outlines of the cells in each. */
export interface FrameList {
  times: number[];
  from: number;
  outlines: Outline[][];
}

export interface Frame {
  time: number;
  outlines: Outline[];
  particles?: Particles | null;
}

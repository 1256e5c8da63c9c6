import type { Case, Frame, FrameList, Job, JobList, Series } from "./model.ts";

export interface FieldError {
  pointer: string;
  message: string;
}

/** An answer that is no success: RFC 9457 problem+json where the service sent one. */
export class Problem extends Error {
  constructor(
    readonly status: number,
    readonly title: string,
    readonly detail: string,
    readonly errors: FieldError[] = [],
  ) {
    super(detail ? `${title}: ${detail}` : title);
  }
}

async function problemOf(response: Response): Promise<Problem> {
  try {
    const body = await response.json();
    return new Problem(
      response.status,
      String(body.title ?? response.statusText),
      String(body.detail ?? ""),
      Array.isArray(body.errors) ? body.errors : [],
    );
  } catch {
    return new Problem(response.status, `The service answered ${response.status}`, response.statusText);
  }
}

async function request(path: string, init: RequestInit = {}): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(path, { cache: "no-store", ...init });
  } catch (cause) {
    if (cause instanceof DOMException && cause.name === "AbortError") throw cause;
    throw new Problem(0, "The service cannot be reached", "The page goes on trying.");
  }
  if (!response.ok) throw await problemOf(response);
  return response;
}

async function get<T>(path: string, signal?: AbortSignal): Promise<T> {
  return (await request(path, signal ? { signal } : {})).json();
}

async function post<T>(path: string, body?: unknown): Promise<T> {
  const init: RequestInit = { method: "POST" };
  if (body !== undefined) {
    init.headers = { "Content-Type": "application/json" };
    init.body = JSON.stringify(body);
  }
  return (await request(path, init)).json();
}

export function jobPath(id: string): string {
  return `v1/jobs/${encodeURIComponent(id)}`;
}

export function listJobs(pageToken: string | undefined, signal?: AbortSignal): Promise<JobList> {
  const query = new URLSearchParams({ page_size: "20" });
  if (pageToken) query.set("page_token", pageToken);
  return get(`v1/jobs?${query}`, signal);
}

export function getJob(id: string, signal?: AbortSignal): Promise<Job> {
  return get(jobPath(id), signal);
}

export function submitCase(scene: Case): Promise<Job> {
  return post("v1/jobs", { case: scene });
}

export function cancelJob(id: string): Promise<Job> {
  return post(`${jobPath(id)}:cancel`);
}

/** The rows of the series later than `after` (s), or all of them. */
export function getSeries(id: string, after: number | undefined, signal?: AbortSignal): Promise<Series> {
  return get(`${jobPath(id)}/series${after === undefined ? "" : `?after=${after}`}`, signal);
}

export async function getSeriesCsv(id: string): Promise<Blob> {
  return (await request(`${jobPath(id)}/series`, { headers: { Accept: "text/csv" } })).blob();
}

/** The times of all frames, and the cells' outlines from frame `from` on. */
export function getOutlines(id: string, from: number, signal?: AbortSignal): Promise<FrameList> {
  return get(`${jobPath(id)}/frames?fields=outlines&from=${from}`, signal);
}

/** One frame with its particles. */
export function getFrame(id: string, index: number, signal?: AbortSignal): Promise<Frame> {
  return get(`${jobPath(id)}/frames/${index}`, signal);
}

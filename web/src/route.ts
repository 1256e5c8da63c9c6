/** Where the address's hash leads. */
export type Route = { page: "jobs"; pageToken?: string } | { page: "job"; id: string };

export function parseRoute(hash: string): Route {
  const job = /^#\/jobs\/([^/?]+)$/.exec(hash);
  if (job?.[1]) return { page: "job", id: decodeURIComponent(job[1]) };
  const pageToken = new URLSearchParams(hash.split("?")[1] ?? "").get("page");
  return pageToken ? { page: "jobs", pageToken } : { page: "jobs" };
}

export function jobHref(id: string): string {
  return `#/jobs/${encodeURIComponent(id)}`;
}

export function olderHref(pageToken: string): string {
  return `#/?${new URLSearchParams({ page: pageToken })}`;
}

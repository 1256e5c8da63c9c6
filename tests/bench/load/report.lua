-- What both have in common: PAUSE_MS after each answer, and one line of JSON when wrk is done; times in ms.
local pause = tonumber(os.getenv("PAUSE_MS"))
if pause > 0 then
  function delay()
    return pause
  end
end

function done(summary, latency)
  local wrong = summary.errors.connect + summary.errors.read + summary.errors.write + summary.errors.status + summary.errors.timeout
  io.write(string.format(
    '{"requests": %d, "wrong": %d, "rate": %.1f, "p50_ms": %.3f, "p99_ms": %.3f, "p99_9_ms": %.3f, "most_ms": %.3f}\n',
    summary.requests, wrong, summary.requests / summary.duration * 1e6, latency:percentile(50) / 1e3,
    latency:percentile(99) / 1e3, latency:percentile(99.9) / 1e3, latency.max / 1e3))
end

-- POST /v1/jobs, no case like another.
local threads = 0

function setup(thread)
  threads = threads + 1
  thread:set("number", threads)
end

local sent = 0
local head = '{"case":{"version":1,"name":"load","vessel":{"length":2e-5,"diameter":1e-5},"numerics":{"preset":"draft"},"duration":'

function request()
  sent = sent + 1
  local duration = string.format("%.12g", 1e-4 + 1e-7 * number + 1e-12 * sent)
  return wrk.format("POST", "/v1/jobs", { ["Content-Type"] = "application/json" }, head .. duration .. "}}")
end

dofile(os.getenv("REPORT"))

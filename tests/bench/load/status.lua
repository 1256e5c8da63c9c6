-- GET /v1/jobs/ID over the ids in the file that JOBS names, each thread in an order of its own.
local ids = {}
for line in io.lines(os.getenv("JOBS")) do ids[#ids + 1] = line end
local threads = 0

function setup(thread)
  threads = threads + 1
  thread:set("seed", threads)
end

function init()
  math.randomseed(seed)
end

function request()
  return wrk.format("GET", "/v1/jobs/" .. ids[math.random(#ids)])
end

dofile(os.getenv("REPORT"))

// How fast the job store takes jobs and ends them, each call answered after its commit is on the disk. Prints
// one line of JSON a measure; queue_run.py runs it in turns with other queues.
//
//     store_bench FOLDER JOBS CLIENTS PAYLOAD_BYTES

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "storage/job_store.h"
#include "storage/sha256.h"

namespace rouleau::storage {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begun) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
}

double percentile(std::vector<double> sorted, double share) {
  const auto last = static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(share * last + 0.5)];
}

/// Calls `one(k)` for each k below `jobs`, from as many threads as there are clients, and prints the rate.
void measure(const char* name, int jobs, int clients, const std::function<void(int)>& one) {
  std::atomic<int> next = 0;
  std::vector<std::vector<double>> took(static_cast<std::size_t>(clients));
  std::vector<std::thread> threads;
  const auto begun = Clock::now();
  for (auto& mine : took) {
    threads.emplace_back([&] {
      for (int k = next++; k < jobs; k = next++) {
        const auto asked = Clock::now();
        one(k);
        mine.push_back(milliseconds_since(asked));
      }
    });
  }
  for (auto& thread : threads) thread.join();
  const double seconds = milliseconds_since(begun) / 1000;
  std::vector<double> all;
  for (const auto& mine : took) all.insert(all.end(), mine.begin(), mine.end());
  std::sort(all.begin(), all.end());
  std::printf(R"({"measure": "%s", "jobs": %d, "rate": %.1f, "p50_ms": %.3f, "p99_ms": %.3f})"
              "\n",
              name, jobs, jobs / seconds, percentile(all, 0.5), percentile(all, 0.99));
}

NewJob job_of_size(int k, std::size_t bytes) {
  const std::string mark = R"({"version":1,"name":")" + std::to_string(k) + '-';
  NewJob job;
  job.name = std::to_string(k);
  job.case_resolved = mark + std::string(bytes - mark.size() - 2, 'x') + "\"}";
  job.case_hash = sha256_hex(job.case_resolved);
  job.case_given = job.case_resolved;
  job.plan = R"({"particles":1250,"time_step":1e-06})";
  return job;
}

void run(const std::filesystem::path& folder, int jobs, int clients, std::size_t bytes) {
  JobStore store(folder);
  const JobResult result{R"({"ending":"completed"})", 1234, std::string(64, 'a')};
  measure("enqueue", jobs, clients, [&](int k) { store.submit(job_of_size(k, bytes)); });
  measure("claim and complete", jobs, clients, [&](int) {
    const auto claimed = store.claim("bench", std::chrono::seconds(60));
    if (!claimed || !store.succeed(claimed->job.id, claimed->job.attempt, result)) std::abort();
  });
}

}  // namespace
}  // namespace rouleau::storage

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fputs("usage: store_bench FOLDER JOBS CLIENTS PAYLOAD_BYTES\n", stderr);
    return 2;
  }
  rouleau::storage::run(argv[1], std::atoi(argv[2]), std::atoi(argv[3]),
                        static_cast<std::size_t>(std::atoi(argv[4])));
  return 0;
}

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "storage/job_store.h"
#include "storage/sqlite/folder_lock.h"
#include "storage/sqlite/group_writer.h"
#include "storage/sqlite/reader_pool.h"
#include "storage/uuid.h"

namespace rouleau::storage {

/// What the files that make up JobStore share.
struct JobStore::Parts {
  Parts(const std::filesystem::path& folder, Clock time);

  Clock clock;
  FolderLock lock;
  GroupWriter writer;
  ReaderPool readers;

  // The writer's alone.
  UuidSource ids;                              ///< so that ids rise in the order of commits
  std::map<std::string, std::uint64_t> turns;  ///< when each lane was last served
  std::uint64_t last_turn = 0;
};

/// Binds :id and :attempt.
void bind_attempt(Prepared& statement, std::string_view id, int attempt);

/// Binds :summary, :size, :sha256 and :archive.
void bind_result(Prepared& statement, const JobResult& result, std::string_view archive_id);

}  // namespace rouleau::storage

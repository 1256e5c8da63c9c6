#include "storage/hdf5/session.h"

#include <cerrno>
#include <cstdlib>
#include <string_view>

namespace rouleau::storage::hdf5 {

namespace {

std::mutex& library_mutex() {
  static std::mutex mutex;
  return mutex;
}

struct Report {
  std::string cause;         // the innermost entry of the error stack
  std::string system_cause;  // the one with an errno, if any
};

herr_t collect(unsigned, const H5E_error2_t* entry, void* target) {
  auto& report = *static_cast<Report*>(target);
  const std::string text = entry->desc == nullptr ? "" : entry->desc;
  if (report.cause.empty()) report.cause = text;
  if (report.system_cause.empty() && text.find("errno = ") != std::string::npos) report.system_cause = text;
  return 0;
}

ArchiveError::Kind kind_of(const std::string& system_cause) {
  constexpr std::string_view key = "errno = ";
  const auto at = system_cause.find(key);
  if (at == std::string::npos) return ArchiveError::Kind::format;
  const int code = std::atoi(system_cause.c_str() + at + key.size());
  const bool full = code == ENOSPC || code == EDQUOT || code == EFBIG;
  return full ? ArchiveError::Kind::disk_full : ArchiveError::Kind::io;
}

}  // namespace

Session::Session() : lock_(library_mutex()) {
  // Per thread in the library: it must not print to the standard error of the program.
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

ArchiveError last_error(const std::string& what) {
  Report report;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, collect, &report);
  const std::string& cause = report.system_cause.empty() ? report.cause : report.system_cause;
  return ArchiveError(kind_of(report.system_cause), what + ": " + cause);
}

}  // namespace rouleau::storage::hdf5

#include "storage/hdf5/session.h"

#include <cerrno>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace rouleau::storage::hdf5 {

namespace {

std::mutex& library_mutex() {
  static std::mutex mutex;
  return mutex;
}

struct Report {
  std::string cause;     // the innermost entry of the error stack
  int system_error = 0;  // the errno in it, if it has one
};

herr_t collect(unsigned, const H5E_error2_t* entry, void* target) {
  auto& report = *static_cast<Report*>(target);
  const std::string text = entry->desc == nullptr ? "" : entry->desc;
  if (report.cause.empty()) report.cause = text;
  constexpr std::string_view key = "errno = ";
  const auto at = text.find(key);
  if (report.system_error == 0 && at != std::string::npos) {
    report.system_error = std::atoi(text.c_str() + at + key.size());
  }
  return 0;
}

ArchiveError::Kind kind_of(int code) {
  if (code == 0) return ArchiveError::Kind::format;
  const bool full = code == ENOSPC || code == EDQUOT || code == EFBIG;
  return full ? ArchiveError::Kind::disk_full : ArchiveError::Kind::io;
}

}  // namespace

Session::Session() : lock_(library_mutex()) {
  // Every file is closed by whoever opened it. What the library would do at the end of the program besides is
  // to close once more what it could not on a full disk, and to crash at that.
  [[maybe_unused]] static const herr_t closes_nothing_at_exit = H5dont_atexit();
  // Per thread in the library: it must not print to the standard error of the program.
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

ArchiveError last_error(const std::string& what) {
  Report report;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, collect, &report);
  const int code = report.system_error;
  return ArchiveError(kind_of(code),
                      what + ": " + (code == 0 ? report.cause : std::generic_category().message(code)));
}

}  // namespace rouleau::storage::hdf5

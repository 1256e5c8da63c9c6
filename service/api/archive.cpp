#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "service/api/etag.h"
#include "service/api/file_body.h"
#include "service/api/query.h"
#include "service/api/service.h"
#include "service/http/byte_range.h"
#include "service/http/guarded_server.h"
#include "service/http/problem.h"
#include "storage/archive_writer.h"

namespace rouleau::service {

namespace {

/// The range asked for. With If-Range it counts only if the client's part is of this very file.
ByteRange wanted_range(const Call& call, const std::string& etag, std::uint64_t size) {
  if (call.request.method != "GET") return {};
  const std::string condition = call.request.get_header_value("If-Range");
  if (!condition.empty() && condition != etag) return {};
  return parse_byte_range(call.request.get_header_value("Range"), size);
}

void get_archive(Service& service, const Call& call, httplib::Response& response) {
  check_query(call, {});
  const storage::Job job = find_finished(service, call);
  const auto file = archive_of(service, job);
  if (!std::filesystem::exists(file)) throw Problem(problems::not_found, "the archive has been removed");
  const auto size = static_cast<std::uint64_t>(job.archive_size.value_or(0));
  const std::string etag = '"' + job.archive_sha256.value_or("") + '"';
  response.set_header("Accept-Ranges", "bytes");
  response.set_header("Cache-Control", "private, no-cache");
  if (answer_not_modified(call, etag, response)) return;

  const ByteRange range = wanted_range(call, etag, size);
  const std::string total = std::to_string(size);
  if (range.kind == ByteRange::Kind::unsatisfiable) {
    response.set_header("Content-Range", "bytes */" + total);
    throw Problem(problems::range_not_satisfiable, "the archive has " + total + " bytes");
  }
  response.set_header("Content-Disposition", "attachment; filename=\"" + job.id + ".h5\"");
  const std::string type = "application/x-hdf5";
  const auto reading = service.archive_use.begin(job.archive_id.value());
  if (range.kind == ByteRange::Kind::part) {
    response.status = 206;
    response.set_header("Content-Range", "bytes " + std::to_string(range.first) + '-' +
                                             std::to_string(range.last) + '/' + total);
    answer_file(file, range.first, range.length(), type, response, reading);
  } else {
    response.status = 200;
    answer_file(file, 0, size, type, response, reading);
  }
}

void get_sidecar(Service& service, const Call& call, httplib::Response& response) {
  check_query(call, {});
  const storage::Job job = find_finished(service, call);
  std::ifstream file(storage::sidecar_path(archive_of(service, job)), std::ios::binary);
  if (!file) throw Problem(problems::not_found, "this archive has no .xdmf");
  response.set_header("Content-Disposition", "attachment; filename=\"" + job.id + ".xdmf\"");
  std::string text(std::istreambuf_iterator<char>(file), {});
  // Jobs that share an archive call it by their own names.
  const std::string stored = job.archive_id.value_or("") + ".h5";
  for (auto at = text.find(stored); at != std::string::npos; at = text.find(stored, at)) {
    text.replace(at, stored.size(), job.id + ".h5");
    at += stored.size();
  }
  response.set_content(text, "application/xml");
}

}  // namespace

void add_archive(Router& router, Service& service) {
  router.add("GET", "/v1/jobs/{id}/archive.h5", [&service](const Call& call, httplib::Response& response) {
    get_archive(service, call, response);
  });
  router.add("GET", "/v1/jobs/{id}/archive.xdmf", [&service](const Call& call, httplib::Response& response) {
    get_sidecar(service, call, response);
  });
}

}  // namespace rouleau::service

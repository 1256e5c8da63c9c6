#include <fstream>
#include <stdexcept>
#include <system_error>

#include <httplib.h>

#include "service/client/api_client.h"
#include "service/client/retry.h"
#include "storage/durable_file.h"
#include "storage/sha256.h"

namespace rouleau::service {

namespace {

namespace fs = std::filesystem;

std::uint64_t size_of(const fs::path& file) {
  std::error_code none;
  const auto size = fs::file_size(file, none);
  return none ? 0 : size;
}

bool is_whole(const fs::path& file, const Download& wanted) {
  return size_of(file) == wanted.size && fs::exists(file) &&
         storage::sha256_hex_of_file(file) == wanted.sha256;
}

}  // namespace

/// What the server has at a path.
Download ApiClient::remote_file(const std::string& path) {
  const auto result = send([&](httplib::Client& client) { return client.Head(path); });
  // The answer to HEAD has no body that could say why not; the same GET has one.
  if (result && result->status >= 400) get_text(path);
  check(result, "");
  const std::string etag = result->get_header_value("ETag");
  return {etag.size() >= 2 ? etag.substr(1, etag.size() - 2) : etag,
          std::strtoull(result->get_header_value("Content-Length").c_str(), nullptr, 10)};
}

/// Appends to the part what it lacks; starts it anew if the server has another file by now.
/// @return whether anything came
bool ApiClient::receive_rest(const std::string& path, const fs::path& part, const Download& wanted) {
  const std::uint64_t before = size_of(part);
  httplib::Headers headers;
  if (before > 0) {
    headers.emplace("Range", "bytes=" + std::to_string(before) + '-');
    headers.emplace("If-Range", '"' + wanted.sha256 + '"');
  }
  std::ofstream stream;
  std::string problem;
  bool came = false;
  int status = 0;
  const auto result = client_->Get(
      path, headers,
      [&](const httplib::Response& response) {
        status = response.status;
        if (status == 200 || status == 206) {
          stream.open(part, std::ios::binary | (status == 206 ? std::ios::app : std::ios::trunc));
          return stream.is_open();
        }
        return true;
      },
      [&](const char* data, std::size_t size) {
        if (!stream.is_open()) {
          problem.append(data, size);
          return true;
        }
        came = true;
        return static_cast<bool>(stream.write(data, static_cast<std::streamsize>(size)));
      });
  if (status == 200 || status == 206) {
    stream.close();
    if (!stream) throw std::runtime_error("cannot write " + part.string());
  }
  const bool busy = status == 429 || (status >= 502 && status <= 504);
  if (status >= 400 && !busy) check(result, problem);
  return came;
}

Download ApiClient::download(const std::string& path, const fs::path& file) {
  const fs::path part = file.string() + ".part";
  bool from_before = fs::exists(part);
  Retry retry(patience_);
  for (;;) {
    Download wanted = remote_file(path);
    if (is_whole(file, wanted)) {
      wanted.was_there = true;
      return wanted;
    }
    if (size_of(part) > wanted.size) fs::remove(part);
    if (size_of(part) < wanted.size && receive_rest(path, part, wanted)) retry = Retry(patience_);
    if (size_of(part) < wanted.size) {
      if (!retry.wait()) throw std::runtime_error("the download of " + file.string() + " broke off");
      continue;
    }
    if (is_whole(part, wanted)) {
      storage::publish(part, file);
      return wanted;
    }
    fs::remove(part);
    // What an earlier process left may have been of another file; what came now must be right.
    if (!from_before) {
      throw std::runtime_error(file.string() + " differs from the server's archive; fetch it again");
    }
    from_before = false;
  }
}

}  // namespace rouleau::service

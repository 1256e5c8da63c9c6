#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

namespace httplib {
class Client;
class Result;
}  // namespace httplib

namespace rouleau::service {

struct Download {
  std::string sha256;
  std::uint64_t size = 0;  ///< bytes
  bool was_there = false;  ///< the file was whole already
};

/// Speaks to a running service. One that is busy (429, 503) is asked again after its `Retry-After`, and one
/// that answered before and does not now with growing gaps, both for as long as the patience lasts.
/// Each call may throw ServerError (it answered with a problem) or std::runtime_error (nobody answered).
class ApiClient {
 public:
  /// @param url    such as http://127.0.0.1:8080
  /// @param token  "" where none is needed
  ApiClient(std::string url, const std::string& token,
            std::chrono::seconds patience = std::chrono::seconds(60));
  ~ApiClient();

  const std::string& url() const { return url_; }

  nlohmann::json get(const std::string& path);
  std::string get_text(const std::string& path, const std::string& accept = "*/*");
  /// For what changes nothing when it is asked for twice.
  nlohmann::json post(const std::string& path, const nlohmann::json& body = nullptr);
  /// For what must not be done twice: sent again, it is known by its key.
  nlohmann::json post_once(const std::string& path, const nlohmann::json& body, const std::string& key);
  void remove(const std::string& path);

  /// Downloads an archive, written aside and renamed once its SHA-256 is found to be that of the server. A
  /// download that broke off, now or in an earlier process, goes on where it stopped.
  Download download(const std::string& path, const std::filesystem::path& file);

 private:
  httplib::Result send(const std::function<httplib::Result(httplib::Client&)>& request);
  void check(const httplib::Result& result, const std::string& body) const;
  Download remote_file(const std::string& path);
  bool receive_rest(const std::string& path, const std::filesystem::path& part, const Download& wanted);

  std::string url_;
  std::chrono::seconds patience_;
  bool reached_ = false;  ///< somebody has answered
  std::unique_ptr<httplib::Client> client_;
};

/// A key for one submission.
std::string new_idempotency_key();

}  // namespace rouleau::service

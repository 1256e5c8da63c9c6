#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

namespace httplib {
class Client;
class Result;
}  // namespace httplib

namespace rouleau::service {

/// Speaks to a running service.
/// Each call may throw ServerError (it answered with a problem) or std::runtime_error (nobody answered).
class ApiClient {
 public:
  /// @param url    such as http://127.0.0.1:8080
  /// @param token  "" where none is needed
  ApiClient(std::string url, const std::string& token);
  ~ApiClient();

  const std::string& url() const { return url_; }

  nlohmann::json get(const std::string& path);
  nlohmann::json post(const std::string& path, const nlohmann::json& body);
  std::string get_text(const std::string& path);

  /// Downloads into a file, written aside and renamed once it is whole.
  /// @return the ETag without its quotes
  std::string download(const std::string& path, const std::filesystem::path& file);

 private:
  void check(const httplib::Result& result, const std::string& body) const;

  std::string url_;
  std::unique_ptr<httplib::Client> client_;
};

}  // namespace rouleau::service

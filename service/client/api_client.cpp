#include "service/client/api_client.h"

#include <chrono>
#include <fstream>
#include <stdexcept>

#include <httplib.h>

#include "service/client/server_error.h"
#include "service/http/problem.h"

namespace rouleau::service {

namespace {

// Longer than the server holds a request that waits for a change.
constexpr std::chrono::seconds read_timeout{90};

std::string without_trailing_slash(std::string url) {
  while (!url.empty() && url.back() == '/') url.pop_back();
  return url;
}

}  // namespace

ApiClient::ApiClient(std::string url, const std::string& token)
    : url_(without_trailing_slash(std::move(url))), client_(std::make_unique<httplib::Client>(url_)) {
  if (!client_->is_valid()) throw std::runtime_error(url_ + " is not the URL of a server");
  client_->set_read_timeout(read_timeout);
  client_->set_connection_timeout(std::chrono::seconds(5));
  client_->set_tcp_nodelay(true);
  if (!token.empty()) client_->set_bearer_token_auth(token);
}

ApiClient::~ApiClient() = default;

void ApiClient::check(const httplib::Result& result, const std::string& body) const {
  if (!result)
    throw std::runtime_error("no server answers at " + url_ + " (" + httplib::to_string(result.error()) +
                             ")");
  if (result->status < 400) return;
  const auto problem = nlohmann::json::parse(body, nullptr, false);
  if (!problem.is_object()) {
    throw ServerError(result->status, url_ + " answered with status " + std::to_string(result->status), {});
  }
  std::vector<Fault> faults;
  for (const auto& fault : problem.value("errors", nlohmann::json::array())) {
    faults.push_back({fault.value("pointer", ""), fault.value("message", "")});
  }
  throw ServerError(result->status, problem.value("title", "") + ": " + problem.value("detail", ""),
                    std::move(faults));
}

nlohmann::json ApiClient::get(const std::string& path) {
  return nlohmann::json::parse(get_text(path));
}

std::string ApiClient::get_text(const std::string& path) {
  const auto result = client_->Get(path);
  check(result, result ? result->body : "");
  return result->body;
}

nlohmann::json ApiClient::post(const std::string& path, const nlohmann::json& body) {
  const auto result =
      body.is_null() ? client_->Post(path) : client_->Post(path, dump(body), "application/json");
  check(result, result ? result->body : "");
  return nlohmann::json::parse(result->body);
}

std::string ApiClient::download(const std::string& path, const std::filesystem::path& file) {
  const std::filesystem::path part = file.string() + ".part";
  std::ofstream stream(part, std::ios::binary | std::ios::trunc);
  if (!stream) throw std::runtime_error("cannot write " + part.string());
  bool good = false;
  std::string problem;
  const auto result = client_->Get(
      path,
      [&](const httplib::Response& response) {
        good = response.status == 200;
        return true;
      },
      [&](const char* data, std::size_t size) {
        if (!good) {
          problem.append(data, size);
          return true;
        }
        return static_cast<bool>(stream.write(data, static_cast<std::streamsize>(size)));
      });
  stream.close();
  if (!result || !good || !stream) std::filesystem::remove(part);
  if (good && !stream) throw std::runtime_error("cannot write " + part.string());
  check(result, problem);
  std::filesystem::rename(part, file);
  const std::string etag = result->get_header_value("ETag");
  return etag.size() >= 2 ? etag.substr(1, etag.size() - 2) : etag;
}

}  // namespace rouleau::service

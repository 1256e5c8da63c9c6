#include "service/client/api_client.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include <httplib.h>

#include "service/client/retry.h"
#include "service/client/server_error.h"
#include "service/http/problem.h"
#include "storage/job_store.h"
#include "storage/uuid.h"

namespace rouleau::service {

namespace {

// Longer than the server holds a request that waits for a change.
constexpr std::chrono::seconds read_timeout{90};

std::string without_trailing_slash(std::string url) {
  while (!url.empty() && url.back() == '/') url.pop_back();
  return url;
}

/// Whether to ask again: the server says so, or the proxy before it that it does not answer.
bool is_busy(const httplib::Response& response) {
  const bool is_being_worked_on = response.status == 409 && response.has_header("Retry-After");
  return is_being_worked_on || response.status == 429 || (response.status >= 502 && response.status <= 504);
}

std::chrono::milliseconds asked_for(const httplib::Response& response) {
  const int seconds = std::atoi(response.get_header_value("Retry-After").c_str());
  return std::chrono::seconds(std::clamp(seconds, 0, 3600));
}

}  // namespace

std::string new_idempotency_key() {
  return storage::UuidSource().next(storage::system_clock_ms());
}

ApiClient::ApiClient(std::string url, const std::string& token, std::chrono::seconds patience)
    : url_(without_trailing_slash(std::move(url))),
      patience_(patience),
      client_(std::make_unique<httplib::Client>(url_)) {
  if (!client_->is_valid()) throw std::runtime_error(url_ + " is not the URL of a server");
  client_->set_read_timeout(read_timeout);
  client_->set_connection_timeout(std::chrono::seconds(5));
  client_->set_tcp_nodelay(true);
  if (!token.empty()) client_->set_bearer_token_auth(token);
}

ApiClient::~ApiClient() = default;

httplib::Result ApiClient::send(const std::function<httplib::Result(httplib::Client&)>& request) {
  Retry retry(patience_);
  for (;;) {
    httplib::Result result = request(*client_);
    if (result || result.error() != httplib::Error::Connection) reached_ = true;
    const bool again = result ? is_busy(*result) : reached_;
    if (!again || !retry.wait(result ? asked_for(*result) : std::chrono::milliseconds(0))) return result;
  }
}

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
  return nlohmann::json::parse(get_text(path, "application/json"));
}

std::string ApiClient::get_text(const std::string& path, const std::string& accept) {
  const auto result = send([&](httplib::Client& client) { return client.Get(path, {{"Accept", accept}}); });
  check(result, result ? result->body : "");
  return result->body;
}

nlohmann::json ApiClient::post(const std::string& path, const nlohmann::json& body) {
  const std::string text = body.is_null() ? "" : dump(body);
  const auto result = send([&](httplib::Client& client) {
    return body.is_null() ? client.Post(path) : client.Post(path, text, "application/json");
  });
  check(result, result ? result->body : "");
  return nlohmann::json::parse(result->body);
}

nlohmann::json ApiClient::post_once(const std::string& path, const nlohmann::json& body,
                                    const std::string& key) {
  const std::string text = dump(body);
  const auto result = send([&](httplib::Client& client) {
    return client.Post(path, {{"Idempotency-Key", key}}, text, "application/json");
  });
  check(result, result ? result->body : "");
  return nlohmann::json::parse(result->body);
}

void ApiClient::remove(const std::string& path) {
  const auto result = send([&](httplib::Client& client) { return client.Delete(path); });
  check(result, result ? result->body : "");
}

}  // namespace rouleau::service

#include "service/http/guarded_server.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <exception>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <stdexcept>
#include <sys/socket.h>
#include <utility>

#include <nlohmann/json.hpp>

#include "service/http/request_id.h"
#include "service/log.h"

namespace rouleau::service {

namespace {

// The request carries its id to the handlers in a header of this name; one that a client sent is dropped.
constexpr const char* request_id_header = "Rouleau-Request-Id";
constexpr int backlog = 256;

std::string id_of(const httplib::Request& request) {
  const std::string id = request.get_header_value(request_id_header);
  return id.empty() ? new_request_id() : id;
}

/// What cpp-httplib never gets to see is answered by hand.
void refuse(Connection& connection, const Problem& problem) {
  const std::string id = new_request_id();
  const std::string body = dump(to_json(problem, id));
  std::string text =
      "HTTP/1.1 " + std::to_string(problem.kind().status) + " " + std::string(problem.kind().title) +
      "\r\nContent-Type: application/problem+json\r\nX-Content-Type-Options: nosniff\r\n" +
      "X-Request-Id: " + id + "\r\nConnection: close\r\nContent-Length: " + std::to_string(body.size()) +
      "\r\n\r\n" + body;
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t count = connection.write(text.data() + sent, text.size() - sent);
    if (count < 0) return;
    sent += static_cast<std::size_t>(count);
  }
  log::info("refused",
            {{"request", id}, {"problem", std::string(problem.kind().name)}, {"detail", problem.detail()}});
}

bool is_json(const std::string& content_type) {
  const std::string_view type = std::string_view(content_type).substr(0, content_type.find(';'));
  return equal_ignoring_case(type.substr(0, type.find_last_not_of(" \t") + 1), "application/json");
}

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

void answer_json(const nlohmann::json& value, httplib::Response& response, int status) {
  response.status = status;
  response.set_content(dump(value), "application/json");
}

void answer(const Problem& problem, const std::string& request_id, httplib::Response& response) {
  response.status = problem.kind().status;
  response.set_content(dump(to_json(problem, request_id)), "application/problem+json");
  if (problem.kind().status == 503) response.set_header("Retry-After", "5");
  if (problem.kind().status == 401) response.set_header("WWW-Authenticate", "Bearer");
}

GuardedServer::GuardedServer(Router router, ServerSettings settings)
    : router_(std::move(router)), settings_(std::move(settings)) {
  new_task_queue = [threads = settings_.threads] { return new httplib::ThreadPool(threads); };
  set_keep_alive_timeout(std::chrono::ceil<std::chrono::seconds>(settings_.timeouts.idle).count());
  set_keep_alive_max_count(10000);
  set_payload_max_length(settings_.limits.body_bytes);
  set_socket_options([](socket_t socket) {
    // Not SO_REUSEPORT, cpp-httplib's own choice: with it a second server shares the port silently.
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  });
  set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
    return admit(request, response) ? HandlerResponse::Unhandled : HandlerResponse::Handled;
  });
  set_expect_100_continue_handler([this](const httplib::Request& request, httplib::Response& response) {
    return admit(request, response) ? 100 : response.status;
  });
  const auto any = [this](const httplib::Request& request, httplib::Response& response) {
    dispatch(request, response);
  };
  const std::string every_path = "[\\s\\S]*";
  Get(every_path, any);
  Post(every_path, any);
  Delete(every_path, any);
  set_error_handler([](const httplib::Request& request, httplib::Response& response) {
    if (!response.body.empty()) return;
    const int status = response.status;
    answer(Problem(problem_kind_of_status(status), "the request could not be read"), id_of(request),
           response);
    response.status = status;
  });
  set_exception_handler(
      [](const httplib::Request& request, httplib::Response& response, const std::exception_ptr&) {
        answer(Problem(problems::internal, "see the server's log"), id_of(request), response);
      });
  set_post_routing_handler([](const httplib::Request& request, httplib::Response& response) {
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("X-Request-Id", id_of(request));
    const std::string length = request.get_header_value("Content-Length");
    if (!length.empty() && length != "0" && request.body.empty()) {
      // Answered without reading the body, so this connection cannot go on.
      response.headers.erase("Keep-Alive");
      response.set_header("Connection", "close");
    }
    if (!response.has_header("Cache-Control")) response.set_header("Cache-Control", "no-store");
  });
  set_logger([](const httplib::Request& request, const httplib::Response& response) {
    log::debug("answered", {{"request", id_of(request)},
                            {"from", request.remote_addr},
                            {"method", request.method},
                            {"target", request.target},
                            {"status", std::to_string(response.status)}});
  });
}

int GuardedServer::listen_on(const std::string& host, int port) {
  errno = 0;
  const int taken = port == 0 ? bind_to_any_port(host) : (bind_to_port(host, port) ? port : -1);
  if (taken < 0) {
    const std::string reason = errno == 0 ? "no such address" : std::strerror(errno);
    throw std::runtime_error("cannot listen on " + host + ":" + std::to_string(port) + ": " + reason);
  }
  // cpp-httplib's own backlog of 5 makes a burst of clients wait for retransmissions.
  ::listen(svr_sock_, backlog);
  return taken;
}

void GuardedServer::stop() {
  const socket_t socket = svr_sock_.exchange(INVALID_SOCKET);
  if (socket == INVALID_SOCKET) return;
  ::shutdown(socket, SHUT_RDWR);
  ::close(socket);
}

bool GuardedServer::process_and_close_socket(socket_t socket) {
  const int yes = 1;
  ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof(yes));
  Connection connection(socket, settings_.limits, settings_.timeouts);
  const auto stopping = [this] { return svr_sock_ == INVALID_SOCKET; };
  while (connection.wait_for_request(stopping)) {
    if (!answer_one(connection)) break;
  }
  connection.close_gently();
  return true;
}

bool GuardedServer::answer_one(Connection& connection) {
  try {
    const RequestHead head = connection.next_request();
    settings_.access.check_host(head.header("Host"));
    const auto prepare = [&](httplib::Request& request) {
      request.headers.erase("Range");
      request.headers.erase(request_id_header);
      request.set_header("Range", std::string(head.header("Range")));
      request.set_header(request_id_header, new_request_id());
    };
    bool closed_by_client = false;
    const bool sent = process_request(connection, false, closed_by_client, prepare);
    return sent && !closed_by_client && connection.body_is_read();
  } catch (const Problem& problem) {
    refuse(connection, problem);
    return false;
  }
}

Router::Match GuardedServer::route(const httplib::Request& request) const {
  return router_.find(request.method, request.path);
}

bool GuardedServer::admit(const httplib::Request& request, httplib::Response& response) const {
  try {
    if (request.path.starts_with("/v1/"))
      settings_.access.check_token(request.get_header_value("Authorization"));
    const auto match = route(request);
    if (match.allowed.empty()) throw Problem(problems::not_found, "nothing is at this address");
    if (match.route == nullptr) {
      response.set_header("Allow", join(match.allowed));
      throw Problem(problems::method_not_allowed, "this address takes " + join(match.allowed));
    }
    if (request.method != "GET" && request.method != "HEAD") {
      Access::check_origin(request.get_header_value("Origin"), request.get_header_value("Host"));
    }
    const bool has_body =
        request.get_header_value("Content-Length") != "0" && request.has_header("Content-Length");
    if ((has_body || match.route->body == Body::json) && !is_json(request.get_header_value("Content-Type"))) {
      throw Problem(problems::unsupported_media_type, "send the body as application/json");
    }
    return true;
  } catch (const Problem& problem) {
    answer(problem, id_of(request), response);
    return false;
  }
}

void GuardedServer::dispatch(const httplib::Request& request, httplib::Response& response) const {
  const std::string id = id_of(request);
  try {
    auto match = route(request);
    if (match.route == nullptr) throw Problem(problems::not_found, "nothing is at this address");
    match.route->handler(Call{request, std::move(match.parts), id}, response);
  } catch (const Problem& problem) {
    answer(problem, id, response);
  } catch (const std::exception& error) {
    log::error("request failed", {{"request", id}, {"target", request.target}, {"error", error.what()}});
    answer(Problem(problems::internal, "see the server's log for this request id"), id, response);
  }
}

}  // namespace rouleau::service

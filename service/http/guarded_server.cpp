#include "service/http/guarded_server.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <stdexcept>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

#include <nlohmann/json.hpp>

#include "service/http/request_id.h"
#include "service/log.h"

namespace rouleau::service {

namespace {

constexpr int backlog = 1024;

// cpp-httplib hands its handlers a request that it has read anew. What was decided about it is with the
// connection that this thread is serving.
thread_local Connection* served = nullptr;

Exchange& current() {
  return *served->exchange();
}

bool expects_continue(const RequestHead& head) {
  return equal_ignoring_case(head.header("Expect"), "100-continue");
}

}  // namespace

void answer_json(const nlohmann::json& value, httplib::Response& response, int status) {
  answer_json_text(dump(value), response, status);
}

void answer_json_text(std::string text, httplib::Response& response, int status) {
  response.status = status;
  response.body = std::move(text);
  response.set_header("Content-Type", "application/json");
}

void answer(const Problem& problem, const std::string& request_id, httplib::Response& response) {
  response.status = problem.kind().status;
  response.set_content(dump(to_json(problem, request_id)), "application/problem+json");
  if (problem.kind().status == 503) response.set_header("Retry-After", "5");
  if (&problem.kind() == &problems::idempotency_in_progress) response.set_header("Retry-After", "1");
  if (problem.kind().status == 401) response.set_header("WWW-Authenticate", "Bearer");
}

GuardedServer::GuardedServer(Router router, ServerSettings settings)
    : router_(std::move(router)),
      settings_(std::move(settings)),
      gate_(router_, settings_.access, settings_.rate),
      room_(*this, settings_.room, settings_.limits, settings_.timeouts) {
  set_keep_alive_timeout(std::chrono::floor<std::chrono::seconds>(settings_.timeouts.idle).count());
  set_keep_alive_max_count(10000);
  set_payload_max_length(settings_.limits.body_bytes);
  set_socket_options([](socket_t socket) {
    // Not SO_REUSEPORT, cpp-httplib's own choice: with it a second server shares the port silently.
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  });
  set_pre_routing_handler([](const httplib::Request&, httplib::Response& response) {
    const Admission& admission = current().admission;
    if (!admission.refusal) return HandlerResponse::Unhandled;
    service::answer(*admission.refusal, current().id, response);
    return HandlerResponse::Handled;
  });
  const auto any = [](const httplib::Request& request, httplib::Response& response) {
    const Exchange& exchange = current();
    const Admission& admission = exchange.admission;
    try {
      admission.match.route->handler(Call{request, admission.match.parts, exchange.id, admission.caller},
                                     response);
    } catch (const Problem& problem) {
      service::answer(problem, exchange.id, response);
    } catch (const std::exception& error) {
      log::error("request failed",
                 {{"request", exchange.id}, {"target", request.target}, {"error", error.what()}});
      service::answer(Problem(problems::internal, "see the server's log for this request id"), exchange.id,
                      response);
    }
  };
  const std::string every_path = "[\\s\\S]*";
  Get(every_path, any);
  Post(every_path, any);
  Delete(every_path, any);
  set_error_handler([](const httplib::Request&, httplib::Response& response) {
    if (!response.body.empty()) return;
    const int status = response.status;
    service::answer(Problem(problem_kind_of_status(status), "the request could not be read"), current().id,
                    response);
    response.status = status;
  });
  set_exception_handler([](const httplib::Request&, httplib::Response& response, const std::exception_ptr&) {
    service::answer(Problem(problems::internal, "see the server's log"), current().id, response);
  });
  set_post_routing_handler([](const httplib::Request& request, httplib::Response& response) {
    for (const auto& [name, value] : current().admission.headers) response.set_header(name, value);
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("X-Request-Id", current().id);
    if (!response.has_header("Cache-Control")) response.set_header("Cache-Control", "no-store");
    if (!served->request_is_whole()) {
      // Answered without its body, so this connection cannot go on.
      response.headers.erase("Keep-Alive");
      response.set_header("Connection", "close");
    }
    if (!response.content_provider_ || request.method == "HEAD") return;
    if (response.content_length_ == 0) {
      served->begin_stream();
    } else {
      // Not written by this thread for as long as it takes, but as the peer takes it.
      served->attach(std::exchange(response.content_provider_, nullptr),
                     std::exchange(response.content_length_, 0));
    }
  });
  set_logger([this](const httplib::Request& request, const httplib::Response& response) {
    log::debug("answered", {{"request", current().id},
                            {"from", request.remote_addr},
                            {"caller", current().admission.caller},
                            {"method", request.method},
                            {"target", request.target},
                            {"status", std::to_string(response.status)}});
    const Route* const route = current().admission.match.route;
    const std::chrono::duration<double> taken = Connection::Clock::now() - current().begun;
    settings_.on_answer({route == nullptr ? "" : route->method, route == nullptr ? "" : route->pattern,
                         response.status, taken.count()});
  });
}

GuardedServer::~GuardedServer() {
  stop();
  if (listener_ != INVALID_SOCKET) ::close(listener_);
}

int GuardedServer::listen_on(const std::string& host, int port) {
  errno = 0;
  const int taken = port == 0 ? bind_to_any_port(host) : (bind_to_port(host, port) ? port : -1);
  if (taken < 0) {
    const std::string reason = errno == 0 ? "no such address" : std::strerror(errno);
    throw std::runtime_error("cannot listen on " + host + ":" + std::to_string(port) + ": " + reason);
  }
  listener_ = svr_sock_;
  ::fcntl(listener_, F_SETFL, O_NONBLOCK);
  // cpp-httplib's own backlog of 5 makes a burst of clients wait for retransmissions.
  ::listen(listener_, backlog);
  return taken;
}

void GuardedServer::serve() {
  pool_ = std::make_unique<httplib::ThreadPool>(settings_.threads);
  room_.run(listener_);
  pool_->shutdown();
}

void GuardedServer::stop() {
  room_.stop();
  // Streams end when they see this.
  if (svr_sock_.exchange(INVALID_SOCKET) != INVALID_SOCKET) ::shutdown(listener_, SHUT_RDWR);
}

void GuardedServer::admit(Connection& connection) {
  Exchange& exchange = *connection.exchange();
  exchange.admission = gate_.admit(exchange.head, connection.address());
  if (!exchange.admission.refusal && expects_continue(exchange.head) && !connection.request_is_whole()) {
    constexpr std::string_view text = "HTTP/1.1 100 Continue\r\n\r\n";
    connection.write(text.data(), text.size());
    connection.flush();
  }
}

std::string GuardedServer::refusal(const Connection& connection, const Problem& problem) {
  const std::string id = new_request_id();
  log::info("refused", {{"request", id},
                        {"from", connection.address()},
                        {"problem", std::string(problem.kind().name)},
                        {"detail", problem.detail()}});
  // What cpp-httplib never gets to see is answered by hand.
  const std::string body = dump(to_json(problem, id));
  std::string text = "HTTP/1.1 " + std::to_string(problem.kind().status) + " " +
                     std::string(problem.kind().title) +
                     "\r\nContent-Type: application/problem+json\r\nX-Content-Type-Options: nosniff\r\n" +
                     "X-Request-Id: " + id + "\r\nConnection: close\r\n";
  if (problem.kind().status == 503) text += "Retry-After: 5\r\n";
  return text + "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
}

void GuardedServer::serve(std::unique_ptr<Connection> connection) {
  // std::function, which the pool takes, must be copyable.
  pool_->enqueue([this, held = std::make_shared<std::unique_ptr<Connection>>(std::move(connection))] {
    Connection& one = **held;
    const bool answered = one.exchange() == nullptr || answer(one);
    const bool usable = answered && one.flush();
    room_.take_back(std::move(*held), usable);
  });
}

bool GuardedServer::answer(Connection& connection) {
  served = &connection;
  const auto mend = [](httplib::Request& request) {
    const RequestHead& head = current().head;
    request.params = query_of(head.target);
    request.headers.erase("Range");
    request.set_header("Range", std::string(head.header("Range")));
  };
  bool closed_by_client = false;
  const bool sent = process_request(connection, false, closed_by_client, mend);
  if (closed_by_client) connection.end_after_answer();
  connection.end_exchange();
  served = nullptr;
  return sent;
}

}  // namespace rouleau::service

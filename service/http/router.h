#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <httplib.h>

#include "service/http/token_file.h"

namespace rouleau::service {

/// A request on its way to the handler of its route.
struct Call {
  const httplib::Request& request;
  std::map<std::string, std::string> parts;  ///< what stood for each {name} of the route
  std::string request_id;
  std::string caller;  ///< name of the token; "" where none is needed

  const std::string& part(const std::string& name) const { return parts.at(name); }
};

/// Answers a call, or throws Problem.
using Handler = std::function<void(const Call&, httplib::Response&)>;

enum class Body { none, json };

struct Route {
  std::string method;
  std::string pattern;
  std::vector<std::string> segments;  ///< "{id}" matches any one segment, "{id}:cancel" one that ends so
  Body body = Body::none;
  Scope scope = Scope::read;
  Handler handler;
};

/// The table of routes. cpp-httplib answers 400 to a method that a path does not take; this knows better.
class Router {
 public:
  /// @param pattern such as "/v1/jobs/{id}:cancel"
  /// @param scope   that a token must have, under /v1; by default read for GET and submit for all else
  void add(const std::string& method, std::string_view pattern, Handler handler, Body body = Body::none,
           std::optional<Scope> scope = {});

  struct Match {
    const Route* route = nullptr;  ///< null: no route takes this path with this method
    std::map<std::string, std::string> parts;
    std::vector<std::string> allowed;  ///< methods that the path takes; empty: there is no such path
  };

  /// HEAD is answered by the route for GET.
  Match find(std::string_view method, std::string_view path) const;

 private:
  std::vector<Route> routes_;
};

}  // namespace rouleau::service

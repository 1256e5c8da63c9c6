#include <string>

#include "service/api/service.h"
#include "service/http/problem.h"

namespace rouleau::service {

namespace {

std::string page(const ProblemKind& kind) {
  const std::string title(kind.title);
  return "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>" + title + "</title>\n<h1>" +
         title + "</h1>\n<p>Problem <code>" + std::string(kind.name) + "</code>, HTTP status " +
         std::to_string(kind.status) + ".</p>\n<p>" + std::string(kind.meaning) + "</p>\n</html>\n";
}

}  // namespace

void add_problems(Router& router) {
  router.add("GET", "/problems/{name}", [](const Call& call, httplib::Response& response) {
    const ProblemKind* const kind = find_problem_kind(call.part("name"));
    if (kind == nullptr) throw Problem(problems::not_found, "there is no problem of this name");
    response.set_header("Content-Security-Policy", "default-src 'none'");
    response.set_content(page(*kind), "text/html; charset=utf-8");
  });
}

}  // namespace rouleau::service

#include "service/api/page.h"

#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "service/api/etag.h"

namespace rouleau::service {

namespace {

// The page's own files alone; styles set on elements by its script are let through.
constexpr const char* content_security_policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; style-src-attr 'unsafe-inline'; "
    "img-src 'self' data:; font-src 'self'; connect-src 'self'; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'";

std::string content_type(const std::filesystem::path& file) {
  static const std::map<std::string, std::string> types{{".html", "text/html; charset=utf-8"},
                                                        {".js", "text/javascript; charset=utf-8"},
                                                        {".css", "text/css; charset=utf-8"},
                                                        {".json", "application/json"},
                                                        {".map", "application/json"},
                                                        {".svg", "image/svg+xml"},
                                                        {".png", "image/png"},
                                                        {".ico", "image/x-icon"},
                                                        {".woff2", "font/woff2"}};
  const auto found = types.find(file.extension().string());
  return found == types.end() ? "application/octet-stream" : found->second;
}

struct PageFile {
  std::string text, type, etag;
};

PageFile read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(file), {});
  std::string etag = weak_etag(text);
  return {std::move(text), content_type(path), std::move(etag)};
}

}  // namespace

std::size_t add_page(Router& router, const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) return 0;
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const std::string name = entry.path().lexically_relative(folder).generic_string();
    const auto answer = [file = read(entry.path())](const Call& call, httplib::Response& response) {
      response.set_header("Content-Security-Policy", content_security_policy);
      response.set_header("Referrer-Policy", "no-referrer");
      response.set_header("Cache-Control", "no-cache");
      if (!answer_not_modified(call, file.etag, response)) response.set_content(file.text, file.type);
    };
    router.add("GET", "/" + name, answer);
    if (name == "index.html") router.add("GET", "/", answer);
    ++count;
  }
  return count;
}

}  // namespace rouleau::service

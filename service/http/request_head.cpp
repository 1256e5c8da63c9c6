#include "service/http/request_head.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "service/http/problem.h"

namespace rouleau::service {

namespace {

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool is_token(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
  });
}

bool has_control_characters(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && byte != '\t') || byte == 0x7f;
  });
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

Problem bad(std::string detail) {
  return {problems::bad_request, std::move(detail)};
}

void read_request_line(std::string_view line, const RequestLimits& limits, RequestHead& head) {
  const auto first = line.find(' ');
  const auto second = first == std::string_view::npos ? first : line.find(' ', first + 1);
  if (second == std::string_view::npos || line.find(' ', second + 1) != std::string_view::npos) {
    throw bad("the request line is not METHOD TARGET VERSION");
  }
  head.method = line.substr(0, first);
  head.target = line.substr(first + 1, second - first - 1);
  head.version = line.substr(second + 1);
  if (!is_token(head.method)) throw bad("the request line is not METHOD TARGET VERSION");
  if (!head.target.starts_with('/')) throw bad("the target of a request begins with a slash");
  if (head.version != "HTTP/1.1" && head.version != "HTTP/1.0") throw bad("only HTTP/1.1 is spoken here");
  if (head.target.size() > limits.target_bytes) {
    throw Problem(problems::uri_too_long,
                  "at most " + std::to_string(limits.target_bytes) + " bytes are read");
  }
}

void read_header_line(std::string_view line, RequestHead& head) {
  const auto colon = line.find(':');
  if (colon == std::string_view::npos || !is_token(line.substr(0, colon))) {
    throw bad("a header is not NAME: VALUE");
  }
  head.headers.emplace_back(line.substr(0, colon), trimmed(line.substr(colon + 1)));
}

std::size_t count_of(const RequestHead& head, std::string_view name) {
  return static_cast<std::size_t>(
      std::count_if(head.headers.begin(), head.headers.end(),
                    [&](const auto& header) { return equal_ignoring_case(header.first, name); }));
}

bool takes_a_body(const std::string& method) {
  return method == "POST" || method == "PUT" || method == "PATCH" || method == "DELETE";
}

void read_body_headers(const RequestLimits& limits, RequestHead& head) {
  if (count_of(head, "Transfer-Encoding") > 0) {
    throw Problem(problems::length_required, "send the body with a Content-Length, not chunked");
  }
  const std::string_view encoding = head.header("Content-Encoding");
  if (!encoding.empty() && !equal_ignoring_case(encoding, "identity")) {
    throw Problem(problems::unsupported_media_type, "compressed bodies are not taken");
  }
  const auto lengths = count_of(head, "Content-Length");
  if (lengths == 0) return;
  const std::string_view text = head.header("Content-Length");
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, head.content_length);
  if (error == std::errc::result_out_of_range && lengths == 1) {
    throw Problem(problems::payload_too_large,
                  "at most " + std::to_string(limits.body_bytes) + " bytes are read");
  }
  if (lengths > 1 || error != std::errc{} || stop != end)
    throw bad("Content-Length must be one number of bytes");
  if (head.content_length > limits.body_bytes) {
    throw Problem(problems::payload_too_large,
                  "at most " + std::to_string(limits.body_bytes) + " bytes are read");
  }
  if (head.content_length > 0 && !takes_a_body(head.method)) throw bad("this method takes no body");
}

void check_host(const RequestHead& head) {
  const auto hosts = count_of(head, "Host");
  if (hosts > 1 || (hosts == 0 && head.version == "HTTP/1.1")) throw bad("a request has exactly one Host");
  // cpp-httplib decodes %xx in header values, which would let a host be written in two ways.
  if (head.header("Host").find('%') != std::string_view::npos) throw bad("Host is no host name");
}

/// With what %xx stands for.
std::string decoded(std::string_view raw) {
  std::string text;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    unsigned char byte = 0;
    const auto digits = raw.substr(std::min(i + 1, raw.size()), 2);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
    if (raw[i] == '%' && digits.size() == 2 && error == std::errc{} && end == digits.data() + 2) {
      text += static_cast<char>(byte);
      i += 2;
    } else {
      text += raw[i];
    }
  }
  return text;
}

}  // namespace

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char left, char right) { return lower(left) == lower(right); });
}

std::string_view RequestHead::header(std::string_view name) const {
  for (const auto& [key, value] : headers) {
    if (equal_ignoring_case(key, name)) return value;
  }
  return {};
}

RequestHead read_request_head(std::string_view text, const RequestLimits& limits) {
  RequestHead head;
  bool first = true;
  while (!text.empty()) {
    const auto end = text.find("\r\n");
    if (end == std::string_view::npos) throw bad("a line does not end in CR LF");
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 2);
    if (has_control_characters(line)) throw bad("the head holds control characters");
    if (first) {
      read_request_line(line, limits, head);
      first = false;
    } else if (line.empty()) {
      if (!text.empty()) throw bad("the head goes on behind its blank line");
    } else {
      if (line.size() > limits.header_bytes) {
        throw Problem(problems::headers_too_large,
                      "at most " + std::to_string(limits.header_bytes) + " bytes of a header are read");
      }
      read_header_line(line, head);
      if (head.headers.size() > limits.headers) {
        throw Problem(problems::headers_too_large,
                      "at most " + std::to_string(limits.headers) + " headers are read");
      }
    }
  }
  if (first) throw bad("there is no request line");
  check_host(head);
  read_body_headers(limits, head);
  return head;
}

std::string path_of(std::string_view target) {
  return decoded(target.substr(0, target.find_first_of("?#")));
}

std::multimap<std::string, std::string> query_of(std::string_view target) {
  std::multimap<std::string, std::string> parameters;
  const auto mark = target.find('?');
  std::string_view rest = mark == std::string_view::npos ? std::string_view{} : target.substr(mark + 1);
  rest = rest.substr(0, rest.find('#'));
  while (!rest.empty()) {
    const std::string_view pair = rest.substr(0, rest.find('&'));
    rest.remove_prefix(std::min(pair.size() + 1, rest.size()));
    if (pair.empty()) continue;
    const auto equals = std::min(pair.find('='), pair.size());
    std::string value(pair.substr(std::min(equals + 1, pair.size())));
    std::replace(value.begin(), value.end(), '+', ' ');
    parameters.emplace(decoded(pair.substr(0, equals)), decoded(value));
  }
  return parameters;
}

std::string head_for_httplib(const RequestHead& head) {
  static constexpr std::array<std::string_view, 4> hidden{"Range", "Accept-Encoding", "Content-Length",
                                                          "Expect"};
  std::string text = head.method + ' ' + head.target + ' ' + head.version + "\r\n";
  for (const auto& header : head.headers) {
    if (std::any_of(hidden.begin(), hidden.end(),
                    [&](std::string_view name) { return equal_ignoring_case(name, header.first); })) {
      continue;
    }
    text.append(header.first).append(": ").append(header.second).append("\r\n");
  }
  if (takes_a_body(head.method)) text += "Content-Length: " + std::to_string(head.content_length) + "\r\n";
  return text + "\r\n";
}

}  // namespace rouleau::service

#pragma once

#include <cstdlib>
#include <string_view>

/// What comes from outside, as the service takes it. Each target lets by only the errors that a client is
/// told of; any other, and anything that must hold and does not, ends the process.
namespace rouleau::fuzz {

void byte_range(std::string_view input);
void case_body(std::string_view input);
void new_job(std::string_view input);
void query(std::string_view input);
void request_head(std::string_view input);
void sweep_body(std::string_view input);
void token_file(std::string_view input);

inline void must(bool holds) {
  if (!holds) std::abort();
}

}  // namespace rouleau::fuzz

#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "service/http/router.h"

namespace rouleau::service {

/// Refuses query parameters that the route does not know, and known ones given twice unless they may be.
/// @throws Problem 400 invalid-request naming all of them
void check_query(const Call& call, std::initializer_list<std::string_view> known,
                 std::initializer_list<std::string_view> repeatable = {});

/// "" and absent are the same.
std::optional<std::string> query(const Call& call, const std::string& name);

/// @throws Problem 400 unless it is a whole number within the bounds
std::optional<int> query_integer(const Call& call, const std::string& name, int least, int most);

/// @throws Problem 400 unless it is a finite number
std::optional<double> query_number(const Call& call, const std::string& name);

/// "a,b" -> {"a", "b"}.
std::vector<std::string> split_list(std::string_view text);

}  // namespace rouleau::service

#include "service/api/series_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "service/http/problem.h"

namespace rouleau::service {

namespace {

std::size_t row_count(const storage::SeriesTable& table) {
  return table.values.empty() ? 0 : table.values.front().size();
}

std::ptrdiff_t column_index(const storage::SeriesTable& table, const std::string& name) {
  const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& column) { return column.name == name; });
  return found == table.columns.end() ? -1 : found - table.columns.begin();
}

}  // namespace

nlohmann::json series_json(const storage::SeriesTable& table) {
  nlohmann::json json{{"columns", nlohmann::json::array()},
                      {"units", nlohmann::json::object()},
                      {"rows", nlohmann::json::array()}};
  for (const Column& column : table.columns) {
    json["columns"].push_back(column.name);
    json["units"][column.name] = column.unit;
  }
  for (std::size_t r = 0; r < row_count(table); ++r) {
    auto row = nlohmann::json::array();
    for (const auto& values : table.values) {
      row.push_back(std::isfinite(values[r]) ? nlohmann::json(values[r]) : nlohmann::json());
    }
    json["rows"].push_back(std::move(row));
  }
  return json;
}

std::string series_csv(const storage::SeriesTable& table) {
  std::string text;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    text += (c == 0 ? "" : ",") + table.columns[c].name;
  }
  text += '\n';
  for (std::size_t r = 0; r < row_count(table); ++r) {
    for (std::size_t c = 0; c < table.values.size(); ++c) {
      if (c > 0) text += ',';
      if (const double value = table.values[c][r]; std::isfinite(value)) {
        fmt::format_to(std::back_inserter(text), "{}", value);
      }
    }
    text += '\n';
  }
  return text;
}

storage::SeriesTable rows_after(const storage::SeriesTable& table, double time) {
  std::vector<std::size_t> rows;
  if (const auto c = column_index(table, "time"); c >= 0) {
    const auto& times = table.values[static_cast<std::size_t>(c)];
    for (std::size_t r = 0; r < times.size(); ++r) {
      if (times[r] > time) rows.push_back(r);
    }
  }
  return select_rows(table, rows);
}

storage::SeriesTable select_columns(const storage::SeriesTable& table,
                                    const std::vector<std::string>& names) {
  if (names.empty()) return table;
  storage::SeriesTable selected;
  std::vector<Fault> faults;
  for (const std::string& name : names) {
    const auto c = column_index(table, name);
    if (c < 0) {
      faults.push_back({"?columns", "no column named " + name});
      continue;
    }
    if (column_index(selected, name) >= 0) {
      throw Problem(problems::invalid_request, "a query parameter is not valid",
                    {{"?columns", name + " is named more than once"}});
    }
    selected.columns.push_back(table.columns[static_cast<std::size_t>(c)]);
    selected.values.push_back(table.values[static_cast<std::size_t>(c)]);
  }
  if (!faults.empty()) {
    throw Problem(problems::unknown_column, "the series has no such column", std::move(faults));
  }
  return selected;
}

storage::SeriesTable select_rows(const storage::SeriesTable& table, const std::vector<std::size_t>& rows) {
  storage::SeriesTable selected{table.columns, {}};
  for (const auto& values : table.values) {
    auto& column = selected.values.emplace_back();
    column.reserve(rows.size());
    for (const std::size_t row : rows) column.push_back(values[row]);
  }
  return selected;
}

}  // namespace rouleau::service

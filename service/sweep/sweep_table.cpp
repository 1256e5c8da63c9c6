#include "service/sweep/sweep_table.h"

#include <algorithm>

#include "service/http/problem.h"

namespace rouleau::service {

namespace {

using nlohmann::json;

struct CellColumn {
  const char* name;
  const char* key;  ///< in the summary
  const char* unit;
};

constexpr CellColumn cell_columns[] = {{"peak_velocity", "peak_velocity", "m/s"},
                                       {"peak_tau", "peak_tau", "1"},
                                       {"least_tau", "least_tau", "1"}};

json value_of(const json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? json() : *found;
}

std::size_t cells_of(const json& summary) {
  const json cells = value_of(summary, "cells");
  return cells.is_array() ? cells.size() : 0;
}

std::vector<json> row_of(const SweepRow& point, bool with_jobs, std::size_t cells) {
  std::vector<json> row{point.index};
  if (with_jobs) row.emplace_back(point.job);
  row.emplace_back(point.case_hash);
  row.insert(row.end(), point.values.begin(), point.values.end());
  row.emplace_back(point.state);
  row.push_back(value_of(point.summary, "wall_time"));
  row.push_back(value_of(point.summary, "peak_fluid_speed"));
  const json found = value_of(point.summary, "cells");
  for (std::size_t k = 0; k < cells; ++k) {
    const json cell = k < cells_of(point.summary) ? found[k] : json();
    for (const CellColumn& column : cell_columns) row.push_back(value_of(cell, column.key));
    row.push_back(value_of(value_of(cell, "departure"), "time"));
  }
  return row;
}

/// A text in quotes if it needs them; numbers with as many digits as tell them apart.
std::string csv_field(const json& value) {
  if (value.is_null()) return "";
  const std::string text = value.is_string() ? value.get<std::string>() : dump(value);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string csv_line(const std::vector<json>& fields) {
  std::string line;
  for (std::size_t c = 0; c < fields.size(); ++c) line += (c == 0 ? "" : ",") + csv_field(fields[c]);
  return line + '\n';
}

}  // namespace

SweepTable make_table(const std::vector<std::string>& pointers, const std::vector<SweepRow>& rows) {
  const bool with_jobs =
      std::any_of(rows.begin(), rows.end(), [](const auto& row) { return !row.job.empty(); });
  std::size_t cells = 0;
  for (const SweepRow& row : rows) cells = std::max(cells, cells_of(row.summary));

  SweepTable table;
  table.columns.push_back({"index", "1"});
  if (with_jobs) table.columns.push_back({"job", ""});
  table.columns.push_back({"case_hash", ""});
  for (const std::string& pointer : pointers) table.columns.push_back({pointer, ""});
  table.columns.insert(table.columns.end(), {{"state", ""}, {"wall_time", "s"}, {"peak_fluid_speed", "m/s"}});
  for (std::size_t k = 0; k < cells; ++k) {
    const std::string cell = "cell" + std::to_string(k) + '.';
    for (const CellColumn& column : cell_columns) table.columns.push_back({cell + column.name, column.unit});
    table.columns.push_back({cell + "residence_time", "s"});
  }
  for (const SweepRow& row : rows) table.rows.push_back(row_of(row, with_jobs, cells));
  return table;
}

json to_json(const SweepTable& table) {
  json body{{"columns", json::array()}, {"units", json::object()}, {"rows", table.rows}};
  for (const Column& column : table.columns) {
    body["columns"].push_back(column.name);
    if (!column.unit.empty()) body["units"][column.name] = column.unit;
  }
  return body;
}

SweepTable read_table(const json& told) {
  SweepTable table;
  for (const json& name : told.at("columns")) {
    table.columns.push_back({name.get<std::string>(), told.at("units").value(name.get<std::string>(), "")});
  }
  table.rows = told.at("rows").get<std::vector<std::vector<json>>>();
  return table;
}

std::string to_csv(const SweepTable& table) {
  std::vector<json> header;
  for (const Column& column : table.columns) header.emplace_back(column.name);
  std::string text = csv_line(header);
  for (const auto& row : table.rows) text += csv_line(row);
  return text;
}

}  // namespace rouleau::service

#include <string>

#include <nlohmann/json.hpp>

#include "service/api/downsample.h"
#include "service/api/job_data.h"
#include "service/api/query.h"
#include "service/api/series_table.h"
#include "service/http/guarded_server.h"

namespace rouleau::service {

namespace {

constexpr int greatest_max_points = 1'000'000;

void get_series(Service& service, const Call& call, httplib::Response& response) {
  check_query(call, {"columns", "after", "max_points"});
  const auto after = query_number(call, "after");
  const auto most = query_integer(call, "max_points", 2, greatest_max_points);

  storage::SeriesTable table = JobData(service, find_job(service, call)).series();
  if (after) table = rows_after(table, *after);
  table = select_columns(table, split_list(query(call, "columns").value_or("")));
  if (most) table = select_rows(table, downsample(table, static_cast<std::size_t>(*most)));

  response.set_header("Vary", "Accept");
  if (call.request.get_header_value("Accept").find("text/csv") != std::string::npos) {
    response.set_content(series_csv(table), "text/csv; charset=utf-8");
  } else {
    answer_json(series_json(table), response);
  }
}

}  // namespace

void add_series(Router& router, Service& service) {
  router.add("GET", "/v1/jobs/{id}/series", [&service](const Call& call, httplib::Response& response) {
    get_series(service, call, response);
  });
}

}  // namespace rouleau::service

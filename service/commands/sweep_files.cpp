#include "service/commands/sweep_files.h"

#include <fstream>
#include <stdexcept>
#include <utility>

namespace rouleau::service {

namespace {

void write_whole(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path aside = file.string() + ".part";
  std::ofstream stream(aside, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error("cannot write " + aside.string());
  std::filesystem::rename(aside, file);
}

}  // namespace

void write_sweep_files(const std::filesystem::path& folder, SweepFiles files) {
  files.about["table"] = files.table;
  write_whole(folder / "sweep.json",
              files.about.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
  write_whole(folder / "table.csv", files.csv);
  if (!files.picture.empty()) write_whole(folder / "sweep.svg", files.picture);
}

}  // namespace rouleau::service

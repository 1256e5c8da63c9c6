#include "storage/archive_reader.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "engine/case/case_error.h"
#include "engine/case/case_json.h"
#include "storage/archive/opened.h"
#include "storage/archive/timed_group.h"
#include "storage/hdf5/array_reader.h"
#include "storage/hdf5/session.h"
#include "storage/hdf5/text.h"

namespace rouleau::storage {

namespace {

using hdf5::checked;
using hdf5::read_record;

const std::string trajectory = "/particles/trajectory/";

bool exists(hid_t file, const std::string& path) {
  return checked(H5Lexists(file, path.c_str(), H5P_DEFAULT), path) > 0;
}

nlohmann::json parsed(const std::string& text, const std::string& name) {
  try {
    return parse_json(text);
  } catch (const CaseError&) {
    throw ArchiveError(ArchiveError::Kind::format, name + " is no JSON");
  }
}

nlohmann::json read_json(hid_t file, const std::string& path) {
  return parsed(hdf5::read_text(file, path), path);
}

std::vector<Column> read_columns(hid_t file) {
  const hdf5::Group series(checked(H5Gopen2(file, "/series", H5P_DEFAULT), "series"));
  std::vector<Column> columns;
  for (const std::string& name : hdf5::read_text_attribute(series.get(), "columns")) {
    const hdf5::Dataset column(checked(H5Dopen2(series.get(), name.c_str(), H5P_DEFAULT), name));
    const auto unit = hdf5::read_text_attribute(column.get(), "unit");
    columns.push_back({name, unit.empty() ? "" : unit.front()});
  }
  return columns;
}

int count_frames(hid_t file) {
  return static_cast<int>(hdf5::shape_of(file, time_path, 1)[0]);
}

hsize_t checked_frame(hid_t file, int k) {
  const int count = count_frames(file);
  if (k < 0 || k >= count) {
    throw ArchiveError(ArchiveError::Kind::range,
                       "there is no frame " + std::to_string(k) + " among " + std::to_string(count));
  }
  return static_cast<hsize_t>(k);
}

/// Of the fields that frames carry on the membranes.
std::vector<std::string> read_field_names(hid_t file) {
  if (!exists(file, "/outlines")) return {};
  const hdf5::Group outlines(checked(H5Gopen2(file, "/outlines", H5P_DEFAULT), "outlines"));
  if (checked(H5Aexists(outlines.get(), "fields"), "outlines") == 0) return {};
  return hdf5::read_text_attribute(outlines.get(), "fields");
}

std::vector<Outline> read_outlines(hid_t file, hsize_t k) {
  std::vector<Outline> outlines;
  const auto fields = read_field_names(file);
  for (int c = 0; exists(file, "/outlines") && exists(file, "/outlines/cell" + std::to_string(c)); ++c) {
    const std::string at = "/outlines/cell" + std::to_string(c) + "/";
    const auto nodes = static_cast<std::size_t>(hdf5::shape_of(file, at + "value", 3)[1]);
    const auto xy = read_record<float>(file, at + "value", k, 2 * nodes);
    Outline& outline = outlines.emplace_back();
    const bool left = std::isnan(xy[0]);
    if (left) continue;
    for (std::size_t i = 0; i < nodes; ++i) {
      outline.x.push_back(xy[2 * i]);
      outline.y.push_back(xy[2 * i + 1]);
    }
    for (const std::string& field : fields) {
      outline.fields[field] = read_record<float>(file, at + field, k, nodes);
    }
  }
  return outlines;
}

Frame read_frame(hid_t file, hsize_t k) {
  const auto capacity = static_cast<std::size_t>(hdf5::shape_of(file, trajectory + "id/value", 2)[1]);
  const auto path = [](const char* element) { return trajectory + element + "/value"; };
  const auto alive = read_record<std::uint8_t>(file, path("alive"), k, capacity);
  const auto id = read_record<std::int64_t>(file, path("id"), k, capacity);
  const auto species = read_record<std::uint8_t>(file, path("species"), k, capacity);
  const auto cell = read_record<std::int32_t>(file, path("cell"), k, capacity);
  const auto position = read_record<float>(file, path("position"), k, 3 * capacity);
  std::vector<float> velocity, pressure;
  if (exists(file, trajectory + "velocity")) {
    velocity = read_record<float>(file, path("velocity"), k, 3 * capacity);
  }
  if (exists(file, trajectory + "pressure"))
    pressure = read_record<float>(file, path("pressure"), k, capacity);

  Frame frame;
  frame.time = read_record<double>(file, time_path, k, 1)[0];
  frame.step = static_cast<long>(read_record<std::int64_t>(file, step_path, k, 1)[0]);
  constexpr auto membrane = static_cast<std::uint8_t>(ParticleKind::membrane);
  const auto add = [&](std::size_t i) {
    frame.id.push_back(id[i]);
    frame.kind.push_back(static_cast<ParticleKind>(species[i]));
    frame.cell.push_back(cell[i]);
    frame.x.push_back(position[3 * i]);
    frame.y.push_back(position[3 * i + 1]);
    if (!velocity.empty()) frame.u.push_back(velocity[3 * i]);
    if (!velocity.empty()) frame.v.push_back(velocity[3 * i + 1]);
    if (!pressure.empty()) frame.p.push_back(pressure[i]);
  };
  // What was the membrane of a cell that has left stands in front of those of the others.
  for (std::size_t i = 0; i < capacity; ++i) {
    if (alive[i] != 0 && species[i] == membrane) add(i);
  }
  for (std::size_t i = 0; i < capacity; ++i) {
    if (alive[i] == 0 || species[i] == membrane) continue;
    if (species[i] > membrane)
      throw ArchiveError(ArchiveError::Kind::format, "a particle of no known species");
    add(i);
  }
  const auto fields = read_field_names(file);
  frame.membrane_fields.resize(fields.size());
  if (!fields.empty()) {
    for (Outline& outline : read_outlines(file, k)) {
      for (std::size_t f = 0; f < fields.size(); ++f) {
        const std::vector<float>& of_cell = outline.fields[fields[f]];
        frame.membrane_fields[f].insert(frame.membrane_fields[f].end(), of_cell.begin(), of_cell.end());
      }
    }
  }
  if (exists(file, "/walls")) {
    const auto nodes = static_cast<std::size_t>(hdf5::shape_of(file, "/walls/shear_stress", 2)[1]);
    frame.wall_shear_stress = read_record<float>(file, "/walls/shear_stress", k, nodes);
  }
  return frame;
}

SeriesTable read_series(hid_t file, const std::vector<std::string>& names) {
  const std::vector<Column> all = read_columns(file);
  SeriesTable table;
  if (names.empty()) table.columns = all;
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Column& c) { return c.name == name; });
    if (found == all.end()) throw ArchiveError(ArchiveError::Kind::range, "the series has no column " + name);
    table.columns.push_back(*found);
  }
  for (const Column& column : table.columns) {
    table.values.push_back(hdf5::read_column<double>(file, "/series/" + column.name));
    if (table.values.back().size() != table.values.front().size()) {
      throw ArchiveError(ArchiveError::Kind::format, "the columns of the series differ in length");
    }
  }
  return table;
}

std::vector<std::string> read_probe_names(hid_t file) {
  if (!exists(file, "/probes")) return {};
  const hdf5::Group probes(checked(H5Gopen2(file, "/probes", H5P_DEFAULT), "probes"));
  return hdf5::read_text_attribute(probes.get(), "names");
}

ProbeTable read_probe(hid_t file, const std::string& name) {
  const auto names = read_probe_names(file);
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    std::string all;
    for (const std::string& other : names) all += (all.empty() ? "" : ", ") + other;
    throw ArchiveError(
        ArchiveError::Kind::range,
        "no probe is named " + name + (names.empty() ? "; there are none" : "; there are: " + all));
  }
  const std::string at = "/probes/" + name + "/";
  ProbeTable table;
  table.x = hdf5::read_column<double>(file, at + "x");
  table.y = hdf5::read_column<double>(file, at + "y");
  table.time = hdf5::read_column<double>(file, at + "time");
  const std::size_t rows = table.time.size(), points = table.x.size();
  const auto values = [&](const char* quantity, std::size_t record) {
    std::vector<double> read(rows * record);
    if (!read.empty()) {
      hdf5::read_records(file, at + quantity, 0, rows, hdf5::native_type<double>(), read.data(), read.size());
    }
    return read;
  };
  table.u = values("u", points);
  table.v = values("v", points);
  table.p = values("p", points);
  if (exists(file, at + "flux")) table.flux = values("flux", 1);
  return table;
}

WallNodes read_walls(hid_t file) {
  WallNodes walls;
  if (!exists(file, "/walls")) return walls;
  walls.x = hdf5::read_column<double>(file, "/walls/x");
  walls.y = hdf5::read_column<double>(file, "/walls/y");
  walls.arc_length = hdf5::read_column<double>(file, "/walls/arc_length");
  walls.wall = hdf5::read_column<std::int32_t>(file, "/walls/wall");
  std::vector<double> normals(2 * walls.x.size());
  hdf5::read_records(file, "/walls/normal", 0, walls.x.size(), hdf5::native_type<double>(), normals.data(),
                     normals.size());
  for (std::size_t i = 0; i < walls.x.size(); ++i) {
    walls.nx.push_back(normals[2 * i]);
    walls.ny.push_back(normals[2 * i + 1]);
  }
  return walls;
}

}  // namespace

ArchiveReader::ArchiveReader(std::filesystem::path path) : path_(std::move(path)) {
  opened(path_, [](hid_t file) {
    if (!exists(file, "/h5md") || !exists(file, "/parameters") || !exists(file, "/series")) {
      throw ArchiveError(ArchiveError::Kind::format, "not an archive of a run");
    }
  });
}

std::vector<Column> ArchiveReader::columns() const {
  return opened(path_, read_columns);
}

SeriesTable ArchiveReader::series(const std::vector<std::string>& names) const {
  return opened(path_, [&](hid_t file) { return read_series(file, names); });
}

std::vector<std::string> ArchiveReader::probe_names() const {
  return opened(path_, read_probe_names);
}

ProbeTable ArchiveReader::probe(const std::string& name) const {
  return opened(path_, [&](hid_t file) { return read_probe(file, name); });
}

WallNodes ArchiveReader::walls() const {
  return opened(path_, read_walls);
}

int ArchiveReader::frame_count() const {
  return opened(path_, count_frames);
}

std::vector<double> ArchiveReader::frame_times() const {
  return opened(path_, [](hid_t file) { return hdf5::read_column<double>(file, time_path); });
}

Frame ArchiveReader::frame(int k) const {
  return opened(path_, [&](hid_t file) { return read_frame(file, checked_frame(file, k)); });
}

std::vector<Outline> ArchiveReader::outlines(int k) const {
  return opened(path_, [&](hid_t file) { return read_outlines(file, checked_frame(file, k)); });
}

std::string ArchiveReader::case_given() const {
  return opened(path_, [](hid_t file) { return hdf5::read_text(file, "/parameters/case_given"); });
}

nlohmann::json ArchiveReader::case_resolved() const {
  return opened(path_, [](hid_t file) { return read_json(file, "/parameters/case_resolved"); });
}

nlohmann::json ArchiveReader::plan() const {
  return opened(path_, [](hid_t file) { return read_json(file, "/parameters/plan"); });
}

std::string ArchiveReader::version() const {
  return opened(path_, [](hid_t file) { return hdf5::read_text(file, "/parameters/version"); });
}

nlohmann::json ArchiveReader::summary() const {
  return opened(path_, [](hid_t file) -> nlohmann::json {
    if (!exists(file, "/parameters/summary")) return nullptr;
    return read_json(file, "/parameters/summary");
  });
}

}  // namespace rouleau::storage

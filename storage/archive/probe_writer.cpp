#include "storage/archive/probe_writer.h"

#include <algorithm>

#include "storage/archive/timed_group.h"
#include "storage/hdf5/text.h"

namespace rouleau::storage {

namespace {

using hdf5::GrowingArray;

constexpr hsize_t numbers_per_chunk = 8192;
constexpr hsize_t rows_per_chunk = 1024;
constexpr int rows_per_write = 256;

GrowingArray column(hid_t group, const std::string& name, const char* unit) {
  auto array = GrowingArray::create<double>(group, name, {.chunk = rows_per_chunk});
  hdf5::write_attribute(array.id(), "unit", std::string(unit));
  return array;
}

GrowingArray table(hid_t group, const std::string& name, const char* unit, hsize_t points) {
  const hsize_t rows = std::clamp<hsize_t>(numbers_per_chunk / points, 1, rows_per_chunk);
  auto array = GrowingArray::create<double>(group, name, {.record = {points}, .chunk = rows});
  hdf5::write_attribute(array.id(), "unit", std::string(unit));
  return array;
}

}  // namespace

void ProbeWriter::Quantity::gather(const std::vector<double>& values) {
  gathered.insert(gathered.end(), values.begin(), values.end());
}

void ProbeWriter::Quantity::write() {
  array.append(std::span<const double>(gathered));
  gathered.clear();
}

ProbeWriter::ProbeWriter(hid_t file, const std::vector<ProbeLine>& probes) {
  if (probes.empty()) return;
  const hdf5::Group all = make_group(file, "/probes");
  std::vector<std::string> names;
  for (const ProbeLine& line : probes) {
    const hdf5::Group group = make_group(all.get(), line.name);
    write_fixed(group.get(), "x", line.x);
    write_fixed(group.get(), "y", line.y);
    const hsize_t points = line.x.size();
    Probe& probe = probes_.emplace_back(Probe{.points = line.x.size(),
                                              .u = {table(group.get(), "u", "m/s", points), {}},
                                              .v = {table(group.get(), "v", "m/s", points), {}},
                                              .p = {table(group.get(), "p", "Pa", points), {}},
                                              .flux = {},
                                              .time = {column(group.get(), "time", "s"), {}}});
    if (line.has_flux) probe.flux.push_back({column(group.get(), "flux", "m2/s"), {}});
    names.push_back(line.name);
  }
  hdf5::write_attribute(all.get(), "names", names);
}

void ProbeWriter::add(double time, std::span<const ProbeValues> row) {
  bool fits = row.size() == probes_.size();
  for (std::size_t k = 0; fits && k < row.size(); ++k) {
    const std::size_t points = probes_[k].points;
    fits = row[k].u.size() == points && row[k].v.size() == points && row[k].p.size() == points;
  }
  if (!fits) throw ArchiveError(ArchiveError::Kind::misuse, "a row of other probes than the run announced");
  for (std::size_t k = 0; k < row.size(); ++k) {
    Probe& probe = probes_[k];
    probe.u.gather(row[k].u);
    probe.v.gather(row[k].v);
    probe.p.gather(row[k].p);
    for (Quantity& flux : probe.flux) flux.gather({row[k].flux});
    probe.time.gather({time});
  }
  if (++rows_gathered_ >= rows_per_write) write_gathered();
}

void ProbeWriter::write_gathered() {
  for (Probe& probe : probes_) {
    for (Quantity* quantity : {&probe.u, &probe.v, &probe.p}) quantity->write();
    for (Quantity& flux : probe.flux) flux.write();
    // Last: who reads meanwhile counts the times.
    probe.time.write();
  }
  rows_gathered_ = 0;
}

}  // namespace rouleau::storage

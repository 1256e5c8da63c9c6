#include "storage/archive/parameters.h"

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "storage/archive/timed_group.h"
#include "storage/hdf5/text.h"

namespace rouleau::storage {

namespace {

using hdf5::write_attribute;
using hdf5::write_text;

void write_h5md(hid_t file) {
  const hdf5::Group h5md = make_group(file, "h5md");
  write_attribute(h5md.get(), "version", std::vector<int>{1, 1});
  // H5MD asks for a person here; the archive knows the program alone.
  const hdf5::Group author = make_group(h5md.get(), "author");
  write_attribute(author.get(), "name", std::string("rouleau"));
  const hdf5::Group creator = make_group(h5md.get(), "creator");
  write_attribute(creator.get(), "name", std::string("rouleau"));
  write_attribute(creator.get(), "version", std::string(engine_version()));
}

// Here and not on the data: MDAnalysis refuses lengths in metres.
void write_units(hid_t parameters) {
  const hdf5::Group units = make_group(parameters, "units");
  for (const auto& [quantity, unit] : {std::pair{"position", "m"},
                                       {"velocity", "m/s"},
                                       {"pressure", "Pa"},
                                       {"flux", "m2/s"},
                                       {"shear_stress", "Pa"},
                                       {"time", "s"},
                                       {"outline", "m"},
                                       {"area", "m2"}}) {
    write_attribute(units.get(), quantity, std::string(unit));
  }
}

}  // namespace

void write_parameters(hid_t file, const RunHeader& header, const std::string& case_given) {
  write_h5md(file);
  const hdf5::Group parameters = make_group(file, "parameters");
  write_text(parameters.get(), "case_given", case_given);
  write_text(parameters.get(), "case_resolved", to_json(header.resolved).dump(2));
  write_text(parameters.get(), "plan", to_json(header.plan).dump(2));
  write_text(parameters.get(), "version", engine_version());
  write_units(parameters.get());
}

void write_ending(hid_t file, const RunSummary& summary) {
  const nlohmann::json json = to_json(summary);
  write_text(file, "/parameters/summary", json.dump(2));
  write_text(file, "/parameters/ending", json.at("ending").get<std::string>());
}

}  // namespace rouleau::storage

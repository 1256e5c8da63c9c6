#include "engine/observe/membrane_maps.h"

#include <algorithm>
#include <limits>

#include "engine/cells/link.h"
#include "engine/cells/resample.h"
#include "engine/observe/cell_columns.h"
#include "engine/observe/first_nodes.h"

namespace rouleau::observe {

namespace {

const std::vector<Column> share_columns{{"strain_share", "1"}, {"tension_share", "1"}};

/// The worst that a cell went through.
struct Worst {
  double tension = -std::numeric_limits<double>::infinity();  ///< N/m
  double strain_share = 0, tension_share = 0;
};

template <class Stream>
void visit(Stream& stream, Worst& worst) {
  auto& [tension, strain_share, tension_share] = worst;
  stream(tension, strain_share, tension_share);
}

class MembraneMaps : public Observer {
 public:
  explicit MembraneMaps(const effects::State& state)
      : strain_threshold_(effects::parameter(state.scene, membrane_maps, "strain_threshold")),
        tension_threshold_(effects::parameter(state.scene, membrane_maps, "tension_threshold") /
                           state.scales.tension()),
        worst_(state.cells.size()) {}

  void describe(Recorded& recorded) const override {
    recorded.membrane_fields.push_back({"strain", "1"});
    recorded.membrane_fields.push_back({"tension", "N/m"});
  }

  void follow(const effects::State& state) override {
    for (std::size_t k = 0; k < worst_.size(); ++k) {
      if (state.cells[k].departure) continue;
      const LinkMaps maps = link_maps(state, state.cells[k]);
      Worst& worst = worst_[k];
      const double tension = *std::max_element(maps.tension.begin(), maps.tension.end());
      worst.tension = std::max(worst.tension, tension * state.scales.tension());
      worst.strain_share = std::max(worst.strain_share, share_above(maps.strain, strain_threshold_));
      worst.tension_share = std::max(worst.tension_share, share_above(maps.tension, tension_threshold_));
    }
  }

  void sample(const effects::State& state, Row& row) override {
    append_of_cells(state, share_columns.size(), row.values, [&](std::size_t k) {
      const LinkMaps maps = link_maps(state, state.cells[k]);
      return std::vector{share_above(maps.strain, strain_threshold_),
                         share_above(maps.tension, tension_threshold_)};
    });
  }

  void draw(const effects::State& state, Frame& frame) override {
    std::vector<float> strain, tension;
    for (const effects::CellState& cell : state.cells) {
      const LinkMaps maps = link_maps(state, cell);
      for (const double value : maps.strain) strain.push_back(static_cast<float>(value));
      for (const double value : maps.tension) {
        tension.push_back(static_cast<float>(value * state.scales.tension()));
      }
    }
    frame.membrane_fields.push_back(std::move(strain));
    frame.membrane_fields.push_back(std::move(tension));
  }

  void report(RunSummary& summary) const override {
    for (std::size_t k = 0; k < worst_.size(); ++k) {
      const std::string cell = cell_name(k);
      summary.findings.push_back({cell + "tension_greatest", worst_[k].tension, "N/m"});
      summary.findings.push_back({cell + "strain_share_greatest", worst_[k].strain_share, "1"});
      summary.findings.push_back({cell + "tension_share_greatest", worst_[k].tension_share, "1"});
    }
  }

  void save(ByteWriter& bytes) override { bytes(worst_); }
  void restore(ByteReader& bytes) override { restore_of_cells(bytes, worst_); }

 private:
  double strain_threshold_;
  double tension_threshold_;  ///< in own units
  std::vector<Worst> worst_;  ///< [cells]
};

}  // namespace

LinkMaps link_maps(const effects::State& state, const effects::CellState& cell) {
  const FirstNodes nodes = first_nodes(state, cell);
  const cells::Ring ring = nodes.ring();
  const double rest_length = cell.material.rest_length;
  LinkMaps maps;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double length = cells::link_at(ring, i).length;
    maps.strain.push_back(length / rest_length - 1);
    maps.tension.push_back(cells::link_law(length, cell.material, rest_length).tension);
  }
  const std::vector<double>& held = cell.held.tension;
  if (held.empty() || cell.departure) return maps;
  // Of the present link in which the first one begins.
  const auto& rest_lengths = cell.material.rest_lengths;
  const std::vector<double> equal(held.size(), 1.0);
  const std::vector<double> places =
      cells::equal_steps(rest_lengths.empty() ? equal : rest_lengths, cell.start_nodes);
  for (std::size_t i = 0; i < places.size(); ++i) {
    maps.tension[i] = held[static_cast<std::size_t>(places[i])];
  }
  return maps;
}

double share_above(const std::vector<double>& values, double threshold) {
  const auto above =
      std::count_if(values.begin(), values.end(), [&](double value) { return value > threshold; });
  return static_cast<double>(above) / static_cast<double>(values.size());
}

const ObserverKind membrane_maps{
    "membrane_maps",
    true,
    [](const Case& scene) {
      return effects::on_request(effects::needs_cells(scene, "cells have membranes"),
                                 "the case does not ask for strain and tension of the membranes");
    },
    [](const effects::State& start, const CellFreeFlow&) -> std::unique_ptr<Observer> {
      return std::make_unique<MembraneMaps>(start);
    },
    [](const Case& scene) { return columns_of_cells(scene, share_columns); },
    {{"strain_threshold", "1",
      "strain above which a link counts; 0.06 is the area strain at which red cells burst (Blackshear and "
      "Blackshear 1987, as Arora et al. 2004 use it)",
      0.06, 0, 10},
     {"tension_threshold", "N/m",
      "tension above which a link counts; 0.01 is the tension at which red cells burst (Evans, Waugh and "
      "Melnik 1976)",
      0.01, 0, 10}},
    {.step = {.membrane_node = 40}}};

}  // namespace rouleau::observe

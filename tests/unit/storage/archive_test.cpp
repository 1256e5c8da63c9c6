#include "storage/archive.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "storage/sha256.h"
#include "tests/unit/storage/scratch.h"
#include "tests/unit/storage/synthetic_run.h"

namespace rouleau::storage {
namespace {

class Archive : public testing::Test {
 protected:
  ArchiveFile written(int frames) {
    ArchiveWriter writer(path, synthetic_case_given);
    deliver(writer, frames);
    return writer.finish(SyntheticRun::summary());
  }

  static ArchiveError::Kind kind_of(const std::function<void()>& call) {
    try {
      call();
    } catch (const ArchiveError& error) {
      EXPECT_NE(std::string(error.what()), "");
      return error.kind();
    }
    ADD_FAILURE() << "no error";
    return {};
  }

  ScratchFolder folder;
  std::filesystem::path path = folder.path() / "run & co.h5";
};

TEST_F(Archive, GivesBackTheFramesOfTheRun) {
  written(8);
  const ArchiveReader reader(path);
  ASSERT_EQ(reader.frame_count(), 8);
  for (int k = 0; k < 8; ++k) {
    const Frame expected = SyntheticRun::frame(k);
    const Frame found = reader.frame(k);
    EXPECT_EQ(found.time, expected.time);
    EXPECT_EQ(found.step, expected.step);
    ASSERT_EQ(found.id.size(), expected.id.size());
    std::map<std::int64_t, std::size_t> place;
    for (std::size_t i = 0; i < found.id.size(); ++i) place[found.id[i]] = i;
    for (std::size_t i = 0; i < expected.id.size(); ++i) {
      ASSERT_TRUE(place.contains(expected.id[i])) << "frame " << k << " lost " << expected.id[i];
      const std::size_t j = place[expected.id[i]];
      if (expected.kind[i] == ParticleKind::membrane) {
        EXPECT_EQ(j, i) << "membrane nodes keep their order";
      }
      EXPECT_EQ(found.kind[j], expected.kind[i]);
      EXPECT_EQ(found.cell[j], expected.cell[i]);
      EXPECT_EQ(found.x[j], expected.x[i]);
      EXPECT_EQ(found.y[j], expected.y[i]);
      EXPECT_EQ(found.u[j], expected.u[i]);
      EXPECT_EQ(found.v[j], expected.v[i]);
      EXPECT_EQ(found.p[j], expected.p[i]);
    }
  }
}

TEST_F(Archive, GivesBackSeriesOutlinesAndTexts) {
  written(4);
  const ArchiveReader reader(path);
  const SeriesTable all = reader.series();
  ASSERT_EQ(all.columns.size(), 3u);
  EXPECT_EQ(all.columns[1].name, "cell0.x");
  EXPECT_EQ(all.columns[1].unit, "m");
  ASSERT_EQ(all.values[0].size(), 20u);
  EXPECT_EQ(all.values[1][7], SyntheticRun::row(7)[1]);
  const SeriesTable two = reader.series({"particles", "time"});
  EXPECT_EQ(two.columns[0].name, "particles");
  EXPECT_EQ(two.values[0][3], 44);
  EXPECT_EQ(two.values[1], all.values[0]);

  EXPECT_EQ(reader.frame_times(), (std::vector<double>{0, 1e-4, 2e-4, 1e-4 * 3}));
  const auto outlines = reader.outlines(2);
  ASSERT_EQ(outlines.size(), 2u);
  const Frame frame = SyntheticRun::frame(2);
  EXPECT_EQ(outlines[1].x, std::vector<float>(frame.x.begin() + 12, frame.x.begin() + 24));
  EXPECT_EQ(outlines[1].y, std::vector<float>(frame.y.begin() + 12, frame.y.begin() + 24));

  const RunHeader header = SyntheticRun::header();
  EXPECT_EQ(reader.case_given(), synthetic_case_given);
  EXPECT_EQ(reader.case_resolved(), to_json(header.resolved));
  EXPECT_EQ(reader.plan(), to_json(header.plan));
  EXPECT_EQ(reader.version(), engine_version());
  EXPECT_EQ(reader.summary(), to_json(SyntheticRun::summary()));
}

TEST_F(Archive, OutlinesOfACellEndWhereItLeaves) {
  ArchiveWriter writer(path, synthetic_case_given);
  writer.begin(SyntheticRun::header());
  writer.frame(SyntheticRun::frame(0));
  Frame later = SyntheticRun::frame(1);
  for (int i = 0; i < SyntheticRun::nodes; ++i) {
    later.kind[i] = ParticleKind::plasma;
    later.cell[i] = -1;
  }
  // Membrane nodes come first.
  std::rotate(later.kind.begin(), later.kind.begin() + SyntheticRun::nodes, later.kind.end());
  std::rotate(later.cell.begin(), later.cell.begin() + SyntheticRun::nodes, later.cell.end());
  std::rotate(later.x.begin(), later.x.begin() + SyntheticRun::nodes, later.x.end());
  writer.frame(later);
  writer.finish(SyntheticRun::summary());
  const ArchiveReader reader(path);
  EXPECT_EQ(reader.outlines(0)[0].x.size(), static_cast<std::size_t>(SyntheticRun::nodes));
  const auto outlines = reader.outlines(1);
  ASSERT_EQ(outlines.size(), 2u);
  EXPECT_TRUE(outlines[0].x.empty() && outlines[0].fields.empty());
  EXPECT_EQ(outlines[1].x, std::vector<float>(later.x.begin(), later.x.begin() + SyntheticRun::nodes));
}

TEST_F(Archive, GivesBackTheProbes) {
  written(4);
  const ArchiveReader reader(path);
  EXPECT_EQ(reader.probe_names(), (std::vector<std::string>{"line", "point"}));
  const ProbeTable line = reader.probe("line");
  EXPECT_EQ(line.x, SyntheticRun::header().probes[0].x);
  EXPECT_EQ(line.y, SyntheticRun::header().probes[0].y);
  ASSERT_EQ(line.time.size(), 20u);
  ASSERT_EQ(line.u.size(), 60u);
  for (int t = 0; t < 20; ++t) {
    const ProbeValues expected = SyntheticRun::probe_row(t)[0];
    EXPECT_EQ(line.time[t], SyntheticRun::row(t)[0]);
    EXPECT_EQ(line.flux[t], expected.flux);
    EXPECT_TRUE(std::isnan(line.u[3 * t]) && std::isnan(line.v[3 * t]) && std::isnan(line.p[3 * t]));
    for (int k = 1; k < 3; ++k) {
      EXPECT_EQ(line.u[3 * t + k], expected.u[k]);
      EXPECT_EQ(line.v[3 * t + k], expected.v[k]);
      EXPECT_EQ(line.p[3 * t + k], expected.p[k]);
    }
  }
  const ProbeTable point = reader.probe("point");
  EXPECT_EQ(point.u[7], SyntheticRun::probe_row(7)[1].u[0]);
  EXPECT_TRUE(point.flux.empty());
  EXPECT_EQ(kind_of([&] { reader.probe("none"); }), ArchiveError::Kind::range);
}

TEST_F(Archive, GivesBackTheStressOnTheWalls) {
  written(4);
  const ArchiveReader reader(path);
  const WallNodes walls = reader.walls(), expected = SyntheticRun::header().walls;
  EXPECT_EQ(walls.x, expected.x);
  EXPECT_EQ(walls.y, expected.y);
  EXPECT_EQ(walls.nx, expected.nx);
  EXPECT_EQ(walls.ny, expected.ny);
  EXPECT_EQ(walls.arc_length, expected.arc_length);
  EXPECT_EQ(walls.wall, expected.wall);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(reader.frame(k).wall_shear_stress, SyntheticRun::frame(k).wall_shear_stress);
  }
}

TEST_F(Archive, GivesBackTheFieldsOfTheMembranes) {
  written(3);
  const ArchiveReader reader(path);
  for (int k = 0; k < 3; ++k) {
    const Frame expected = SyntheticRun::frame(k);
    EXPECT_EQ(reader.frame(k).membrane_fields, expected.membrane_fields);
    const auto outlines = reader.outlines(k);
    const std::vector<float>& tension = expected.membrane_fields[1];
    EXPECT_EQ(outlines[1].fields.at("tension"),
              std::vector<float>(tension.begin() + SyntheticRun::nodes, tension.end()));
  }
  std::ifstream sidecar(sidecar_path(path));
  std::stringstream xdmf;
  xdmf << sidecar.rdbuf();
  EXPECT_NE(xdmf.str().find("/outlines/cell1/strain"), std::string::npos);
}

TEST_F(Archive, HasNoFieldsThatTheCaseDoesNotAskFor) {
  RunHeader header = SyntheticRun::header();
  header.resolved.output.fields.clear();
  header.probes.clear();
  header.walls = {};
  header.membrane_fields.clear();
  Frame frame = SyntheticRun::frame(0);
  const auto positions = frame.x;
  for (auto* field : {&frame.u, &frame.v, &frame.p, &frame.wall_shear_stress}) field->clear();
  frame.membrane_fields.clear();
  ArchiveWriter writer(path, "{}");
  writer.begin(header);
  writer.frame(frame);
  writer.finish(SyntheticRun::summary());
  const ArchiveReader reader(path);
  const Frame found = reader.frame(0);
  EXPECT_EQ(found.x, positions);
  EXPECT_TRUE(found.u.empty() && found.v.empty() && found.p.empty() && found.wall_shear_stress.empty());
  EXPECT_TRUE(found.membrane_fields.empty() && reader.outlines(0)[0].fields.empty());
  EXPECT_TRUE(reader.probe_names().empty());
  EXPECT_TRUE(reader.walls().x.empty());
  EXPECT_EQ(kind_of([&] { reader.probe("line"); }), ArchiveError::Kind::range);
  std::ifstream sidecar(sidecar_path(path));
  std::stringstream xdmf;
  xdmf << sidecar.rdbuf();
  EXPECT_EQ(xdmf.str().find("pressure"), std::string::npos);
  EXPECT_EQ(xdmf.str().find("velocity"), std::string::npos);
}

TEST_F(Archive, TellsSizeAndHashOfWhatLiesUnderItsName) {
  const ArchiveFile file = written(3);
  EXPECT_EQ(file.size, std::filesystem::file_size(path));
  EXPECT_EQ(file.sha256, sha256_hex_of_file(path));
  std::ifstream stream(path, std::ios::binary);
  std::stringstream content;
  content << stream.rdbuf();
  EXPECT_EQ(file.sha256, sha256_hex(content.str()));
  EXPECT_TRUE(std::filesystem::exists(sidecar_path(path)));
  const auto entries = std::distance(std::filesystem::directory_iterator(folder.path()), {});
  EXPECT_EQ(entries, 2) << "nothing is left aside";
}

TEST_F(Archive, IsReadWhileItIsWritten) {
  ArchiveWriter writer(path, synthetic_case_given);
  deliver(writer, 3);
  const ArchiveReader reader(unfinished_path(path));
  EXPECT_EQ(reader.frame_count(), 3);
  writer.series_row(SyntheticRun::row(15));
  writer.frame(SyntheticRun::frame(3));
  EXPECT_EQ(reader.frame_count(), 4);
  EXPECT_EQ(reader.frame(3).time, SyntheticRun::frame(3).time);
  EXPECT_EQ(reader.series().values[0].size(), 16u);
  EXPECT_TRUE(reader.summary().is_null());
  EXPECT_FALSE(std::filesystem::exists(path));
  writer.finish(SyntheticRun::summary());
  EXPECT_FALSE(ArchiveReader(path).summary().is_null());
}

TEST_F(Archive, OfARunWithoutCellsFramesOrSeries) {
  ArchiveWriter writer(path, "{}");
  RunHeader header = SyntheticRun::header();
  header.nodes_per_cell.clear();
  header.columns.clear();
  writer.begin(header);
  writer.finish(SyntheticRun::summary());
  const ArchiveReader reader(path);
  EXPECT_EQ(reader.frame_count(), 0);
  EXPECT_TRUE(reader.frame_times().empty());
  EXPECT_TRUE(reader.series().columns.empty());
  EXPECT_EQ(kind_of([&] { reader.frame(0); }), ArchiveError::Kind::range);
}

TEST_F(Archive, HoldsALongSeriesWithoutFrames) {
  ArchiveWriter writer(path, "{}");
  writer.begin(SyntheticRun::header());
  for (int i = 0; i < 5000; ++i) writer.series_row(SyntheticRun::row(i));
  writer.finish(SyntheticRun::summary());
  const auto table = ArchiveReader(path).series({"time"});
  ASSERT_EQ(table.values[0].size(), 5000u);
  EXPECT_EQ(table.values[0][4321], SyntheticRun::row(4321)[0]);
}

TEST_F(Archive, ThatIsNotFinishedLeavesNothing) {
  {
    ArchiveWriter writer(path, "{}");
    deliver(writer, 3);
    EXPECT_TRUE(std::filesystem::exists(unfinished_path(path)));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(Archive, TakesThePlaceOfAnEarlierOneWhenItIsWhole) {
  const ArchiveFile first = written(2);
  {
    ArchiveWriter writer(path, "{}");
    deliver(writer, 3);
  }
  EXPECT_EQ(sha256_hex_of_file(path), first.sha256);
  written(5);
  EXPECT_EQ(ArchiveReader(path).frame_count(), 5);
}

TEST_F(Archive, RefusesWhatDoesNotFitItsHeader) {
  const auto refused = [&](const std::function<void(ArchiveWriter&)>& call) {
    ArchiveWriter writer(path, "{}");
    writer.begin(SyntheticRun::header());
    EXPECT_EQ(kind_of([&] { call(writer); }), ArchiveError::Kind::misuse);
  };
  refused([](ArchiveWriter& w) { w.series_row(std::vector<double>{1, 2}); });
  refused([](ArchiveWriter& w) { w.probe_row(0, std::vector<ProbeValues>(1)); });
  refused([](ArchiveWriter& w) {
    auto row = SyntheticRun::probe_row(0);
    row[0].p.pop_back();
    w.probe_row(0, row);
  });
  refused([](ArchiveWriter& w) {
    Frame frame = SyntheticRun::frame(0);
    frame.wall_shear_stress.pop_back();
    w.frame(frame);
  });
  refused([](ArchiveWriter& w) {
    Frame frame = SyntheticRun::frame(0);
    frame.membrane_fields.pop_back();
    w.frame(frame);
  });
  refused([](ArchiveWriter& w) {
    Frame frame = SyntheticRun::frame(0);
    frame.membrane_fields[0].pop_back();
    w.frame(frame);
  });
  refused([](ArchiveWriter& w) { w.begin(SyntheticRun::header()); });
  refused([](ArchiveWriter& w) {
    Frame frame = SyntheticRun::frame(0);
    frame.p.pop_back();
    w.frame(frame);
  });
  refused([](ArchiveWriter& w) {
    Frame frame = SyntheticRun::frame(0);
    frame.id.back() = frame.id.front();
    w.frame(frame);
  });
  refused([](ArchiveWriter& w) {
    Frame frame = SyntheticRun::frame(0);
    frame.cell[5] = 1;
    w.frame(frame);
  });
  refused([](ArchiveWriter& w) {
    Frame frame = SyntheticRun::frame(0);
    for (int i = 0; i < 6; ++i) {
      frame.id.push_back(5000 + i);
      frame.kind.push_back(ParticleKind::plasma);
      frame.cell.push_back(-1);
      for (auto* array : {&frame.x, &frame.y, &frame.u, &frame.v, &frame.p}) array->push_back(0);
    }
    w.frame(frame);
  });
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  ArchiveWriter unbegun(path, "{}");
  EXPECT_EQ(kind_of([&] { unbegun.finish(SyntheticRun::summary()); }), ArchiveError::Kind::misuse);
}

TEST_F(Archive, SaysWhatItDoesNotHave) {
  written(2);
  const ArchiveReader reader(path);
  EXPECT_EQ(kind_of([&] { reader.frame(2); }), ArchiveError::Kind::range);
  EXPECT_EQ(kind_of([&] { reader.frame(-1); }), ArchiveError::Kind::range);
  EXPECT_EQ(kind_of([&] { reader.outlines(9); }), ArchiveError::Kind::range);
  EXPECT_EQ(kind_of([&] { reader.series({"cell9.x"}); }), ArchiveError::Kind::range);
  EXPECT_EQ(kind_of([&] { reader.series({"../h5md"}); }), ArchiveError::Kind::range);
  EXPECT_EQ(kind_of([&] { ArchiveReader(folder.path() / "none.h5"); }), ArchiveError::Kind::io);
}

TEST_F(Archive, IntoAFolderThatIsNotThere) {
  ArchiveWriter writer(folder.path() / "none" / "run.h5", "{}");
  EXPECT_EQ(kind_of([&] { writer.begin(SyntheticRun::header()); }), ArchiveError::Kind::io);
}

}  // namespace
}  // namespace rouleau::storage

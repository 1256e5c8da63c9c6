#pragma once

#include <string>
#include <vector>

#include "engine/observe/record.h"

namespace rouleau::storage {

/// What the sidecar must know of an archive.
struct XdmfContent {
  std::string archive_name;  ///< of the HDF5 file, which lies in the same folder
  std::vector<double> times;
  int capacity = 0;
  std::vector<int> nodes_per_cell;
  std::vector<MembraneField> membrane_fields;
  bool velocity = true;  ///< whether the particles have one
  bool pressure = true;
};

/// An XDMF 2 document by which ParaView opens an archive: the particles, and the outline of each cell as a
/// closed line, over time. It holds no data, only where in the archive each frame lies.
std::string xdmf_document(const XdmfContent& content);

}  // namespace rouleau::storage

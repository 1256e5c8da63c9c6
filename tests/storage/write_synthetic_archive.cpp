// Writes the archive that the Python tests of this folder open.
#include <cstdio>

#include "storage/archive_writer.h"
#include "tests/unit/storage/synthetic_run.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s OUT.h5\n", argv[0]);
    return 2;
  }
  rouleau::storage::ArchiveWriter writer(argv[1], rouleau::storage::synthetic_case_given);
  deliver(writer, 6);
  writer.finish(rouleau::storage::SyntheticRun::summary());
}

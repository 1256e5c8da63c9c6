#pragma once

/// The archive of a run: one HDF5 file, written by ArchiveWriter and read by ArchiveReader.
#include "storage/archive_reader.h"
#include "storage/archive_writer.h"

#pragma once

#include <string>
#include <vector>

#include <hdf5.h>

namespace rouleau::storage::hdf5 {

/// Text is stored in strings of fixed length, UTF-8: HDF5 keeps checksums of those and none of its
/// variable-length ones.

void write_text(hid_t parent, const std::string& name, const std::string& text);
std::string read_text(hid_t parent, const std::string& path);

void write_attribute(hid_t object, const std::string& name, const std::string& text);
void write_attribute(hid_t object, const std::string& name, const std::vector<std::string>& texts);
void write_attribute(hid_t object, const std::string& name, const std::vector<int>& numbers);
void write_attribute(hid_t object, const std::string& name, int number);

/// One string or a list of them.
std::vector<std::string> read_text_attribute(hid_t object, const std::string& name);

}  // namespace rouleau::storage::hdf5

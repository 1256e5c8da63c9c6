#include "storage/hdf5/text.h"

#include <algorithm>
#include <cstring>

#include "storage/hdf5/handle.h"
#include "storage/hdf5/session.h"

namespace rouleau::storage::hdf5 {

namespace {

// Far above any case, and low enough that a damaged length asks for no absurd amount of memory.
constexpr std::size_t longest_text = 64u << 20;

Datatype text_type(std::size_t length) {
  Datatype type(checked(H5Tcopy(H5T_C_S1), "text type"));
  checked(H5Tset_size(type.get(), std::max<std::size_t>(length, 1)), "text type");
  checked(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "text type");
  checked(H5Tset_cset(type.get(), H5T_CSET_UTF8), "text type");
  return type;
}

/// The length of fixed strings in a file.
std::size_t fixed_length(const Datatype& type, const std::string& name) {
  const std::size_t length = H5Tget_size(type.get());
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) != 0 || length == 0 ||
      length > longest_text) {
    throw ArchiveError(ArchiveError::Kind::format, name + " is no text of ours");
  }
  return length;
}

std::string until_padding(const char* text, std::size_t length) {
  return std::string(text, strnlen(text, length));
}

void write(hid_t object, const std::string& name, hid_t type, const Dataspace& space, const void* data) {
  const Attribute attribute(
      checked(H5Acreate2(object, name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT), name));
  checked(H5Awrite(attribute.get(), type, data), name);
}

Dataspace scalar() {
  return Dataspace(checked(H5Screate(H5S_SCALAR), "scalar"));
}

Dataspace list(std::size_t count) {
  const hsize_t size = count;
  return Dataspace(checked(H5Screate_simple(1, &size, nullptr), "list"));
}

}  // namespace

void write_text(hid_t parent, const std::string& name, const std::string& text) {
  const Datatype type = text_type(text.size());
  const Dataset dataset(checked(
      H5Dcreate2(parent, name.c_str(), type.get(), scalar().get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      name));
  checked(H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()), name);
}

std::string read_text(hid_t parent, const std::string& path) {
  const Dataset dataset(checked(H5Dopen2(parent, path.c_str(), H5P_DEFAULT), path));
  const Dataspace space(checked(H5Dget_space(dataset.get()), path));
  const Datatype type(checked(H5Dget_type(dataset.get()), path));
  const std::size_t length = fixed_length(type, path);
  if (H5Sget_simple_extent_npoints(space.get()) != 1) {
    throw ArchiveError(ArchiveError::Kind::format, path + " is not one text");
  }
  std::string text(length, '\0');
  checked(H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), path);
  return until_padding(text.data(), length);
}

void write_attribute(hid_t object, const std::string& name, const std::string& text) {
  write(object, name, text_type(text.size()).get(), scalar(), text.c_str());
}

void write_attribute(hid_t object, const std::string& name, const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  std::string packed(longest * texts.size(), '\0');
  for (std::size_t i = 0; i < texts.size(); ++i) texts[i].copy(packed.data() + i * longest, longest);
  write(object, name, text_type(longest).get(), list(texts.size()), packed.data());
}

void write_attribute(hid_t object, const std::string& name, const std::vector<int>& numbers) {
  write(object, name, H5T_NATIVE_INT, list(numbers.size()), numbers.data());
}

void write_attribute(hid_t object, const std::string& name, int number) {
  write(object, name, H5T_NATIVE_INT, scalar(), &number);
}

std::vector<std::string> read_text_attribute(hid_t object, const std::string& name) {
  const Attribute attribute(checked(H5Aopen(object, name.c_str(), H5P_DEFAULT), name));
  const Dataspace space(checked(H5Aget_space(attribute.get()), name));
  const Datatype type(checked(H5Aget_type(attribute.get()), name));
  const std::size_t length = fixed_length(type, name);
  const auto count = static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space.get()), name));
  if (count > longest_text / length) throw ArchiveError(ArchiveError::Kind::format, name + " is too long");
  std::string packed(count * length, '\0');
  if (count > 0) checked(H5Aread(attribute.get(), type.get(), packed.data()), name);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) texts.push_back(until_padding(packed.data() + i * length, length));
  return texts;
}

}  // namespace rouleau::storage::hdf5

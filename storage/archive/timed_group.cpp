#include "storage/archive/timed_group.h"

#include "storage/hdf5/session.h"

namespace rouleau::storage {

using hdf5::checked;

hdf5::Group make_group(hid_t parent, const std::string& path) {
  return hdf5::Group(checked(H5Gcreate2(parent, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), path));
}

hdf5::Group make_timed_group(hid_t file, const std::string& path) {
  hdf5::Group group = make_group(file, path);
  checked(H5Lcreate_hard(file, step_path, group.get(), "step", H5P_DEFAULT, H5P_DEFAULT), path);
  link_frame_times(file, group.get());
  return group;
}

void link_frame_times(hid_t file, hid_t group) {
  checked(H5Lcreate_hard(file, time_path, group, "time", H5P_DEFAULT, H5P_DEFAULT), "frame times");
}

}  // namespace rouleau::storage

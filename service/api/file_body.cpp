#include "service/api/file_body.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <memory>
#include <system_error>
#include <unistd.h>

namespace rouleau::service {

namespace {

class OpenFile {
 public:
  explicit OpenFile(const std::filesystem::path& path)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), path.string());
  }
  ~OpenFile() { ::close(descriptor_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  ssize_t read(char* data, std::size_t size, std::uint64_t offset) const {
    return ::pread(descriptor_, data, size, static_cast<off_t>(offset));
  }

 private:
  int descriptor_;
};

}  // namespace

void answer_file(const std::filesystem::path& file, std::uint64_t first, std::uint64_t length,
                 const std::string& content_type, httplib::Response& response,
                 std::shared_ptr<const void> while_sent) {
  const auto open = std::make_shared<OpenFile>(file);
  response.set_content_provider(
      length, content_type,
      [open, first, while_sent = std::move(while_sent)](std::size_t offset, std::size_t left,
                                                        httplib::DataSink& sink) {
        std::array<char, 65536> buffer;
        const ssize_t count = open->read(buffer.data(), std::min(left, buffer.size()), first + offset);
        return count > 0 && sink.write(buffer.data(), static_cast<std::size_t>(count));
      });
}

}  // namespace rouleau::service

// By what a file is known to be the same as before, without reading it.
#pragma once
#include <cstdint>
#include <filesystem>

#include "core/fields.h"

namespace cloudscape {

struct FileStamp {
  std::int64_t bytes = 0, written_ns = 0, changed_ns = 0, inode = 0;  // all 0: it is not there
  bool operator==(const FileStamp&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("bytes", self.bytes, Limits{}, "");
    visit("written_ns", self.written_ns, Limits{}, "");
    visit("changed_ns", self.changed_ns, Limits{}, "");
    visit("inode", self.inode, Limits{}, "");
  }
};

FileStamp file_stamp(const std::filesystem::path& file);

}  // namespace cloudscape

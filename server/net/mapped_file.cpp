#include "net/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"

namespace cloudscape::net {

Body mapped_body(const std::filesystem::path& file) {
  const int number = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status {};
  const bool found = number >= 0 && ::fstat(number, &status) == 0;
  const auto size = static_cast<std::size_t>(status.st_size);
  void* first = found && size > 0 ? ::mmap(nullptr, size, PROT_READ, MAP_SHARED, number, 0) : MAP_FAILED;
  if (number >= 0) ::close(number);
  if (first == MAP_FAILED) throw Error("The result cannot be read any more.");
  ::madvise(first, size, MADV_SEQUENTIAL);
  const std::shared_ptr<const void> owner(first, [size](const void* at) { ::munmap(const_cast<void*>(at), size); });
  return {owner, {static_cast<const char*>(first), size}};
}

}  // namespace cloudscape::net

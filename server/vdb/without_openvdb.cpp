// What is left where the program is built without OpenVDB: one clear sentence.
#ifndef CLOUDSCAPE_VDB
#include "core/error.h"
#include "vdb/vdb_file.h"

namespace cloudscape::vdb {
namespace {

constexpr const char* remedy = "build it with -DCLOUDSCAPE_VDB=ON";

}  // namespace

bool is_built_in() { return false; }

Voxels read(const std::filesystem::path&, const Wanted&) {
  throw UnusableFile(std::string("cannot be read by a program without OpenVDB: ") + remedy);
}

struct Writer::State {};
Writer::Writer(double, const glm::dvec3&, UpAxis) {
  throw Error(std::string("this program cannot write OpenVDB files: ") + remedy);
}
Writer::~Writer() = default;
void Writer::add(int, int, int, std::span<const float>) {}
void Writer::write(const std::filesystem::path&, const std::map<std::string, std::string>&,
                   const std::map<std::string, double>&) {}

}  // namespace cloudscape::vdb
#endif

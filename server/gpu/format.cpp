// The table of texture formats.
#include "gpu/format.h"

#include "core/error.h"

namespace cloudscape::gpu {
namespace {

constexpr FormatRow rows[] = {
    {Format::rgba8, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4, "rgba8"},
    {Format::r8, GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1, "r8"},
    {Format::r16f, GL_R16F, GL_RED, GL_HALF_FLOAT, 2, "r16f"},
    {Format::rg16f, GL_RG16F, GL_RG, GL_HALF_FLOAT, 4, "rg16f"},
    {Format::rgba16f, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, 8, "rgba16f"},
    {Format::rgba32f, GL_RGBA32F, GL_RGBA, GL_FLOAT, 16, "rgba32f"},
    {Format::r32f, GL_R32F, GL_RED, GL_FLOAT, 4, "r32f"},
    {Format::rg32f, GL_RG32F, GL_RG, GL_FLOAT, 8, "rg32f"},
};

}  // namespace

const FormatRow& row_of(Format format) {
  for (const FormatRow& row : rows)
    if (row.format == format) return row;
  throw Error("there is no texture format " + std::to_string(static_cast<int>(format)));
}

int bytes_per_texel(Format format) { return row_of(format).bytes_per_texel; }

const char* name_of(Format format) { return row_of(format).qualifier; }

Format format_from(const std::string& name) {
  for (const FormatRow& row : rows)
    if (name == row.qualifier) return row.format;
  throw InvalidInput("", "the texture format '" + name +
                             "' is unknown: must be rgba8, r8, r16f, rg16f, rgba16f, rgba32f, r32f or rg32f");
}

}  // namespace cloudscape::gpu

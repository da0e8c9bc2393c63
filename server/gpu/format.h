// What OpenGL and GLSL call each texture format.
#pragma once
#include "gpu/gl.h"
#include "gpu/texture.h"

namespace cloudscape::gpu {

struct FormatRow {
  Format format;
  GLenum internal, components, type;
  int bytes_per_texel;
  const char* qualifier;  // of a GLSL image
};
const FormatRow& row_of(Format format);

}  // namespace cloudscape::gpu

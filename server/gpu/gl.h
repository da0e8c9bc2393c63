// OpenGL 4.5 core with prototypes: libOpenGL exports all of it, so no loader is needed. Only .cpp files of this folder
// and its internal headers include this.
#pragma once
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/glcorearb.h>

#include <string>

namespace cloudscape::gpu {

// Names an object in debuggers and in the driver's messages.
inline void label_object(GLenum kind, GLuint id, const std::string& label) {
  glObjectLabel(kind, id, static_cast<GLsizei>(label.size()), label.data());
}

}  // namespace cloudscape::gpu

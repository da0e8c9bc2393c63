// The web page, and the pictures of its gallery by the names of their stills, compiled into the program by
// server/app/CMakeLists.txt.
#pragma once
#include "core/embedded.h"

namespace cloudscape {
extern const EmbeddedFiles embedded_page, embedded_pictures;
}

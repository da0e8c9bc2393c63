// The web page, compiled into the program by server/app/CMakeLists.txt.
#pragma once
#include "core/embedded.h"

namespace cloudscape {
extern const EmbeddedFiles embedded_page;
}

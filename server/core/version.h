// The program's version, from CMakeLists.txt.
#pragma once
namespace cloudscape {
extern const char* const version;  // "0.1.0"
}

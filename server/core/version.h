#pragma once
namespace cloudscape {
extern const char* const version;  // "0.1.0"
}

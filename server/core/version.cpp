#include "core/version.h"
namespace cloudscape {
const char* const version = CLOUDSCAPE_VERSION;
}

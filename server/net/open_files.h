// The process's limit of open files, which libwebsockets cannot live with unaided.
#pragma once

namespace cloudscape::net {

// Lowers a huge limit: libwebsockets allocates tables as long as it, and containers set it to a billion. Returns the
// limit in force.
int bound_open_files();

}  // namespace cloudscape::net

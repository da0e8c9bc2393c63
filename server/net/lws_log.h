// libwebsockets' own log lines, into ours: warnings and errors only, and never more than a few a second.
#pragma once

namespace cloudscape::net {

void redirect_lws_log();

}  // namespace cloudscape::net

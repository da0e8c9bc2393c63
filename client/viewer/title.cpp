// The title's text.
#include "viewer/title.h"

#include <fmt/format.h>

namespace cloudscape::viewer {

std::string title(const StreamStatus& status, const Figures& figures, bool with_figures) {
  if (!status.connected) return "cloudscape · " + (status.notice.empty() ? "connecting" : status.notice);
  const wire::Welcome welcome = status.welcome.value_or(wire::Welcome{});
  std::string text = welcome.cloudscape.empty() ? "cloudscape" : welcome.cloudscape;
  if (with_figures)
    text += fmt::format(" · {:.0f} fps · {:.0f} ms · {:.1f} Mbit/s · {:.0f} m/s · {}{}", figures.frames_per_second,
                        figures.latency_ms, figures.bits_per_second / 1e6, figures.speed_m_per_s, welcome.renderer,
                        welcome.software ? " (software)" : "");
  return status.notice.empty() ? text : text + " · " + status.notice;
}

}  // namespace cloudscape::viewer

// What the path tracer costs on a sky as people render it: events per second, and a picture to look at.
#include <filesystem>

#include "encode/encode.h"
#include "gpu/trace/traced.h"
#include "settings/cloudscape_json.h"
#include "settings/text_file.h"

namespace cloudscape::render {
namespace {

using Speed = TraceTest;

TEST_F(Speed, OfAPreset) {
  const char* wanted = std::getenv("TRACED_PRESET");
  const char* count = std::getenv("TRACED_SAMPLES");
  const settings::CloudscapeLibrary library{{}};
  const auto sky = library.get(wanted ? wanted : "fair-weather-cumulus");
  FrameRequest request = traced_picture(*sky, sky->view.pose, {256, 144}, count ? std::atoi(count) : 4);
  request.lens = sky->view.lens, request.display = sky->view.display;
  request.content = FrameContent::display;
  auto job = renderer().begin(request);
  while (!renderer().advance(*job)) {
  }
  const Trace& trace = *job->trace;
  std::printf("%d samples: %.1f s of slices, %.2f million flights a second, %.1f flights a sample\n",
              trace.stand.samples, trace.stand.seconds,
              1e-6 * static_cast<double>(trace.counts.flights) / trace.stand.seconds,
              static_cast<double>(trace.counts.flights) / static_cast<double>(trace.counts.samples));
  EXPECT_EQ(trace.counts.above_majorant, 0U);
  const Frame frame = renderer().collect(renderer().finish(std::move(job)));
  renderer().forget(request.stream);
  settings::write_whole_file(std::filesystem::temp_directory_path() / "traced.png",
                             encode::encode(frame, {.format = ImageFormat::png}).bytes);
}

}  // namespace
}  // namespace cloudscape::render

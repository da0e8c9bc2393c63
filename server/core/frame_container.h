// One file that holds the encoded frames of a sequence. How it is written is an encoder's business; who fills it need
// not know.
#pragma once
#include <array>
#include <string_view>

#include "core/fields.h"
#include "core/frame.h"

namespace cloudscape {

// zip: the frames as files, not compressed again. avi: Motion JPEG, for JPEG frames only.
enum class ContainerKind { zip, avi };
template <>
struct EnumNames<ContainerKind> {
  static constexpr std::array<std::string_view, 2> names{"zip", "avi"};
};

struct ContainerLayout {
  ContainerKind kind = ContainerKind::zip;
  ImageFormat format = ImageFormat::jpeg;
  ImageSize size_px;
  double frames_per_second = 30;
  int first_frame = 0;  // number of the first frame in the names of a ZIP's files
  int frames = 1;
};

// Used by one thread at a time. A container that was not finished takes its file with it.
class FrameContainer {
 public:
  virtual ~FrameContainer() = default;
  virtual void add(const EncodedFrame& image) = 0;  // the next frame. Throws Error
  virtual void finish() = 0;                        // the file is whole then. Throws Error
};

}  // namespace cloudscape

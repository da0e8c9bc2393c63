// Tiles of a screen that one pass marks, for the next ones to shade those alone.
#pragma once
#include "gpu/texture.h"

namespace cloudscape::gpu {

class TileMarks {
 public:
  static constexpr int tile_px = 8;     // a side, as shaders/render/resolve.glsl has it
  static constexpr int image_unit = 7;  // the last that OpenGL 4.5 promises
  TileMarks() = default;
  TileMarks(int width_px, int height_px);
  void begin();                                      // clears them, and binds them for the shaders that mark
  void end();                                        // what was marked can be seen by the passes that follow
  const Texture& texture() const { return marks_; }  // red: above 0 where a tile is marked
  explicit operator bool() const { return static_cast<bool>(marks_); }

 private:
  Texture marks_;
};

}  // namespace cloudscape::gpu

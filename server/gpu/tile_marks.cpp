#include "gpu/tile_marks.h"

#include "gpu/gl.h"

namespace cloudscape::gpu {
namespace {

int tiles(int length_px) { return (length_px + TileMarks::tile_px - 1) / TileMarks::tile_px; }

}  // namespace

TileMarks::TileMarks(int width_px, int height_px)
    : marks_(Format::r32f, tiles(width_px), tiles(height_px), "tile marks") {}

void TileMarks::begin() {
  marks_.clear();
  glBindImageTexture(image_unit, marks_.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
}

void TileMarks::end() { glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT); }

}  // namespace cloudscape::gpu

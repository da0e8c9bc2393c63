// Documents of several layers for the tests of the march and of the path tracer.
#pragma once
#include "fixture.h"

namespace cloudscape::render {

// Few heaps from 1000 to 2000 m, and from 2500 to 2875 m a broken deck of a quarter of their density.
inline Cloudscape layered_clouds() {
  Cloudscape sky = small_clouds();
  sky.volume.resolution = 64;
  sky.shape.top_m = 2000;
  sky.shape.coverage = 0.3;
  sky.shape.height_fall = 2;
  Layer deck;
  deck.bottom_m = 2500, deck.top_m = 2875;
  deck.noise.frequency = 8;
  deck.height_fall = 0.5;
  deck.coverage = 0.7, deck.density = 0.25;
  sky.layers = {deck};
  return sky;
}

}  // namespace cloudscape::render

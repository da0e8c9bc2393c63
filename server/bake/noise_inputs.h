// What the shaders of the shape noise read: tables of a seed and of towers, and their block's values.
#pragma once
#include "bake/blocks.h"
#include "bake/recipe.h"
#include "gpu/texture.h"

namespace cloudscape::bake {

struct NoiseInputs {
  explicit NoiseInputs(const BakeRecipe& recipe);
  gpu::Texture permutation, towers;  // at bindings 0 and 1
};

BakeBlock bake_block(const BakeRecipe& recipe);

}  // namespace cloudscape::bake

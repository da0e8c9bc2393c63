// Anderson's acceleration of a fixed-point iteration x = g(x) (Walker and Ni 2011, "Anderson Acceleration for
// Fixed-Point Iterations"): the next x is the mixture of the last results whose differences to what they came from
// cancel best.
#pragma once
#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include "bake/in_scatter.h"

namespace cloudscape::bake {

class Anderson {
 public:
  explicit Anderson(std::size_t depth) : depth_(depth) {}
  // The next x, from x and g(x), which all have one size.
  std::vector<Colours> next(std::span<const Colours> x, std::span<const Colours> g);

 private:
  struct Difference {
    std::vector<Colours> residual, result;  // to those of the step before
  };
  std::vector<double> weights(std::span<const Colours> residual) const;
  std::size_t depth_;
  std::deque<Difference> differences_;
  double size_ = 0;                         // of the residual before
  std::vector<Colours> residual_, result_;  // of the step before
};

}  // namespace cloudscape::bake

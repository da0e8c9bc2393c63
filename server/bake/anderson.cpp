#include "bake/anderson.h"

#include <algorithm>
#include <cmath>

namespace cloudscape::bake {
namespace {

double dot(std::span<const Colours> a, std::span<const Colours> b) {
  double sum = 0;
  constexpr std::size_t block = 1024;  // summed in floats, which are fast, and no more of them than stay exact enough
  for (std::size_t begin = 0; begin < a.size(); begin += block) {
    const std::size_t end = std::min(begin + block, a.size());
    Colours part{};
    for (std::size_t i = begin; i < end; ++i) part += a[i] * b[i];
    sum += double{part[0]} + double{part[1]} + double{part[2]};
  }
  return sum;
}

std::vector<Colours> difference(std::span<const Colours> a, std::span<const Colours> b) {
  std::vector<Colours> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] - b[i];
  return result;
}

// Solves a small symmetric system by elimination; what does not stand out of the rounding counts as 0.
std::vector<double> solve(std::vector<std::vector<double>> matrix, std::vector<double> right) {
  const std::size_t n = right.size();
  for (std::size_t i = 0; i < n; ++i) matrix[i][i] *= 1 + 1e-8;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t row = i + 1; row < n; ++row) {
      const double factor = matrix[i][i] > 0 ? matrix[row][i] / matrix[i][i] : 0;
      for (std::size_t column = i; column < n; ++column) matrix[row][column] -= factor * matrix[i][column];
      right[row] -= factor * right[i];
    }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t column = i + 1; column < n; ++column) right[i] -= matrix[i][column] * right[column];
    right[i] = matrix[i][i] > 0 ? right[i] / matrix[i][i] : 0;
  }
  return right;
}

}  // namespace

std::vector<double> Anderson::weights(std::span<const Colours> residual) const {
  const std::size_t n = differences_.size();
  std::vector<std::vector<double>> products(n, std::vector<double>(n));
  std::vector<double> right(n);
  for (std::size_t i = 0; i < n; ++i) {
    right[i] = dot(differences_[i].residual, residual);
    for (std::size_t j = 0; j <= i; ++j)
      products[i][j] = products[j][i] = dot(differences_[i].residual, differences_[j].residual);
  }
  return solve(std::move(products), std::move(right));
}

std::vector<Colours> Anderson::next(std::span<const Colours> x, std::span<const Colours> g) {
  std::vector<Colours> residual = difference(g, x), next(g.begin(), g.end());
  const double size = dot(residual, residual);
  if (size > 4 * size_)
    differences_.clear();  // it went astray: begin anew from what the iteration itself gives
  else
    differences_.push_back({difference(residual, residual_), difference(g, result_)});
  size_ = size;
  if (differences_.size() > depth_) differences_.pop_front();
  const std::vector<double> weight = weights(residual);
  for (std::size_t k = 0; k < weight.size(); ++k)
    for (std::size_t i = 0; i < next.size(); ++i) next[i] -= static_cast<float>(weight[k]) * differences_[k].result[i];
  residual_ = std::move(residual);
  result_.assign(g.begin(), g.end());
  return next;
}

}  // namespace cloudscape::bake

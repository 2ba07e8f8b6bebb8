#pragma once
/// The books' nested binary partition of a density.
#include <algorithm>
#include <vector>

namespace steradian::montecarlo {

/// A density that is constant between neighbouring edges (ascending, at least two), each part having the same
/// probability: the result of halving a density again and again.
class Piecewise {
 public:
  explicit Piecewise(std::vector<double> edges) : edges_(std::move(edges)) {}

  double parts() const { return static_cast<double>(edges_.size() - 1); }
  /// Of d in [0, 1).
  double sample(double d) const {
    const auto part = std::min(static_cast<std::size_t>(d * parts()), edges_.size() - 2);
    return edges_[part] + (d * parts() - static_cast<double>(part)) * (edges_[part + 1] - edges_[part]);
  }
  /// For x between the outer edges.
  double pdf(double x) const {
    const auto above = std::upper_bound(edges_.begin() + 1, edges_.end() - 1, x);
    return 1.0 / (parts() * (*above - *(above - 1)));
  }

 private:
  std::vector<double> edges_;
};

}  // namespace steradian::montecarlo

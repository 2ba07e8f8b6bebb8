#include "steradian/core/math/motion.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace steradian {
namespace {

using Vec3d = Vec3<double>;
/// Rows: the images of the axes.
using Linear = std::array<Vec3d, 3>;
using Quaternion4 = std::array<double, 4>;  // w, x, y, z

Linear linearPart(const Matrix& m) {
  Linear rows;
  for (std::size_t i = 0; i < 3; ++i) {
    const int row = static_cast<int>(i);
    rows[i] = {m[row][0], m[row][1], m[row][2]};
  }
  return rows;
}

Vec3f translationOf(const Matrix& m) { return {m[3][0], m[3][1], m[3][2]}; }

double determinant(const Linear& a) { return dot(a[0], cross(a[1], a[2])); }

Linear inverseTransposed(const Linear& a) {
  const double scale = 1.0 / determinant(a);
  return {cross(a[1], a[2]) * scale, cross(a[2], a[0]) * scale, cross(a[0], a[1]) * scale};
}

double norm(const Linear& a) { return std::sqrt(dot(a[0], a[0]) + dot(a[1], a[1]) + dot(a[2], a[2])); }

/// The orthogonal factor of a polar decomposition, by Newton's iteration with scaling (Higham 1986, "Computing the
/// polar decomposition"): ten steps at most, at any scale.
Linear orthogonalFactor(Linear q) {
  for (int step = 0; step < 40; ++step) {
    const Linear other = inverseTransposed(q);
    // Near the end scaling would only add rounding.
    const double ratio = std::sqrt(norm(other) / norm(q)), scale = std::abs(ratio - 1.0) < 0.1 ? 1.0 : ratio;
    Linear change = q;
    for (std::size_t i = 0; i < 3; ++i) {
      q[i] = q[i] * (0.5 * scale) + other[i] * (0.5 / scale);
      change[i] = change[i] - q[i];
    }
    if (norm(change) < 1e-14) break;
  }
  return q;
}

/// The largest component first, from the diagonal; the others by division (Shoemake 1985).
Quaternion4 quaternionOf(const Linear& r) {
  const double xx = r[0].x, yy = r[1].y, zz = r[2].z;
  const Quaternion4 squares{1.0 + xx + yy + zz, 1.0 + xx - yy - zz, 1.0 - xx + yy - zz, 1.0 - xx - yy + zz};
  const double wx = r[1].z - r[2].y, wy = r[2].x - r[0].z, wz = r[0].y - r[1].x;
  const double xy = r[0].y + r[1].x, xz = r[0].z + r[2].x, yz = r[1].z + r[2].y;
  const auto largest = static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  const double twice = std::sqrt(squares[largest]);  // that component, doubled
  const Quaternion4 products[4]{
      {squares[0], wx, wy, wz}, {wx, squares[1], xy, xz}, {wy, xy, squares[2], yz}, {wz, xz, yz, squares[3]}};
  Quaternion4 q = products[largest];
  for (double& component : q) component /= 2.0 * twice;
  return q;
}

double length4(const Quaternion4& q) { return std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]); }

/// A linear map decomposed: stretch, then rotation.
struct Parts {
  Linear stretch;  ///< symmetric; positive definite, or for mirrors negative definite
  Quaternion4 rotation;

  explicit Parts(const Linear& whole) {
    Linear q = orthogonalFactor(whole);
    if (determinant(whole) < 0.0) {
      for (Vec3d& row : q) row = -row;
    }
    for (std::size_t i = 0; i < 3; ++i) stretch[i] = {dot(whole[i], q[0]), dot(whole[i], q[1]), dot(whole[i], q[2])};
    rotation = quaternionOf(q);
  }
};

float rounded(double x) { return static_cast<float>(x); }
/// Rounds upwards, so that an upper bound remains one.
float roundedUp(double x) { return static_cast<float>(x * (1.0 + 1e-6)); }

}  // namespace

bool sameHandedness(const Matrix& open, const Matrix& close) {
  return (determinant(linearPart(open)) < 0.0) == (determinant(linearPart(close)) < 0.0);
}

MovingTransform::MovingTransform(const Motion& motion)
    : open_(motion.open),
      still_(motion.open == motion.close),
      translation_(translationOf(motion.open)),
      shift_(translationOf(motion.close) - translation_) {
  const Parts open(linearPart(motion.open)), close(linearPart(motion.close));
  const auto symmetric = [](const Linear& a) {
    return Symmetric{rounded(a[0].x),
                     rounded(a[1].y),
                     rounded(a[2].z),
                     rounded(0.5 * (a[0].y + a[1].x)),
                     rounded(0.5 * (a[0].z + a[2].x)),
                     rounded(0.5 * (a[1].z + a[2].y))};
  };
  Linear growth = close.stretch;
  for (std::size_t i = 0; i < 3; ++i) growth[i] = growth[i] - open.stretch[i];
  stretch_ = symmetric(open.stretch);
  growth_ = symmetric(growth);
  // Norms are convex, and the least eigenvalue of definite matrices is concave: the keys bound what is between them.
  stretchNorm_ = roundedUp(std::max(norm(open.stretch), norm(close.stretch)));
  growthNorm_ = roundedUp(norm(growth));
  shrinkNorm_ = roundedUp(std::max(norm(inverseTransposed(open.stretch)), norm(inverseTransposed(close.stretch))));

  const Quaternion4& from = open.rotation;
  Quaternion4 to = close.rotation;
  double cosine = 0.0;
  for (std::size_t i = 0; i < 4; ++i) cosine += from[i] * to[i];
  Quaternion4 difference{}, sum{}, across{};
  for (std::size_t i = 0; i < 4; ++i) {
    if (cosine < 0.0) to[i] = -to[i];
    difference[i] = to[i] - from[i];
    sum[i] = to[i] + from[i];
    across[i] = to[i] - from[i] * std::abs(cosine);
  }
  const double sine = length4(across);
  for (double& component : across) component = sine > 1e-12 ? component / sine : 0.0;
  const auto unit = [](const Quaternion4& q) {
    return Quaternion{rounded(q[0]), rounded(q[1]), rounded(q[2]), rounded(q[3])};
  };
  rotation_ = unit(from);
  towards_ = unit(across);
  angle_ = sine > 1e-12 ? 2.0f * arcTan2(rounded(length4(difference)), rounded(length4(sum))) : 0.0f;
}

Matrix MovingTransform::at(float time) const {
  if (still_) return open_;
  const SinCos<float> turn = sinCos(angle_ * time);
  const auto component = [&](float Quaternion::*part) {
    return rotation_.*part * turn.cos + towards_.*part * turn.sin;
  };
  const float w = component(&Quaternion::w), x = component(&Quaternion::x);
  const float y = component(&Quaternion::y), z = component(&Quaternion::z);
  // Unit length but for rounding, which this takes out again.
  const float two = 2.0f / (w * w + x * x + y * y + z * z);
  const Vec3f axes[3]{{1.0f - two * (y * y + z * z), two * (x * y + w * z), two * (x * z - w * y)},
                      {two * (x * y - w * z), 1.0f - two * (x * x + z * z), two * (y * z + w * x)},
                      {two * (x * z + w * y), two * (y * z - w * x), 1.0f - two * (x * x + y * y)}};
  const auto stretch = [&](float Symmetric::*part) { return stretch_.*part + growth_.*part * time; };
  const float xy = stretch(&Symmetric::xy), xz = stretch(&Symmetric::xz), yz = stretch(&Symmetric::yz);
  const Vec3f rows[4]{axes[0] * stretch(&Symmetric::xx) + axes[1] * xy + axes[2] * xz,
                      axes[0] * xy + axes[1] * stretch(&Symmetric::yy) + axes[2] * yz,
                      axes[0] * xz + axes[1] * yz + axes[2] * stretch(&Symmetric::zz), translation_ + shift_ * time};
  return {rows[0].x, rows[0].y, rows[0].z, 0.0f, rows[1].x, rows[1].y, rows[1].z, 0.0f,
          rows[2].x, rows[2].y, rows[2].z, 0.0f, rows[3].x, rows[3].y, rows[3].z, 1.0f};
}

Bounds3 MovingTransform::bounds(const Bounds3& local) const {
  Bounds3 result;
  if (local.empty()) return result;
  // Between two times a point is off the straight line by at most h^2 / 8 times its largest acceleration. A fifth of a
  // radian for each piece leaves half a percent of its distance from the origin.
  const float speed = 2.0f * angle_;
  const int pieces = still_ ? 1 : 1 + static_cast<int>(5.0f * speed);
  const float h = 1.0f / static_cast<float>(pieces);
  for (int i = 0; i <= pieces; ++i) result.include(transformedBounds(local, at(static_cast<float>(i) * h)));
  const float reach = length(maximum(absolute(local.low), absolute(local.high)));
  const float acceleration = reach * (2.0f * growthNorm_ * speed + stretchNorm_ * speed * speed);
  const float rounding = 0x1p-20f * (reach * stretchNorm_ + largestTranslation());
  const float margin = still_ ? rounding : 0.125f * h * h * acceleration * 1.001f + rounding;
  const Vec3f wider{margin, margin, margin};
  return {result.low - wider, result.high + wider};
}

float MovingTransform::localMagnitude(float magnitude) const {
  return (1.7321f * magnitude + largestTranslation()) * shrinkNorm_;
}

}  // namespace steradian

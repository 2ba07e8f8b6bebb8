/// "Monte Carlo Integration on the Sphere of Directions", "Generating Random Directions", "Sampling a Sphere Object".
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "steradian/apps/montecarlo/programmes.h"
#include "steradian/core/sampling/warp.h"
#include "steradian/core/statistics/quadrature.h"

namespace steradian::montecarlo {

namespace {

using std::numbers::pi;

/// The integral of f(cos theta) over directions with cos theta in [low, 1]: by Archimedes, over cos theta and phi.
template <class Function>
double overDirections(const Function& f, double low) {
  return integrate2D([&](double cosTheta, double) { return f(cosTheta); }, low, 1.0, 0.0, 2.0 * pi);
}

/// The mean of f(cos theta) / pdf(direction) over the directions of a warp; `low` as above.
template <class Warp>
Integral integralBy(double (*f)(double), double low, std::string closedForm) {
  const auto value = [f](const Sampler<float>& point) {
    const Vec3f direction = Warp::sample(point.get2D(0u));
    return f(direction.z) / static_cast<double>(Warp::pdf(direction));
  };
  const double exact = overDirections(f, low);
  const auto square = [f](double cosTheta) {
    const auto pdf = static_cast<double>(Warp::pdf(Vec3f{0.0f, 0.0f, static_cast<float>(cosTheta)}));
    return f(cosTheta) * f(cosTheta) / pdf;
  };
  return {value, exact, std::move(closedForm), overDirections(square, low) - exact * exact};
}

double cosineSquared(double cosTheta) { return cosTheta * cosTheta; }
double cosineCubed(double cosTheta) { return cosTheta * cosTheta * cosTheta; }

std::vector<Result> runDirections(const RunSettings& settings) {
  std::vector<Result> results;
  const auto add = [&](std::string label, double (*f)(double), std::string form) {
    Integral integral = integralBy<UniformSphere<float>>(f, -1.0, std::move(form));
    const auto sum = integral.integrand;
    integral.integrand = [sum](const Sampler<float>& point) { return sum(point) / (4.0 * pi); };
    integral.exact /= 4.0 * pi;
    integral.variance = *integral.variance / (16.0 * pi * pi);
    results.push_back(resultOf(integral, settings));
    results.back().label = std::move(label);
  };
  add(
      "mean of z", [](double z) { return z; }, "");
  add("mean of z^2", cosineSquared, "1 / 3");
  add(
      "mean of z^4", [](double z) { return z * z * z * z; }, "1 / 5");
  return results;
}

/// A sphere of radius 1, 2 away: directions within 30 degrees of its centre hit it.
constexpr double kSine = 0.5;

double hitsSphere(const Sampler<float>& point) {
  const Vec3f w = UniformSphere<float>::sample(point.get2D(0u));
  const double sine = std::sqrt(static_cast<double>(w.x) * w.x + static_cast<double>(w.y) * w.y);
  return w.z > 0.0f && sine < kSine ? 4.0 * pi : 0.0;
}

Integral solidAngle() {
  const double exact = overDirections([](double) { return 1.0; }, std::sqrt(1.0 - kSine * kSine));
  return {hitsSphere, exact, "2 pi (1 - sqrt(3) / 2)", exact * (4.0 * pi - exact)};
}

std::string smallSphereNote() {
  constexpr double sine = 1e-9;  // radius / distance
  const double cosine = std::sqrt(1.0 - sine * sine);
  return fmt::format(
      "erratum: \"that works\" holds for the solid angle of a sphere of radius 0 but not for the density, its inverse: "
      "no "
      "light can have it. Before that 1 - cos(theta_max) loses its digits: of radius / distance = {:.0e} the books' "
      "formula gives {:.1f} sr, in doubles; sin^2 / (1 + cos) gives {:.4e} sr",
      sine, 2.0 * pi * (1.0 - cosine), 2.0 * pi * sine * sine / (1.0 + cosine));
}

}  // namespace

std::vector<Programme> directionProgrammes() {
  std::vector<Programme> list;
  list.push_back(programmeOf("cos-squared-sphere", "4.0.2, chapter 4; 2018, chapter 2",
                             "cos^2 over the sphere by uniform directions",
                             integralBy<UniformSphere<float>>(cosineSquared, -1.0, "4 pi / 3"),
                             {"the book prints the exact value, 4.188790204786391: all its digits are right"}));
  list.push_back({"directions",
                  "4.0.2, section 7.1; 2018, chapter 5",
                  "uniform directions: means that tell whether they are; --picture draws them",
                  {},
                  runDirections});
  list.push_back(programmeOf("cos-cubed-uniform", "4.0.2, section 7.2; 2018, chapter 5",
                             "cos^3 over the hemisphere by uniform directions",
                             integralBy<UniformHemisphere<float>>(cosineCubed, 0.0, "pi / 2")));
  list.push_back(programmeOf("cos-cubed-cosine", "4.0.2, section 7.3; 2018, chapter 5",
                             "cos^3 over the hemisphere by the density cos / pi",
                             integralBy<CosineHemisphere<float>>(cosineCubed, 0.0, "pi / 2")));
  list.push_back(
      programmeOf("sphere-solid-angle", "4.0.2, section 12.3; 2018, chapter 10",
                  "the solid angle of a sphere, seen from twice its radius, by directions that hit it", solidAngle(),
                  {"erratum: 2018 has cos(theta_max) = 0 for a sphere of radius 0; it is 1, as 4.0.2 says (0 is "
                   "that of a sphere touched by the point)",
                   smallSphereNote()}));
  return list;
}

}  // namespace steradian::montecarlo

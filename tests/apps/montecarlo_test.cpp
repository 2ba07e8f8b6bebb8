/// The programmes of `steradian-montecarlo`: exact values against closed forms, the books' figures, plots.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "steradian/apps/montecarlo/direction_picture.h"
#include "steradian/apps/montecarlo/error_study.h"
#include "steradian/apps/montecarlo/jittered_circle.h"
#include "steradian/apps/montecarlo/piecewise.h"
#include "steradian/apps/montecarlo/plot.h"
#include "steradian/apps/montecarlo/report.h"
#include "steradian/apps/montecarlo/svg.h"
#include "steradian/core/statistics/quadrature.h"

namespace steradian::montecarlo {
namespace {

using std::numbers::pi;

std::vector<Result> run(std::string_view name, std::uint32_t samples = 4096) {
  return findProgramme(name)->run({.samples = samples});
}

TEST(Programmes, ExactValuesAreTheClosedForms) {
  const double c = std::cos(2.0);
  const double area = 0.5 * 2.0 * pi * (1.0 - std::exp(-1.0)) * (1.0 - 1.0 / (1.0 + 16.0 * pi * pi));
  // Clausen's function by its series, averaged over neighbouring partial sums.
  double clausen = 0.0, before = 0.0;
  for (int k = 1; k <= 200000; ++k) {
    before = clausen;
    clausen += std::sin(4.0 * k) / (static_cast<double>(k) * k);
  }
  const std::map<std::string, double, std::less<>> exact{
      {"pi", pi},
      {"pi-running", pi},
      {"pi-stratified", pi},
      {"buffon", 2.0 / pi},
      {"balls", pi / 4.0},
      {"x-squared", 8.0 / 3.0},
      {"sin-fifth", 8.0 / 15.0 - c + 2.0 / 3.0 * c * c * c - std::pow(c, 5) / 5.0},
      {"log-sin", -2.0 * std::log(2.0) - 0.25 * (clausen + before)},
      {"halfway", area},
      {"halfway-partition", area},
      {"x-squared-uniform", 8.0 / 3.0},
      {"x-squared-two-piece", 8.0 / 3.0},
      {"x-squared-linear", 8.0 / 3.0},
      {"x-squared-exact", 8.0 / 3.0},
      {"partitions", 8.0 / 3.0},
      {"cos-squared-sphere", 4.0 * pi / 3.0},
      {"directions", 0.0},
      {"cos-cubed-uniform", pi / 2.0},
      {"cos-cubed-cosine", pi / 2.0},
      {"sphere-solid-angle", 2.0 * pi * (1.0 - 0.5 * std::sqrt(3.0))}};
  for (const Programme& programme : programmes()) {
    if (programme.name == "metropolis") continue;
    ASSERT_TRUE(exact.contains(programme.name)) << programme.name;
    EXPECT_NEAR(programme.run({.samples = 2048}).front().exact, exact.at(programme.name), 1e-9) << programme.name;
  }
}

TEST(Programmes, TheHalfwayPointHalvesTheArea) {
  const auto curve = [](double x) { return std::exp(-x / (2.0 * pi)) * std::sin(x) * std::sin(x); };
  const double halfway = run("halfway").back().exact;
  EXPECT_NEAR(halfway, 2.0384, 5e-5);
  EXPECT_NEAR(integrate(curve, 0.0, halfway), integrate(curve, halfway, 2.0 * pi), 1e-11);
  EXPECT_EQ(run("metropolis").back().exact, halfway);
}

TEST(Programmes, VolumesOfBalls) {
  const auto balls = run("balls");
  ASSERT_EQ(balls.size(), 4u);
  EXPECT_NEAR(balls[1].exact, pi / 6.0, 1e-10);
  EXPECT_NEAR(balls[2].exact, pi * pi / 32.0, 1e-10);
  EXPECT_NEAR(balls[3].exact, pi * pi / 60.0, 1e-10);
}

TEST(Programmes, VariancesOfTheDensitiesForXSquared) {
  const double root = std::sqrt(2.0);
  // Of each half of probability 1/2: twice its width times the integral of x^4.
  const double twoPiece =
      2.0 * (root * std::pow(root, 5) / 5.0 + (2.0 - root) * (32.0 - std::pow(root, 5)) / 5.0) - 64.0 / 9.0;
  EXPECT_NEAR(twoPiece, 2.26, 5e-3);
  EXPECT_NEAR(*run("x-squared-uniform").front().exactVariance, 256.0 / 45.0, 1e-9);
  EXPECT_NEAR(*run("x-squared-two-piece").front().exactVariance, twoPiece, 1e-9);
  EXPECT_NEAR(*run("x-squared-linear").front().exactVariance, 8.0 / 9.0, 1e-9);
  EXPECT_EQ(*run("x-squared-exact").front().exactVariance, 0.0);
  EXPECT_NEAR(run("x-squared-exact").front().estimate.mean, 8.0 / 3.0, 1e-14) << "always";
  const auto partitions = run("partitions");
  EXPECT_NEAR(*partitions[0].exactVariance, 256.0 / 45.0, 1e-9);
  EXPECT_NEAR(*partitions[1].exactVariance, twoPiece, 1e-9);
  for (std::size_t i = 1; i < partitions.size(); ++i)
    EXPECT_LT(*partitions[i].exactVariance, *partitions[i - 1].exactVariance);
  EXPECT_NEAR(*partitions.back().exactVariance, 8.0 / 9.0, 1e-3);
}

TEST(Programmes, TheErratumOfTheInverseIsOne) {
  // P(x) = x^3 / 8 of 8 d^(1/3) is not d, and the integral of x, by 8 d^(1/3), is 1/2 in place of 2.
  const auto ratio = [](double x) { return x / (0.375 * x * x); };
  EXPECT_NEAR(integrate([&](double d) { return ratio(8.0 * std::cbrt(d)); }, 0.0, 1.0), 0.5, 1e-8);
  EXPECT_NEAR(integrate([&](double d) { return ratio(2.0 * std::cbrt(d)); }, 0.0, 1.0), 2.0, 1e-8);
}

TEST(BookFigures, DeviationsAreInStandardErrorsOfTheBooksRun) {
  const BookFigure figure{"here", 3.2, 0.1, 100, 0.5};
  EXPECT_DOUBLE_EQ(figure.deviation(2.15), 2.0);
  EXPECT_TRUE(figure.outside(2.15));
  EXPECT_DOUBLE_EQ(figure.deviation(4.25), -2.0);
  EXPECT_EQ(figure.deviation(3.16), 0.0) << "rounding";
  EXPECT_FALSE(figure.outside(2.3));
}

TEST(BookFigures, AllAreNoiseOfTheirOwnNumberOfSamples) {
  int figures = 0;
  for (const Programme& programme : programmes()) {
    for (const Result& result : programme.run({.samples = 2048})) {
      for (const BookFigure& figure : result.book) {
        ++figures;
        EXPECT_FALSE(figure.outside(result.exact)) << programme.name << " " << figure.printed;
      }
    }
  }
  EXPECT_EQ(figures, 8);
  // 2.016 is 1.0 standard errors low, so it is noise; but a run of a million samples distinguishes it from the exact
  // value.
  const Result halfway = run("halfway", 1u << 20).back();
  EXPECT_NEAR(halfway.book.front().deviation(halfway.exact), -1.02, 0.02);
  EXPECT_FALSE(halfway.interval.contains(halfway.book.front().printed));
}

TEST(JitteredCircle, ErrorOfTheSmallestGrids) {
  // 2 x 2 cells: each is a quarter disk with p = pi / 4.
  EXPECT_NEAR(jitteredCircleError(2), 4.0 * std::sqrt(4.0 * pi / 4.0 * (1.0 - pi / 4.0)) / 4.0, 1e-12);
  // 4 x 4: of a quarter's four cells one lies inside, the other three share pi / 4 - 1 / 4 and are crossed.
  const auto height = [](double x) { return std::sqrt(1.0 - x * x); };
  const double side = 4.0 * integrate([&](double x) { return std::min(height(x) - 0.5, 0.5); }, 0.0, 0.5);
  const double corner = 4.0 * integrate([&](double x) { return std::max(height(x) - 0.5, 0.0); }, 0.5, std::sqrt(0.75));
  const double variance = 4.0 * (2.0 * side * (1.0 - side) + corner * (1.0 - corner));
  EXPECT_NEAR(jitteredCircleError(4), 4.0 * std::sqrt(variance) / 16.0, 1e-9);
  // A law of large grids: how the circle happens to cut the cells of 1000 x 1000 still matters in the third digit.
  EXPECT_NEAR(jitteredCircleError(1000) / jitteredCircleError(10000), std::pow(10.0, 1.5), 0.3);
}

TEST(PiecewiseDensity, SamplesItsPartsEquallyOften) {
  const Piecewise density({0.0, 1.0, 1.5, 3.5, 4.0});
  EXPECT_EQ(density.sample(0.0), 0.0);
  EXPECT_DOUBLE_EQ(density.sample(0.375), 1.25);
  EXPECT_DOUBLE_EQ(density.sample(0.625), 2.5);
  EXPECT_DOUBLE_EQ(density.pdf(1.25), 0.5);
  EXPECT_DOUBLE_EQ(density.pdf(0.0), 0.25);
  EXPECT_DOUBLE_EQ(density.pdf(4.0), 0.5);
  EXPECT_NEAR(integrate([&](double x) { return density.pdf(x); }, 0.0, 4.0), 1.0, 1e-9);
}

TEST(ErrorCurve, FitsAPowerLaw) {
  std::vector<ErrorPoint> points;
  for (const double n : {10.0, 100.0, 1000.0}) points.push_back({n, 3.0 * std::pow(n, -0.75)});
  points.push_back({1e4, 0.0});  // an error of zero has no logarithm
  const ErrorCurve curve = fitted("line", points);
  EXPECT_EQ(curve.points.size(), 3u);
  EXPECT_NEAR(curve.slope, -0.75, 1e-12);
  EXPECT_NEAR(curve.fitted(500.0), 3.0 * std::pow(500.0, -0.75), 1e-12);
  EXPECT_EQ(fitted("point", {{10.0, 1.0}}).slope, 0.0);
}

TEST(PlotSvg, HasAMarkForEachErrorAndTheSlopesInItsLegend) {
  const ErrorCurve curve = fitted("a < b", {{10.0, 1.0}, {100.0, 0.1}, {1000.0, 0.01}});
  const std::string svg = plotSvg({{"title", "sub & title", {curve}}});
  EXPECT_TRUE(svg.starts_with("<svg "));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_NE(svg.find("a &lt; b: N^-1.00"), std::string::npos);
  EXPECT_NE(svg.find("sub &amp; title"), std::string::npos);
  std::size_t marks = 0;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at + 1)) ++marks;
  EXPECT_EQ(marks, 4u) << "three errors and the legend";
  EXPECT_NE(plotSvg({{"empty", "", {}}}).find("</svg>"), std::string::npos);
}

TEST(DirectionsSvg, HasThreeGlobesOfPoints) {
  const std::string svg = directionsSvg(64, 1);
  std::size_t circles = 0;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at + 1)) ++circles;
  EXPECT_EQ(circles, 3u * (64 + 1));
  EXPECT_NE(directionsSvg(64, 2), svg);
}

TEST(Report, TellsEstimateIntervalExactValueAndFigure) {
  const Programme& programme = *findProgramme("pi");
  const std::string text = reportText({&programme, programme.run({.samples = 65536})});
  for (const char* part : {"pi: ", "4.0.2, section 2.1", "estimate 3.1", "95 % [3.1", "exact    3.14159265", "= pi",
                           "printed  3.14376", "0.4 standard errors of its 100000 samples", "inside of their 95 %"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
}

}  // namespace
}  // namespace steradian::montecarlo

#pragma once
/// A programme of `steradian-montecarlo`: a table entry that runs and can be plotted.
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "steradian/core/sampling/estimate.h"

namespace steradian::montecarlo {

struct RunSettings {
  std::uint32_t samples = 1u << 20;
  std::uint32_t seed = 0;
  SamplerType sampler = SamplerType::Independent;  ///< for programmes that let the user choose
};

/// A number printed in a book, and what a run like the book's should give.
struct BookFigure {
  std::string where;  ///< edition and section
  double printed = 0.0;
  double lastDigit = 0.0;      ///< one unit of the last digit that is printed
  double samples = 0.0;        ///< of the book's run
  double standardError = 0.0;  ///< of a run of that many samples, known exactly

  /// Distance from `exact` in standard errors of the book's own run. Rounding to the last digit counts for nothing.
  double deviation(double exact) const;
  /// |deviation| > 1.96, as in one of 20 runs by chance.
  bool outside(double exact) const;
};

struct Result {
  std::string label{};  ///< what is estimated, where a programme estimates several things
  Estimate estimate{};
  Interval interval{};
  double exact = 0.0;        ///< by quadrature
  std::string closedForm{};  ///< "pi / 2", or empty
  std::optional<double> exactVariance = std::nullopt;
  std::vector<BookFigure> book{};
  std::string remark{};
};

/// What an error curve is made of: independent estimates of given numbers of samples.
struct Series {
  std::string name;
  std::vector<std::uint32_t> sizes;
  std::function<double(std::uint32_t samples, std::uint32_t stream)> estimate;
  double exact = 0.0;
};

struct Programme {
  std::string name, section, summary;
  std::vector<std::string> notes{};  ///< errata, and remarks on the result
  std::function<std::vector<Result>(const RunSettings&)> run{};
  std::function<std::vector<Series>(std::uint32_t seed)> series{};  ///< empty: there is nothing to plot
};

using Integrand = std::function<double(const Sampler<float>&)>;

/// A programme that is one mean.
struct Integral {
  Integrand integrand;
  double exact = 0.0;
  std::string closedForm{};
  std::optional<double> variance = std::nullopt;  ///< exact, of one independent sample
  std::vector<BookFigure> book{};
};

/// One coordinate, uniform in [low, high].
double uniform(const Sampler<float>& point, double low, double high);

Result resultOf(const Integral& integral, const RunSettings& settings);
/// Error curves with independent, stratified and Sobol' points.
std::vector<Series> seriesOf(const Integral& integral, std::uint32_t seed);
Programme programmeOf(std::string name, std::string section, std::string summary, Integral integral,
                      std::vector<std::string> notes = {});

/// The estimate `whole` with the spread of independent estimates of its parts, which are equally large.
Estimate withSpreadOf(double whole, const std::vector<double>& parts, std::uint64_t samples);

/// All of them, in the books' order.
const std::vector<Programme>& programmes();
/// nullptr if there is none of that name.
const Programme* findProgramme(std::string_view name);

}  // namespace steradian::montecarlo

#include "steradian/apps/montecarlo/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace steradian::montecarlo {

namespace {

constexpr std::size_t kWidth = 110;

/// Words in lines of at most kWidth, all but the first indented.
std::string wrapped(const std::string& first, std::string_view words, std::size_t indent) {
  std::string text = first;
  std::size_t used = first.size();
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (used + end > kWidth) {
      text.back() = '\n';
      text += std::string(indent, ' ');
      used = indent;
    }
    text.append(words.substr(0, end)).append(" ");
    used += end + 1;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  text.back() = '\n';
  return text;
}

std::string intervalText(const Interval& interval) {
  if (std::isinf(interval.low)) return "[any number]";
  return fmt::format("[{:.6g}, {:.6g}]", interval.low, interval.high);
}

std::string exactText(const Result& result) {
  const double value = std::abs(result.exact) < 1e-12 ? 0.0 : result.exact;
  return fmt::format("{:.10g}{}", value, result.closedForm.empty() ? "" : " = " + result.closedForm);
}

std::string varianceText(const Result& result) {
  std::string text = fmt::format("{:.4g}", result.estimate.variance);
  if (result.exactVariance) text += fmt::format(" (exact {:.4g})", *result.exactVariance);
  return text;
}

std::string figureText(const Result& result, const BookFigure& figure) {
  const double deviation = figure.deviation(result.exact);
  std::string text =
      fmt::format("{:.13g} ({}), {:.2g} off: {:.1f} standard errors of its {:.0f} samples, {}", figure.printed,
                  figure.where, figure.printed - result.exact, std::abs(deviation), figure.samples,
                  figure.outside(result.exact) ? "OUTSIDE of their 95 %" : "inside of their 95 %");
  text += result.interval.contains(figure.printed) ? "; inside of our interval" : "; outside of our interval";
  return text;
}

std::string resultText(const Result& result, bool labelled) {
  std::string text;
  if (labelled) {
    text += fmt::format("  {:<20} {:<11.7g} 95 % {:<24} exact {}, variance {}\n", result.label, result.estimate.mean,
                        intervalText(result.interval), exactText(result), varianceText(result));
    if (!result.remark.empty()) text += wrapped(std::string(23, ' '), result.remark, 23);
  } else {
    text += fmt::format("  estimate {:.7g}, 95 % {}, variance {}, {} samples\n", result.estimate.mean,
                        intervalText(result.interval), varianceText(result), result.estimate.count);
    text += fmt::format("  exact    {}\n", exactText(result));
  }
  for (const BookFigure& figure : result.book) text += wrapped("  printed  ", figureText(result, figure), 11);
  return text;
}

nlohmann::json numberOrNull(double x) { return std::isfinite(x) ? nlohmann::json(x) : nlohmann::json(nullptr); }

nlohmann::json toJson(const Result& result) {
  nlohmann::json json{{"label", result.label},
                      {"estimate", result.estimate.mean},
                      {"samples", result.estimate.count},
                      {"standard_error", numberOrNull(result.estimate.standardError)},
                      {"interval", {numberOrNull(result.interval.low), numberOrNull(result.interval.high)}},
                      {"variance", result.estimate.variance},
                      {"exact", result.exact},
                      {"closed_form", result.closedForm},
                      {"remark", result.remark},
                      {"book", nlohmann::json::array()}};
  if (result.exactVariance) json["exact_variance"] = *result.exactVariance;
  for (const BookFigure& figure : result.book)
    json["book"].push_back({{"where", figure.where},
                            {"printed", figure.printed},
                            {"samples", figure.samples},
                            {"standard_error", figure.standardError},
                            {"deviation", figure.deviation(result.exact)},
                            {"outside", figure.outside(result.exact)},
                            {"in_our_interval", result.interval.contains(figure.printed)}});
  return json;
}

}  // namespace

std::string reportText(const Outcome& outcome) {
  const Programme& programme = *outcome.programme;
  std::string text = wrapped(programme.name + ": ", programme.summary + " (" + programme.section + ")", 2);
  const bool labelled = outcome.results.size() > 1;
  for (const Result& result : outcome.results) text += resultText(result, labelled);
  for (const std::string& note : programme.notes) text += wrapped("  note     ", note, 11);
  return text;
}

std::string reportJson(const std::vector<Outcome>& outcomes, const RunSettings& settings) {
  nlohmann::json list = nlohmann::json::array();
  for (const Outcome& outcome : outcomes) {
    const Programme& programme = *outcome.programme;
    nlohmann::json results = nlohmann::json::array();
    for (const Result& result : outcome.results) results.push_back(toJson(result));
    list.push_back({{"name", programme.name},
                    {"section", programme.section},
                    {"summary", programme.summary},
                    {"seed", settings.seed},
                    {"sampler", nameOf(settings.sampler)},
                    {"results", std::move(results)},
                    {"notes", programme.notes}});
  }
  return list.dump(2) + "\n";
}

}  // namespace steradian::montecarlo

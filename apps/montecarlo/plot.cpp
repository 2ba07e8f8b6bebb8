#include "steradian/apps/montecarlo/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "steradian/apps/montecarlo/svg.h"

namespace steradian::montecarlo {

namespace {

constexpr double kPanelWidth = 470.0, kPanelHeight = 380.0;
constexpr double kLeft = 64.0, kRight = 16.0, kTop = 50.0, kBottom = 48.0;
/// Okabe & Ito's colours, which the colour-blind can tell apart.
constexpr std::array<const char*, 6> kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#000000", "#e69f00"};

/// A logarithmic axis from one pixel to another.
struct Axis {
  double low, high;      ///< log10 of the values at its ends
  double first, second;  ///< pixels there

  double operator()(double value) const { return first + (std::log10(value) - low) / (high - low) * (second - first); }
  bool holds(double value) const { return std::log10(value) >= low - 1e-9 && std::log10(value) <= high + 1e-9; }
};

/// The axes of the panel whose upper left corner is (x, y).
struct Frame {
  Axis samples, error;
  double left, right, top, bottom;
};

Frame frameOf(const Panel& panel, double x, double y) {
  double minSamples = 1e300, maxSamples = 1.0, smallest = 1e300, largest = 1e-300;
  for (const ErrorCurve& curve : panel.curves) {
    for (const ErrorPoint& p : curve.points) {
      minSamples = std::min(minSamples, p.samples);
      maxSamples = std::max(maxSamples, p.samples);
      smallest = std::min(smallest, p.error);
      largest = std::max(largest, p.error);
    }
  }
  if (minSamples > maxSamples) minSamples = maxSamples = smallest = largest = 1.0;  // no points at all
  const double left = x + kLeft, right = x + kPanelWidth - kRight, top = y + kTop, bottom = y + kPanelHeight - kBottom;
  const Axis samples{std::log10(minSamples) - 0.2, std::log10(maxSamples) + 0.2, left, right};
  // Whole decades, and room for the legend below the curves.
  const Axis error{std::floor(std::log10(smallest)), std::floor(std::log10(largest)) + 1.0, bottom, top};
  return {samples, error, left, right, top, bottom};
}

/// Grid lines and labels at powers of ten, small ticks at the other multiples.
void drawAxes(Svg& svg, const Frame& f) {
  const auto eachTick = [](const Axis& axis, auto&& draw) {
    for (int exponent = static_cast<int>(std::floor(axis.low)); exponent <= static_cast<int>(axis.high); ++exponent) {
      for (int digit = 1; digit < 10; ++digit) {
        const double value = digit * std::pow(10.0, exponent);
        if (axis.holds(value)) draw(axis(value), exponent, digit == 1);
      }
    }
  };
  const char* grid = "stroke=\"#dddddd\"";
  const char* tick = "stroke=\"#555555\"";
  eachTick(f.samples, [&](double x, int exponent, bool whole) {
    if (whole) svg.line(x, f.top, x, f.bottom, grid);
    if (whole) svg.powerOfTen(x, f.bottom + 18.0, 12.0, "middle", exponent);
    svg.line(x, f.bottom, x, f.bottom - (whole ? 6.0 : 3.0), tick);
  });
  eachTick(f.error, [&](double y, int exponent, bool whole) {
    if (whole) svg.line(f.left, y, f.right, y, grid);
    if (whole) svg.powerOfTen(f.left - 7.0, y + 4.0, 12.0, "end", exponent);
    svg.line(f.left, y, f.left + (whole ? 6.0 : 3.0), y, tick);
  });
  svg.path(fmt::format("M{:.2f} {:.2f}V{:.2f}H{:.2f}", f.left, f.top, f.bottom, f.right),
           "fill=\"none\" stroke=\"#555555\"");
  svg.text(0.5 * (f.left + f.right), f.bottom + 38.0, 12.0, "middle", "samples N");
  const double x = f.left - 46.0, y = 0.5 * (f.top + f.bottom);
  svg.text(x, y, 12.0, "middle", "error (rms of 64 runs)",
           fmt::format("transform=\"rotate(-90 {:.2f} {:.2f})\"", x, y));
}

/// Disk, square, diamond, triangle, hollow disk, in turn.
void drawMark(Svg& svg, std::size_t index, double x, double y) {
  const std::string fill = fmt::format("fill=\"{}\"", kColours[index % kColours.size()]);
  switch (index % 5) {
    case 0:
      return svg.circle(x, y, 4.0, fill);
    case 1:
      return svg.path(fmt::format("M{:.2f} {:.2f}h7v7h-7z", x - 3.5, y - 3.5), fill);
    case 2:
      return svg.path(fmt::format("M{:.2f} {:.2f}l4.5 4.5l-4.5 4.5l-4.5 -4.5z", x, y - 4.5), fill);
    case 3:
      return svg.path(fmt::format("M{:.2f} {:.2f}l4.5 8h-9z", x, y - 5.0), fill);
    default:
      return svg.circle(
          x, y, 3.5,
          fmt::format("fill=\"white\" stroke-width=\"1.8\" stroke=\"{}\"", kColours[index % kColours.size()]));
  }
}

void drawCurve(Svg& svg, const Frame& f, std::size_t index, const ErrorCurve& curve) {
  if (curve.points.size() > 1) {
    const double first = curve.points.front().samples, last = curve.points.back().samples;
    svg.line(
        f.samples(first), f.error(curve.fitted(first)), f.samples(last), f.error(curve.fitted(last)),
        fmt::format("stroke=\"{}\" stroke-width=\"1.3\" stroke-dasharray=\"5 3\"", kColours[index % kColours.size()]));
  }
  for (const ErrorPoint& p : curve.points) drawMark(svg, index, f.samples(p.samples), f.error(p.error));
}

/// In the lower left corner: errors fall, so no curve comes there.
void drawLegend(Svg& svg, const Frame& f, const std::vector<ErrorCurve>& curves) {
  double y = f.bottom - 16.0 - 18.0 * (static_cast<double>(curves.size()) - 1.0);
  for (std::size_t i = 0; i < curves.size(); ++i, y += 18.0) {
    drawMark(svg, i, f.left + 20.0, y);
    svg.text(f.left + 32.0, y + 4.0, 12.0, "start", fmt::format("{}: N^{:.2f}", curves[i].name, curves[i].slope),
             "paint-order=\"stroke\" stroke=\"white\" stroke-width=\"4\" stroke-linejoin=\"round\"");
  }
}

void drawPanel(Svg& svg, const Panel& panel, double x, double y) {
  const Frame frame = frameOf(panel, x, y);
  svg.text(frame.left, y + 22.0, 14.0, "start", panel.title, "font-weight=\"bold\"");
  svg.text(frame.left, y + 38.0, 10.5, "start", panel.subtitle, "fill=\"#444444\"");
  drawAxes(svg, frame);
  for (std::size_t i = 0; i < panel.curves.size(); ++i) drawCurve(svg, frame, i, panel.curves[i]);
  drawLegend(svg, frame, panel.curves);
}

}  // namespace

std::string plotSvg(const std::vector<Panel>& panels) {
  const std::size_t columns = std::clamp<std::size_t>(panels.size(), 1, 3),
                    rows = (panels.size() + columns - 1) / columns;
  Svg svg(kPanelWidth * static_cast<double>(columns), kPanelHeight * static_cast<double>(rows));
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::size_t column = i % columns, row = i / columns;
    drawPanel(svg, panels[i], kPanelWidth * static_cast<double>(column), kPanelHeight * static_cast<double>(row));
  }
  return svg.finish();
}

}  // namespace steradian::montecarlo

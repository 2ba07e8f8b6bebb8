#include "steradian/apps/montecarlo/svg.h"

#include <fmt/format.h>

namespace steradian::montecarlo {

Svg::Svg(double width, double height)
    : body_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
                        "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\">\n"
                        "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
                        width, height)) {}

void Svg::line(double x0, double y0, double x1, double y1, std::string_view style) {
  body_ += fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}/>\n", x0, y0, x1, y1, style);
}

void Svg::circle(double x, double y, double radius, std::string_view style) {
  body_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" {}/>\n", x, y, radius, style);
}

void Svg::path(std::string_view d, std::string_view style) { body_ += fmt::format("<path d=\"{}\" {}/>\n", d, style); }

void Svg::text(double x, double y, double size, std::string_view anchor, std::string_view words,
               std::string_view extra) {
  body_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{}\" text-anchor=\"{}\" {}>{}</text>\n", x, y, size,
                       anchor, extra, escaped(words));
}

void Svg::powerOfTen(double x, double y, double size, std::string_view anchor, int exponent) {
  body_ += fmt::format(
      "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{}\" text-anchor=\"{}\">10<tspan dy=\"{:.1f}\" "
      "font-size=\"{:.1f}\">{}</tspan></text>\n",
      x, y, size, anchor, -0.4 * size, 0.75 * size, exponent);
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace steradian::montecarlo

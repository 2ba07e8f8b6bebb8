#pragma once
/// Pictures as SVG text.
#include <string>
#include <string_view>

namespace steradian::montecarlo {

/// An SVG picture that grows by one element at a time. Coordinates are pixels, y downwards.
class Svg {
 public:
  Svg(double width, double height);

  void line(double x0, double y0, double x1, double y1, std::string_view style);
  void circle(double x, double y, double radius, std::string_view style);
  /// `d` is the path in SVG's own words.
  void path(std::string_view d, std::string_view style);
  /// `anchor`: start, middle or end. `extra` are further attributes.
  void text(double x, double y, double size, std::string_view anchor, std::string_view words,
            std::string_view extra = {});
  /// 10^exponent, in the same way.
  void powerOfTen(double x, double y, double size, std::string_view anchor, int exponent);

  /// The whole picture.
  std::string finish() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

/// The text with what has a meaning in XML replaced.
std::string escaped(std::string_view text);

}  // namespace steradian::montecarlo

#include "steradian/apps/steradian/reference.h"

#include <cmath>

#include "steradian/core/image/image_metrics.h"

namespace steradian::app {

Reference::Reference(const Image& a, const Image& b)
    : mean(a.width(), a.height(), {"R", "G", "B"}, a.window()),
      standardError(a.width(), a.height(), {"R", "G", "B"}, a.window()) {
  for (const char* name : {"R", "G", "B"}) {
    const int to = mean.channel(name), fromA = a.channel(name), fromB = b.channel(name);
    for (int y = 0; y < a.height(); ++y) {
      for (int x = 0; x < a.width(); ++x) {
        const float p = a.at(x, y, fromA), q = b.at(x, y, fromB);
        mean.at(x, y, to) = 0.5f * (p + q);
        standardError.at(x, y, to) = 0.5f * std::abs(p - q);
      }
    }
  }
}

double Reference::relMseOf(const Image& picture) const { return relMSE(picture, mean, &standardError); }

}  // namespace steradian::app

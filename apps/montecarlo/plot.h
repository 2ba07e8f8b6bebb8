#pragma once
/// Error against the number of samples, as a picture.
#include <string>
#include <vector>

#include "steradian/apps/montecarlo/error_study.h"

namespace steradian::montecarlo {

struct Panel {
  std::string title, subtitle;
  std::vector<ErrorCurve> curves;
};

/// An SVG picture of the panels, up to three side by side: both axes logarithmic, a mark for each size, the fitted line
/// dashed, and the fitted slopes in the legend.
std::string plotSvg(const std::vector<Panel>& panels);

}  // namespace steradian::montecarlo

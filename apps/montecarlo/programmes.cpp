#include "steradian/apps/montecarlo/programmes.h"

#include <algorithm>

namespace steradian::montecarlo {

const std::vector<Programme>& programmes() {
  static const std::vector<Programme> all = [] {
    std::vector<Programme> list;
    for (const auto& subject : {piProgrammes, stratificationProgrammes, integralProgrammes, halfwayProgrammes,
                                importanceProgrammes, directionProgrammes}) {
      std::ranges::move(subject(), std::back_inserter(list));
    }
    return list;
  }();
  return all;
}

const Programme* findProgramme(std::string_view name) {
  const auto found = std::ranges::find(programmes(), name, &Programme::name);
  return found == programmes().end() ? nullptr : &*found;
}

}  // namespace steradian::montecarlo

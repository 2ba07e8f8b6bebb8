#pragma once
/// The programmes by subject, one source file each.
#include "steradian/apps/montecarlo/programme.h"

namespace steradian::montecarlo {

std::vector<Programme> piProgrammes();              ///< 4.0.2, chapter 2
std::vector<Programme> stratificationProgrammes();  ///< 4.0.2, section 2.3
std::vector<Programme> integralProgrammes();        ///< 4.0.2, section 3.2
std::vector<Programme> halfwayProgrammes();         ///< 4.0.2, section 3.5
std::vector<Programme> importanceProgrammes();      ///< 4.0.2, sections 3.5 to 3.7
std::vector<Programme> directionProgrammes();       ///< 4.0.2, chapters 4, 7 and 12

}  // namespace steradian::montecarlo

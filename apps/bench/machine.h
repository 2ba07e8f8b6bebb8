#pragma once
/// The machine that figures were measured on.
#include <string>

namespace steradian::bench {

/// One line: processor, processors that this process may use, widest vectors of the build, compiler, load.
std::string machineLine();

/// Runnable processes, averaged over the last minute; negative where unknown. Figures are reliable below about 1.
double systemLoad();

}  // namespace steradian::bench

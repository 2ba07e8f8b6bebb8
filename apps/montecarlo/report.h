#pragma once
/// The results of the programmes, as text and as JSON.
#include <string>

#include "steradian/apps/montecarlo/programme.h"

namespace steradian::montecarlo {

struct Outcome {
  const Programme* programme = nullptr;
  std::vector<Result> results;
};

/// Several lines, with a newline at the end.
std::string reportText(const Outcome& outcome);
/// A JSON array with one object per programme, with a newline at the end.
std::string reportJson(const std::vector<Outcome>& outcomes, const RunSettings& settings);

}  // namespace steradian::montecarlo

#pragma once

#include <string>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// The OpenColorIO configuration that Steradian brings with it, as the text of an .ocio file: reference space linear
/// Rec.709/D65, one display "sRGB" with the views "sRGB", "ACES SDR", "Book" and "Raw", and both interchange roles.
/// It consists of transforms built into OpenColorIO >= 2.1 and needs no other file.
const std::string& displayConfigText();

}  // namespace steradian

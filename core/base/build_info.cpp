#include "steradian/core/base/build_info.h"

#include <OpenColorIO/OpenColorIO.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <tbb/version.h>

namespace steradian {

std::string compilerVersion() {
#if defined(__clang__)
  return "clang++ " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

std::vector<LibraryVersion> libraryVersions() {
  const int images = OIIO::openimageio_version();  // 20407: 2.4.7
  return {{"OpenImageIO", fmt::format("{}.{}.{}", images / 10000, images / 100 % 100, images % 100)},
          {"OpenColorIO", OCIO_NAMESPACE::GetVersion()},
          {"oneTBB", TBB_runtime_version()}};
}

}  // namespace steradian

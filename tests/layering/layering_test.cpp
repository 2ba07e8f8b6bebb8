#include "steradian/tests/layering/layering.h"

#include <gtest/gtest.h>

#include <fstream>

namespace steradian::layering {
namespace {

namespace fs = std::filesystem;

// A made-up source tree that disappears with the test.
class Layering : public testing::Test {
 protected:
  Layering() : root_(fs::path(testing::TempDir()) / ("steradian-layering-" + std::string(name()))) {
    fs::remove_all(root_);
    write("core/ray.h", "#pragma once\n#include <cmath>\n");
    write("accel/shapes/quad.h", "#pragma once\n#include \"steradian/core/ray.h\"\n");
    write("accel/embree_scene.cpp", "#include <embree3/rtcore.h>\n#include \"steradian/accel/shapes/quad.h\"\n");
    write("materials/lambert.h", "#pragma once\n#include \"steradian/core/ray.h\"\n");
    write("lights/light.h", "#pragma once\n#include \"steradian/materials/lambert.h\"\n");
  }
  ~Layering() override {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }

  void write(const std::string& path, const std::string& text) {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }

  std::vector<std::string> violations() const { return inspect(root_).violations; }

  using Lines = std::vector<std::string>;

 private:
  static const char* name() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }
  fs::path root_;
};

TEST_F(Layering, AcceptsAProperTree) { EXPECT_EQ(violations(), Lines{}); }

TEST_F(Layering, RejectsDependenciesThatPointBackwards) {
  write("core/a.h", "#pragma once\n\n#include \"steradian/materials/lambert.h\"\n");
  write("materials/b.cpp", "#  include \"steradian/accel/shapes/quad.h\"\n");
  write("accel/shapes/c.cpp", "#include \"steradian/accel/embree_scene.cpp\"\n");
  write("accel/d.cpp", "#include \"steradian/lights/light.h\"\n");
  EXPECT_EQ(violations(), (Lines{"accel/d.cpp:1: accel/ may not know lights/light.h",
                                 "accel/shapes/c.cpp:1: accel/shapes/ may not know accel/embree_scene.cpp",
                                 "core/a.h:3: core/ may not know materials/lambert.h",
                                 "materials/b.cpp:1: materials/ may not know accel/shapes/quad.h"}));
}

TEST_F(Layering, RejectsEverythingThatIncludesTests) {
  write("tests/support/z.h", "#pragma once\n");
  write("apps/main.cpp", "#include \"steradian/tests/support/z.h\"\n");
  EXPECT_EQ(violations(), Lines{"apps/main.cpp:1: apps/ may not know tests/support/z.h"});
}

TEST_F(Layering, RejectsIncludesThatUsersCannotWrite) {
  write("core/a.cpp", "#include \"ray.h\"\n#include <steradian/core/ray.h>\n#include \"steradian/core/gone.h\"\n");
  EXPECT_EQ(violations(), (Lines{"core/a.cpp:1: \"ray.h\" is not written as \"steradian/...\"",
                                 "core/a.cpp:2: <steradian/core/ray.h>: our own includes stand in quotes",
                                 "core/a.cpp:3: core/gone.h does not exist"}));
}

TEST_F(Layering, KeepsEmbreeAndSimdWhereTheyBelong) {
  write("accel/other.cpp", "#include <embree4/rtcore.h>\n");
  write("accel/shapes/leaf.cpp", "#include <immintrin.h>\ntypedef float v4 __attribute__((vector_size(16)));\n");
  write("core/lanes.h", "#pragma once\n#include <immintrin.h>\n__m256 lanes;\n");
  write("core/words.cpp", "// a comment may speak of vector_size\n");
  write("accel/embree_api.h", "#pragma once\n#include <embree4/rtcore.h>\n");
  write("accel/geometry.cpp", "#include \"steradian/accel/embree_api.h\"\n");
  write("tests/accel/geometry_test.cpp", "#include \"steradian/accel/embree_api.h\"\n");
  write("accel/geometry.h", "#pragma once\n#include \"steradian/accel/embree_api.h\"\n");
  EXPECT_EQ(violations(),
            (Lines{"accel/geometry.h:2: only sources of accel and its tests may include accel/embree_api.h",
                   "accel/other.cpp:1: only accel/embree_* may include embree4/rtcore.h",
                   "accel/shapes/leaf.cpp:1: only core/lanes* may use SIMD directly: immintrin.h",
                   "accel/shapes/leaf.cpp:2: only core/lanes* may use SIMD directly: typedef float v4 "
                   "__attribute__((vector_size(16)));"}));
}

TEST_F(Layering, KeepsPrivateLibrariesOutOfPublicHeaders) {
  write("core/image.cpp", "#include <OpenImageIO/imageio.h>\n");
  write("core/image.h", "#pragma once\n#include <OpenImageIO/imageio.h>\n");
  EXPECT_EQ(violations(), Lines{"core/image.h:2: a public header may not include OpenImageIO/imageio.h"});
}

TEST_F(Layering, RejectsLongFilesAndUnguardedHeaders) {
  std::string lines;
  for (int i = 0; i < 451; ++i) lines += "\n";
  write("core/long.cpp", lines);
  write("core/open.h", "int twice();\n");
  EXPECT_EQ(violations(), (Lines{"core/long.cpp:451: longer than 450 lines: split it",
                                 "core/open.h:1: a header without #pragma once"}));
}

TEST(LayeringOfThisProject, HoldsEverywhere) {
  const Findings findings = inspect(STERADIAN_SOURCE_DIR);
  for (const std::string& violation : findings.violations) ADD_FAILURE() << violation;
  // The look itself must have taken place.
  EXPECT_GE(findings.files, 3);
  EXPECT_GE(findings.includes, 10);
}

}  // namespace
}  // namespace steradian::layering

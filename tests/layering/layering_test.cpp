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
    write("core/math/ray.h", "#pragma once\n#include <cmath>\n");
    write("accel/shapes/primitives/quad.h", "#pragma once\n#include \"steradian/core/math/ray.h\"\n");
    write("accel/embree_scene.cpp",
          "#include <embree3/rtcore.h>\n#include \"steradian/accel/shapes/primitives/quad.h\"\n");
    write("materials/lambert.h", "#pragma once\n#include \"steradian/core/math/ray.h\"\n");
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
  write("core/base/a.h", "#pragma once\n\n#include \"steradian/materials/lambert.h\"\n");
  write("materials/b.cpp", "#  include \"steradian/accel/shapes/primitives/quad.h\"\n");
  write("accel/shapes/clusters/c.cpp", "#include \"steradian/accel/embree_scene.cpp\"\n");
  write("accel/d.cpp", "#include \"steradian/lights/light.h\"\n");
  EXPECT_EQ(
      violations(),
      (Lines{"accel/d.cpp:1: accel/ may not know lights/light.h",
             "accel/shapes/clusters/c.cpp:1: accel/shapes/clusters/ may not know accel/embree_scene.cpp: its sub-room "
             "comes later",
             "core/base/a.h:3: core/ may not know materials/lambert.h",
             "materials/b.cpp:1: materials/ may not know accel/shapes/primitives/quad.h"}));
}

TEST_F(Layering, RejectsIncludesOfLaterSubRooms) {
  write("core/film/film.h", "#pragma once\n");
  write("core/samplers/sobol.h", "#pragma once\n#include \"steradian/core/film/film.h\"\n");
  write("core/scene/camera.cpp", "#include \"steradian/core/film/film.h\"\n");  // later ones may include earlier ones
  write("accel/shapes/primitives/disk.h", "#pragma once\n#include \"steradian/accel/shapes/clusters/leaf.h\"\n");
  write("accel/shapes/clusters/leaf.h", "#pragma once\n");
  write("integrators/path/path.h", "#pragma once\n#include \"steradian/integrators/registry.h\"\n");
  write("integrators/registry.h", "#pragma once\n#include \"steradian/integrators/scene/scene.h\"\n");
  write("integrators/scene/scene.h", "#pragma once\n");
  EXPECT_EQ(violations(),
            (Lines{"accel/shapes/primitives/disk.h:2: accel/shapes/primitives/ may not know "
                   "accel/shapes/clusters/leaf.h: its sub-room comes later",
                   "core/samplers/sobol.h:2: core/samplers/ may not know core/film/film.h: its sub-room comes later",
                   "integrators/path/path.h:2: integrators/path/ may not know integrators/registry.h: its sub-room "
                   "comes later"}));
}

TEST_F(Layering, RejectsFilesOutsideOfSubRooms) {
  write("core/drawer.h", "#pragma once\n");
  write("core/drawer/thing.h", "#pragma once\n");
  write("accel/shapes/thing.h", "#pragma once\n");
  write("accel/geometry.h", "#pragma once\n");
  EXPECT_EQ(violations(), (Lines{"accel/shapes/thing.h:1: lies in no sub-room of accel/",
                                 "core/drawer.h:1: lies in no sub-room of core/",
                                 "core/drawer/thing.h:1: lies in no sub-room of core/"}));
}

TEST_F(Layering, RejectsEverythingThatIncludesTests) {
  write("tests/support/z.h", "#pragma once\n");
  write("apps/main.cpp", "#include \"steradian/tests/support/z.h\"\n");
  EXPECT_EQ(violations(), Lines{"apps/main.cpp:1: apps/ may not know tests/support/z.h"});
}

TEST_F(Layering, RejectsIncludesThatUsersCannotWrite) {
  write("core/scene/a.cpp",
        "#include \"ray.h\"\n#include <steradian/core/math/ray.h>\n#include \"steradian/core/scene/gone.h\"\n");
  EXPECT_EQ(violations(), (Lines{"core/scene/a.cpp:1: \"ray.h\" is not written as \"steradian/...\"",
                                 "core/scene/a.cpp:2: <steradian/core/math/ray.h>: our own includes stand in quotes",
                                 "core/scene/a.cpp:3: core/scene/gone.h does not exist"}));
}

TEST_F(Layering, KeepsEmbreeAndSimdWhereTheyBelong) {
  write("accel/other.cpp", "#include <embree4/rtcore.h>\n");
  write("accel/shapes/clusters/leaf.cpp",
        "#include <immintrin.h>\ntypedef float v4 __attribute__((vector_size(16)));\n");
  write("core/math/lanes.h", "#pragma once\n#include <immintrin.h>\n__m256 lanes;\n");
  write("core/base/words.cpp", "// a comment may speak of vector_size\n");
  write("accel/embree_api.h", "#pragma once\n#include <embree4/rtcore.h>\n");
  write("accel/geometry.cpp", "#include \"steradian/accel/embree_api.h\"\n");
  write("tests/accel/geometry_test.cpp", "#include \"steradian/accel/embree_api.h\"\n");
  write("accel/geometry.h", "#pragma once\n#include \"steradian/accel/embree_api.h\"\n");
  EXPECT_EQ(violations(),
            (Lines{"accel/geometry.h:2: only sources of accel and its tests may include accel/embree_api.h",
                   "accel/other.cpp:1: only accel/embree_* may include embree4/rtcore.h",
                   "accel/shapes/clusters/leaf.cpp:1: only core/math/lanes* may use SIMD directly: immintrin.h",
                   "accel/shapes/clusters/leaf.cpp:2: only core/math/lanes* may use SIMD directly: typedef float v4 "
                   "__attribute__((vector_size(16)));"}));
}

TEST_F(Layering, KeepsOneTbbInOneHeader) {
  write("core/base/parallel.h", "#pragma once\n#include <tbb/parallel_for.h>\n");
  write("core/base/build_info.cpp", "#include <tbb/version.h>\n");
  write("apps/main.cpp", "#include <tbb/task_arena.h>\n");
  write("lights/loop.cpp", "#include <tbb/parallel_for.h>\n");
  EXPECT_EQ(violations(), Lines{"lights/loop.cpp:1: only core/base/parallel.h may include tbb/parallel_for.h"});
}

TEST_F(Layering, KeepsPrivateLibrariesOutOfPublicHeaders) {
  write("core/image/image.cpp", "#include <OpenImageIO/imageio.h>\n");
  write("core/image/image.h", "#pragma once\n#include <OpenImageIO/imageio.h>\n");
  EXPECT_EQ(violations(), Lines{"core/image/image.h:2: a public header may not include OpenImageIO/imageio.h"});
}

TEST_F(Layering, RejectsInterfacesThatASharedLibraryHides) {
  write("lights/a.h", "#pragma once\nnamespace STERADIAN_API steradian {\n}\n");
  write("lights/b.h", "#pragma once\nnamespace steradian {\n}\n");
  write("lights/c.h", "#pragma once\nnamespace steradian::detail {\n}\n");
  write("lights/c.cpp", "namespace steradian {\n}\n");
  write("lights/light_kernels.h", "#pragma once\nnamespace steradian {\n}\n");
  write("accel/embree_tree.h", "#pragma once\nnamespace steradian {\n}\n");
  EXPECT_EQ(violations(), (Lines{"lights/b.h:2: an installed header opens its namespace with STERADIAN_API",
                                 "lights/c.h:2: an installed header opens its namespace with STERADIAN_API"}));
}

TEST_F(Layering, RejectsLongFilesAndUnguardedHeaders) {
  std::string lines;
  for (int i = 0; i < 451; ++i) lines += "\n";
  write("core/base/long.cpp", lines);
  write("core/base/open.h", "int twice();\n");
  EXPECT_EQ(violations(), (Lines{"core/base/long.cpp:451: longer than 450 lines: split it",
                                 "core/base/open.h:1: a header without #pragma once"}));
}

TEST(LayeringOfThisProject, HoldsEverywhere) {
  const Findings findings = inspect(STERADIAN_SOURCE_DIR);
  for (const std::string& violation : findings.violations) ADD_FAILURE() << violation;
  // The inspection must have happened.
  EXPECT_GE(findings.files, 3);
  EXPECT_GE(findings.includes, 10);
}

}  // namespace
}  // namespace steradian::layering

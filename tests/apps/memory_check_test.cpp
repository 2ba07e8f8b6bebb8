#include "steradian/apps/steradian/memory_check.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

#include "steradian/core/base/diagnostics.h"

namespace steradian::app {
namespace {

namespace fs = std::filesystem;
constexpr std::uint64_t kMiB = 1 << 20;

/// A system of files for `availableMemory`.
class Memory : public testing::Test {
 protected:
  Memory() {
    std::string name = (fs::temp_directory_path() / "steradian-memory-XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) root_ = name;
  }
  ~Memory() override { fs::remove_all(root_); }

  void write(const std::string& file, const std::string& text) {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  fs::path root_;
};

TEST_F(Memory, NothingKnown) { EXPECT_EQ(availableMemory(root_), std::numeric_limits<std::uint64_t>::max()); }

TEST_F(Memory, OfTheSystem) {
  write("proc/meminfo", "MemTotal:       8388608 kB\nMemFree:        1 kB\nMemAvailable:   4096 kB\nBuffers: 2 kB\n");
  EXPECT_EQ(availableMemory(root_), 4 * kMiB);
}

TEST_F(Memory, OfTheControlGroupAndThoseAroundIt) {
  write("proc/meminfo", "MemAvailable: 1048576 kB\n");
  write("proc/self/cgroup", "1:name=systemd:/x\n0::/outer/inner\n");
  write("sys/fs/cgroup/outer/inner/memory.max", "max\n");
  write("sys/fs/cgroup/outer/inner/memory.current", "1000\n");
  EXPECT_EQ(availableMemory(root_), 1024 * kMiB);
  write("sys/fs/cgroup/outer/memory.max", std::to_string(100 * kMiB) + "\n");
  write("sys/fs/cgroup/outer/memory.current", std::to_string(70 * kMiB) + "\n");
  EXPECT_EQ(availableMemory(root_), 30 * kMiB);
  write("sys/fs/cgroup/outer/memory.stat", "anon 5\nfile " + std::to_string(20 * kMiB) + "\nkernel 7\n");
  EXPECT_EQ(availableMemory(root_), 50 * kMiB) << "cached files are given up first";
}

TEST_F(Memory, RefusesWhatDoesNotFit) {
  EXPECT_NO_THROW(checkMemory(600, 600, 1, 1024 * kMiB));
  try {
    checkMemory(65536, 4096, 1, 1024 * kMiB);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Memory);
    EXPECT_NE(std::string(error.what()).find("65536 x 4096"), std::string::npos) << error.what();
  }
}

TEST_F(Memory, RefusesScenesThatCannotBeBuilt) {
  SceneDescription scene;
  SphereSet spheres;
  for (int i = 0; i < 1000; ++i) spheres.add({static_cast<float>(i), 0.0f, 0.0f}, 0.5f);
  scene.addShape("spheres", spheres, kNone);
  EXPECT_NO_THROW(checkMemory(scene, kMiB));
  try {
    checkMemory(scene, 1000);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Memory);
    EXPECT_NE(std::string(error.what()).find("1000 primitives"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace steradian::app

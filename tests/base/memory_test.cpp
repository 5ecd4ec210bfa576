#include "limn/base/memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "support/temporary_folder.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

/// A root with the files that tell of memory.
class MemoryTest : public testing::Test {
 protected:
  void put(const std::string& name, const std::string& content) const {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << content;
  }
  [[nodiscard]] double available() const { return base::available_memory_of(root_.string()); }

 private:
  test::TemporaryFolder folder_;

 protected:
  const fs::path& root_ = folder_.path();
};

TEST_F(MemoryTest, NothingToldIsNoBound) {
  EXPECT_TRUE(std::isinf(available()));
  put("sys/fs/cgroup/memory.max", "max\n");
  put("proc/self/cgroup", "0::/\nnonsense\n");
  EXPECT_TRUE(std::isinf(available()));
}

TEST_F(MemoryTest, TheMachine) {
  put("proc/meminfo", "MemTotal:  9000 kB\nMemFree: 10 kB\nMemAvailable:   5000 kB\n");
  EXPECT_EQ(available(), 5000 * 1024);
}

TEST_F(MemoryTest, GroupsOfVersionTwoAndThoseAboveThem) {
  put("proc/meminfo", "MemAvailable: 5000 kB\n");
  put("proc/self/cgroup", "0::/slice/job\n");
  const std::string mount = "sys/fs/cgroup/";
  put(mount + "slice/job/memory.max", "max\n");
  put(mount + "slice/job/memory.current", "100\n");
  EXPECT_EQ(available(), 5000 * 1024);
  put(mount + "slice/memory.max", "3000\n");
  put(mount + "slice/memory.current", "1000\n");
  EXPECT_EQ(available(), 2000);
  put(mount + "slice/memory.stat", "anon 200\ninactive_file 500\nactive_file 300\n");
  EXPECT_EQ(available(), 2500);  // the kernel can drop its cache
  put(mount + "slice/job/memory.max", "50\n");
  EXPECT_EQ(available(), 0);  // and not below nothing
}

TEST_F(MemoryTest, GroupsOfVersionOne) {
  put("proc/self/cgroup", "5:cpu,cpuacct:/x\n4:memory:/of/outside\n0::/\n");
  const std::string mount = "sys/fs/cgroup/memory/";
  put(mount + "memory.limit_in_bytes", "8000\n");  // in a container: the path is of outside
  put(mount + "memory.usage_in_bytes", "3000\n");
  EXPECT_EQ(available(), 5000);
  put(mount + "of/memory.limit_in_bytes", "4000\n");
  put(mount + "of/memory.usage_in_bytes", "1000\n");
  put(mount + "of/memory.stat", "inactive_file 7\ntotal_inactive_file 10\n");
  EXPECT_EQ(available(), 3010);
}

TEST_F(MemoryTest, ThisProcessHasSome) {
  EXPECT_GT(base::available_memory(), 1e6);
  EXPECT_LE(base::available_memory(), base::available_memory_of(""));
}

TEST(MemoryText, HasUnits) {
  EXPECT_EQ(base::bytes_text(256.0 * 1024), "256 KiB");
  EXPECT_EQ(base::bytes_text(12.0 * 1024 * 1024), "12.0 MiB");
  EXPECT_EQ(base::bytes_text(1.5 * 1024 * 1024 * 1024), "1.5 GiB");
}

}  // namespace
}  // namespace limn

#include "base/process_limits.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <fstream>

namespace macula {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;

// A machine as /proc and /sys show it.
class ProcessLimits : public ::testing::Test {
  protected:
    ProcessLimits()
        : root_(fs::path(::testing::TempDir()) /
                ("limits_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()))) {
        fs::remove_all(root_);
        put("proc/meminfo", "MemTotal: 8388608 kB\nMemFree: 100 kB\nMemAvailable: 4194304 kB\n");
    }
    ~ProcessLimits() override { fs::remove_all(root_); }
    void put(const std::string& file, const std::string& text) const {
        fs::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file) << text;
    }

    fs::path root_;
};

TEST_F(ProcessLimits, WithoutGroupsMemoryIsThatOfTheMachine) {
    EXPECT_EQ(availableMemoryBytes(root_), 4096 * kMiB);
    EXPECT_FALSE(availableMemoryBytes(root_ / "nowhere"));
}

TEST_F(ProcessLimits, OfAGroupOfVersion2AndItsParents) {
    put("proc/self/cgroup", "0::/jobs/one\n");
    put("sys/fs/cgroup/jobs/one/memory.max", "max\n");
    put("sys/fs/cgroup/jobs/one/memory.current", "1048576\n");
    EXPECT_EQ(availableMemoryBytes(root_), 4096 * kMiB);
    // Of the parent's 512 MiB 300 are in use, 100 of them for cache that would go.
    put("sys/fs/cgroup/jobs/memory.max", std::to_string(512 * kMiB));
    put("sys/fs/cgroup/jobs/memory.current", std::to_string(300 * kMiB));
    put("sys/fs/cgroup/jobs/memory.stat", "anon 5\ninactive_file " + std::to_string(100 * kMiB) + "\n");
    EXPECT_EQ(availableMemoryBytes(root_), 312 * kMiB);
    put("sys/fs/cgroup/jobs/memory.current", std::to_string(700 * kMiB));
    EXPECT_EQ(availableMemoryBytes(root_), 0u);
}

// In a container the path is often that of the host, which is not there.
TEST_F(ProcessLimits, OfAGroupOfVersion1) {
    put("proc/self/cgroup", "5:cpu,cpuacct:/docker/x\n4:memory:/docker/x\n1:name=systemd:/\n");
    put("sys/fs/cgroup/memory/memory.limit_in_bytes", std::to_string(64 * kMiB));
    put("sys/fs/cgroup/memory/memory.usage_in_bytes", std::to_string(10 * kMiB));
    EXPECT_EQ(availableMemoryBytes(root_), 54 * kMiB);
    put("sys/fs/cgroup/cpu/cpu.cfs_quota_us", "50000\n");
    put("sys/fs/cgroup/cpu/cpu.cfs_period_us", "100000\n");
    EXPECT_EQ(usableProcessors(root_), 1u);
    put("sys/fs/cgroup/cpu/cpu.cfs_quota_us", "-1\n");
    EXPECT_EQ(usableProcessors(root_), usableProcessors(root_ / "nowhere"));
}

TEST_F(ProcessLimits, OfProcessorsInVersion2) {
    put("proc/self/cgroup", "0::/\n");
    put("sys/fs/cgroup/cpu.max", "max 100000\n");
    EXPECT_EQ(usableProcessors(root_), usableProcessors(root_ / "nowhere"));
    put("sys/fs/cgroup/cpu.max", "100000 100000\n");
    EXPECT_EQ(usableProcessors(root_), 1u);
}

TEST(ProcessAffinity, IsRespected) {
    cpu_set_t before;
    ASSERT_EQ(sched_getaffinity(0, sizeof(before), &before), 0);
    int one = 0;
    while (!CPU_ISSET(one, &before)) ++one;
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(one, &only);
    ASSERT_EQ(sched_setaffinity(0, sizeof(only), &only), 0);
    EXPECT_EQ(usableProcessors(), 1u);
    EXPECT_EQ(sched_setaffinity(0, sizeof(before), &before), 0);
}

}  // namespace
}  // namespace macula

// Compiled kernels that wait in a file for the next start.
#include "pipeline/gpu/pipeline_cache.h"

#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "base/atomic_file.h"
#include "gpu/gpu_test.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "shaders/test_gpu.h"

namespace macula::gpu {
namespace {

namespace fs = std::filesystem;

class PipelineCacheTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        folder_ = fs::path(::testing::TempDir()) / ("macula-kernels-" + std::to_string(getpid())) / "below";
        fs::remove_all(folder_.parent_path());
    }
    void TearDown() override {
        fs::remove_all(folder_.parent_path());
        GpuTest::TearDown();
    }
    std::shared_ptr<Device> keeping() {
        DeviceOptions options;
        options.kernelsFolder = folder_;
        options.isAnnounced = false;
        return expectOk(Device::create(*instance_, options));
    }
    // A device that compiles something, runs it, and goes.
    void useOne() {
        const std::shared_ptr<Device> device = keeping();
        constexpr std::uint32_t kCount = 64;
        const Kernel kernel = expectOk(Kernel::create(device, shaders::slow_comp));
        const Buffer source = expectOk(Buffer::create(device, {.label = "source", .bytes = kCount * 4}));
        const Buffer result = expectOk(Buffer::create(device, {.label = "result", .bytes = kCount * 4}));
        auto recorder = expectOk(Recorder::create(device, "use"));
        recorder.fill(source, 1);
        recorder.fill(result, 0);
        recorder.dispatch(kernel, {kCount}, std::uint32_t{3}, {source, result});
        static_cast<void>(expectOk(recorder.submit()));
        const auto values = expectOk(read<std::uint32_t>(result));
        if (expected_.empty()) expected_ = values;
        EXPECT_EQ(values, expected_);
    }
    fs::path file() const { return kernelsFile(device_->physical(), folder_); }
    std::vector<fs::path> files() const {
        std::vector<fs::path> found;
        if (!fs::exists(folder_)) return found;
        for (const auto& entry : fs::directory_iterator(folder_)) found.push_back(entry.path());
        return found;
    }
    VkPhysicalDeviceProperties driver() const {
        VkPhysicalDeviceProperties properties{};
        vkGetPhysicalDeviceProperties(device_->physical(), &properties);
        return properties;
    }

    fs::path folder_;
    std::vector<std::uint32_t> expected_;
};

TEST_F(PipelineCacheTest, IsWrittenWhenTheDeviceGoesAndReadByTheNext) {
    useOne();
    ASSERT_EQ(files(), std::vector<fs::path>{file()}) << "one file, and nothing half written";
    const auto data = unsealedKernels(expectOk(readText(file())));
    ASSERT_TRUE(data.has_value());
    EXPECT_TRUE(isOfDriver(*data, driver()));
    EXPECT_EQ(fs::status(folder_).permissions() & fs::perms::others_all, fs::perms::none);
    useOne();
    EXPECT_EQ(files(), std::vector<fs::path>{file()});
}

TEST_F(PipelineCacheTest, TheFirstStartIsKnown) {
    EXPECT_TRUE(keeping()->isFirstStart());  // which has written its file now
    EXPECT_FALSE(keeping()->isFirstStart());
    expectOk(writeTextAtomically(file(), "damaged"));
    EXPECT_TRUE(keeping()->isFirstStart());
    EXPECT_FALSE(device()->isFirstStart()) << "nothing is kept";
}

TEST_F(PipelineCacheTest, WithoutAFolderNothingIsWritten) {
    {
        const auto device = expectOk(Device::create(*instance_, {.isAnnounced = false}));
        const Kernel kernel = expectOk(Kernel::create(device, shaders::slow_comp));
    }
    EXPECT_TRUE(files().empty());
}

TEST_F(PipelineCacheTest, OfALentDeviceNothingIsWritten) {
    {
        DeviceOptions options;
        options.physical = device()->physical();
        options.lent = LentDevice{
            .handle = device()->handle(), .queue = device()->queue(), .queueFamily = device()->queueFamily()};
        options.kernelsFolder = folder_;
        options.isAnnounced = false;
        const auto lent = expectOk(Device::create(*instance_, options));
        const Kernel kernel = expectOk(Kernel::create(lent, shaders::slow_comp));
    }
    EXPECT_TRUE(files().empty());
}

TEST_F(PipelineCacheTest, WhatIsNotAsItWasWrittenIsNotBelieved) {
    useOne();
    const std::string right = expectOk(readText(file()));
    std::string foreign = right;
    {
        std::string data = *unsealedKernels(right);
        data.at(8) = char(data.at(8) + 1);  // another vendor's
        EXPECT_FALSE(isOfDriver(data, driver()));
        foreign = sealedKernels(data);
    }
    std::string changed = right;
    changed.back() = char(changed.back() ^ 1);
    for (const std::string& text : {std::string(), std::string("\0", 1), right.substr(0, 40),
                                    right.substr(0, right.size() - 1), right + "x", changed, foreign,
                                    std::string(100'000, 'x'), sealedKernels({}), sealedKernels("short")}) {
        expectOk(writeTextAtomically(file(), text));
        useOne();
        const auto data = unsealedKernels(expectOk(readText(file())));
        ASSERT_TRUE(data.has_value()) << text.size();
        EXPECT_TRUE(isOfDriver(*data, driver())) << text.size();
    }
}

TEST_F(PipelineCacheTest, WhereNothingCanBeWrittenAllGoesOn) {
    fs::create_directories(folder_.parent_path());
    std::ofstream(folder_) << "a file where the folder should be";
    useOne();
    EXPECT_TRUE(fs::is_regular_file(folder_));
}

TEST_F(PipelineCacheTest, FilesOfOldDriversGo) {
    fs::create_directories(folder_);
    for (int i = 0; i < 20; ++i) {
        const fs::path old = folder_ / (std::to_string(i) + ".kernels");
        std::ofstream(old) << i;
        fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(1 + i));
    }
    std::ofstream(folder_ / "somebody's.txt") << "stays";
    useOne();
    EXPECT_TRUE(fs::exists(file()));
    EXPECT_TRUE(fs::exists(folder_ / "somebody's.txt"));
    EXPECT_TRUE(fs::exists(folder_ / "0.kernels"));
    EXPECT_FALSE(fs::exists(folder_ / "19.kernels"));
    EXPECT_EQ(files().size(), 9u);
}

}  // namespace
}  // namespace macula::gpu

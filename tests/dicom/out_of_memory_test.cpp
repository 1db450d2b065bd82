// Out of memory is out of memory: an allocation that fails must not turn a healthy slice into a damaged one,
// which would be interpolated. Every n-th allocation of a load fails once, for many n.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "support.h"

namespace {

std::atomic<long> allocationsLeft{-1};  // until one fails; below 0: none does

void* allocate(std::size_t size) {
    if (allocationsLeft.load(std::memory_order_relaxed) >= 0 && allocationsLeft-- == 0)
        throw std::bad_alloc();
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
    return allocate(size);
}
void* operator new[](std::size_t size) {
    return allocate(size);
}
// All forms of it or none: a sanitizer has its own of what is not replaced, which do not go with these.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept try {
    return allocate(size);
} catch (const std::bad_alloc&) {
    return nullptr;
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept try {
    return allocate(size);
} catch (const std::bad_alloc&) {
    return nullptr;
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, const std::nothrow_t&) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace macula::dicom::test {
namespace {

// Loads while the allocation after `number` others fails: whether any did. (While a folder is listed none may
// fail: that functions of the standard library which allocate are noexcept ends the process.)
bool failsOnce(const Scan& scan, long number, const Volume& expected) {
    Progress progress;
    allocationsLeft = number;
    const auto volume =
        loadVolume(scan.studies.at(0).series.at(0), scan.studies[0].series[0].stacks.at(0), progress);
    const bool failed = allocationsLeft < 0;
    allocationsLeft = -1;
    if (!volume) {
        EXPECT_TRUE(failed);
        EXPECT_EQ(volume.error().code, ErrorCode::outOfMemory) << number << ": " << volume.error().message;
        return failed;
    }
    EXPECT_EQ((*volume)->size(), expected.size()) << number;
    EXPECT_TRUE((*volume)->provenance().interpolatedSlices.empty()) << number;
    EXPECT_TRUE((*volume)->provenance().messages.empty()) << number;
    expectSameValues(**volume, expected);
    return failed;
}

TEST(OutOfMemory, NoHealthySliceIsLeftOut) {
    const TemporaryFolder folder;
    const Volume original = smallVolume();
    write(original, folder.path());
    ASSERT_NE(loadFolder(folder.path()), nullptr);  // what is made once is there
    Progress progress;
    const auto scan = scanFolder(folder.path(), progress);
    ASSERT_TRUE(scan.ok());
    long number = 0;
    while (failsOnce(*scan, number, original) && number < 2'000'000) number += 1 + number / 50;
    EXPECT_GT(number, 200);
}

}  // namespace
}  // namespace macula::dicom::test

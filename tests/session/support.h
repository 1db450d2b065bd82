// Stores in folders of their own, and things to put into them.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "session/store.h"

namespace macula::session::test {

// In memory where there is such a folder: these tests wait for the disk some thousand times.
std::filesystem::path newFolder();

std::string digestOf(std::string_view text);
// A key of the volume called so, with a transfer function and a clip called so.
ModelKey keyOf(std::string_view volume, std::string_view transfer = "bone", std::string_view clip = "none");

// Bytes that tell what they are: a number, and noise that follows from it.
std::vector<std::byte> blobOf(std::uint32_t number, std::size_t bytes);
// The number of such a blob; nothing when a byte is not as it was made.
std::optional<std::uint32_t> numberOf(std::span<const std::byte> blob);

std::string textOf(const std::filesystem::path& file);
void putText(const std::filesystem::path& file, std::string_view text);
// Every file below the folder, by its path from there.
std::vector<std::filesystem::path> filesBelow(const std::filesystem::path& folder);

// Runs `work` in a child of this process, and gives its exit status; -1 when it was killed.
int inChild(const std::function<int()>& work);
// The same, as a user who is not root, who may read and write anything.
int inChildOfNobody(const std::function<int()>& work);
inline constexpr unsigned kNobody = 65534;

// A number that the environment sets, for longer runs.
int numberFromEnvironment(const char* name, int otherwise);

class StoreTest : public ::testing::Test {
  protected:
    StoreTest();
    ~StoreTest() override;
    StoreOptions options() const;
    // Fails the test where the store does not open.
    Store open() { return open(options()); }
    Store open(const StoreOptions& with);
    OpenedVolume opened(std::string_view study, std::string_view series, std::string_view volume) const;

    std::filesystem::path folder_;  // of the store; its parent is the test's own
    std::int64_t nowMs_ = 1'700'000'000'000;
};

// Of a test that goes on with the value.
template <class T>
T valueOf(Result<T> result) {
    EXPECT_TRUE(result.ok()) << (result.ok() ? Text() : result.error().message);
    return std::move(result).value();
}

template <class T>
::testing::AssertionResult isOk(const Result<T>& result) {
    if (result.ok()) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << result.error().message << " " << result.error().where;
}

template <class T>
std::optional<Trouble> troubleIn(const Result<T>& result) {
    return result.ok() ? std::nullopt : troubleOf(result.error());
}

}  // namespace macula::session::test

// Pictures that are taken in a headset are written beside its frames, or it is said that they were not.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>

#include "base/no_threads.h"
#include "xr/eye_copy.h"

namespace macula::xr {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> waitFor(PictureWriter& writer) {
    std::optional<std::string> told;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(8);
    while (!(told = writer.told()) && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    return told;
}

TEST(PictureWriter, WithoutAThreadItIsToldAndTheNextOneIsWritten) {
    std::string folder = (fs::temp_directory_path() / "macula-eye-XXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    const EyeView view{.sizePx = {64, 48}, .rgba = std::vector<std::uint8_t>(4 * 64 * 48, 255)};
    PictureWriter writer;
    {
        const macula::test::NoThreads none;
        writer.start(view, folder, {});
    }
    EXPECT_FALSE(writer.isBusy());
    EXPECT_EQ(writer.told(), "The picture could not be written.");
    EXPECT_EQ(writer.told(), std::nullopt) << "once";
    EXPECT_TRUE(fs::is_empty(folder));

    writer.start(view, folder, {});
    EXPECT_EQ(waitFor(writer), "Picture macula-headset-1.png is written.");
    EXPECT_TRUE(fs::exists(fs::path(folder) / "macula-headset-1.png"));
    fs::remove_all(folder);
}

TEST(PictureWriter, ErrorsAreToldInTheLanguageOfTheHost) {
    RoomWords words;
    words.say = [](const Text& text) { return "Auf Deutsch: " + text.format(); };
    PictureWriter writer;
    writer.start({.sizePx = {64, 48}, .rgba = std::vector<std::uint8_t>(4 * 64 * 48, 255)},
                 fs::temp_directory_path() / "macula has no such folder", words);
    EXPECT_EQ(waitFor(writer), "Auf Deutsch: The folder for pictures is not there.");
}

}  // namespace
}  // namespace macula::xr

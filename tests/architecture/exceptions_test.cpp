// Who stops every exception lets a failed check pass: it is no trouble of a file (base/check.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "architecture/sources.h"
#include "base/paths.h"

namespace {

// Where the braces that open next are closed.
std::size_t endOfBlock(std::string_view text, std::size_t at) {
    int open = 0;
    for (; at < text.size(); ++at) {
        if (text[at] == '{') ++open;
        if (text[at] == '}' && --open == 0) break;
    }
    return at;
}

// The lines before it, and those after it, tell of the check, or hand on whatever was thrown.
bool letsChecksPass(std::string_view text, std::size_t at) {
    constexpr std::size_t kNear = 250;
    const std::string_view before = text.substr(at > kNear ? at - kNear : 0, std::min(at, kNear));
    if (before.find("catch (const CheckFailure&") != std::string_view::npos) return true;
    const std::string_view after = text.substr(at, endOfBlock(text, at) - at);
    for (const char* handedOn : {"throw;", "current_exception", "keepCurrent"})
        if (after.find(handedOn) != std::string_view::npos) return true;
    return false;
}

TEST(Exceptions, OneThatIsStoppedIsSeen) {
    const auto passes = [](std::string_view text) { return letsChecksPass(text, text.find("catch (...)")); };
    EXPECT_FALSE(passes("try { f(); } catch (...) { failed = true; } throw;"));
    EXPECT_TRUE(passes("try { f(); } catch (...) { clean(); throw; }"));
    EXPECT_TRUE(passes("try { f(); } catch (const CheckFailure&) { throw; } catch (...) { failed = true; }"));
}

// Rooms that a host may have: the window and the command end with a failed check.
TEST(Exceptions, NoRoomStopsAFailedCheck) {
    const auto folder = macula::test::projectFolder();
    std::size_t found = 0;
    for (const char* room : {"src/base", "src/dicom", "src/formats", "src/segment", "src/registration",
                             "src/slices", "src/image", "src/pipeline", "src/presets", "src/session",
                             "src/study", "src/scene", "src/live", "src/pictures", "src/c"}) {
        for (const auto& file : macula::test::sourcesIn(room)) {
            std::ifstream stream(file);
            const std::string text{std::istreambuf_iterator<char>(stream), {}};
            for (std::size_t at = text.find("catch (...)"); at != std::string::npos;
                 at = text.find("catch (...)", at + 1)) {
                ++found;
                EXPECT_TRUE(letsChecksPass(text, at))
                    << file.lexically_relative(folder) << ": a failed check becomes another error";
            }
        }
    }
    EXPECT_GT(found, 5u) << "the sources were not found";
}

}  // namespace

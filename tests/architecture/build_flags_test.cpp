// How the sources are compiled: nothing that changes what inline functions of the whole program do.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/paths.h"

namespace {

namespace fs = std::filesystem;

// With these NaN and infinity are taken for granted not to be there, or sums are ordered anew. Of an inline
// function the linker keeps one, whichever file it was compiled with.
constexpr std::array kLooseMath{"-ffast-math",
                                "-Ofast",
                                "-funsafe-math-optimizations",
                                "-ffinite-math-only",
                                "-fno-signed-zeros",
                                "-fassociative-math",
                                "-freciprocal-math",
                                "-ffp-model=fast",
                                "/fp:fast",
                                "-mfpmath=387",
                                "-fsingle-precision-constant"};

std::string_view looseMathIn(std::string_view line) {
    line = line.substr(0, line.find('#'));  // CMake's comments
    for (const std::string_view flag : kLooseMath)
        if (line.find(flag) != line.npos) return flag;
    return {};
}

std::vector<fs::path> buildFiles() {
    const fs::path root = macula::test::projectFolder();
    std::vector<fs::path> files{root / "CMakeLists.txt", root / "CMakePresets.json"};
    for (const char* folder : {"cmake", "packaging", "shaders", "src", "tests"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const fs::path& path = entry.path();
            if (path.filename() == "CMakeLists.txt" || path.extension() == ".cmake") files.push_back(path);
        }
    }
    return files;
}

TEST(BuildFlags, LooseMathIsFound) {
    EXPECT_EQ(looseMathIn("target_compile_options(a PRIVATE -O3 -ffast-math)"), "-ffast-math");
    EXPECT_EQ(looseMathIn("set(CMAKE_CXX_FLAGS \"-Ofast\")"), "-Ofast");
    EXPECT_EQ(looseMathIn("set(flags -fno-math-errno)  # no -ffast-math"), "");
}

TEST(BuildFlags, NoFileIsCompiledWithLooseMath) {
    const std::vector<fs::path> files = buildFiles();
    ASSERT_GT(files.size(), 30u);
    for (const fs::path& file : files) {
        std::ifstream text(file);
        ASSERT_TRUE(text) << file;
        for (std::string line; std::getline(text, line);)
            EXPECT_EQ(looseMathIn(line), "") << file << ": " << line;
    }
}

}  // namespace

// What comments refer to exists.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "architecture/sources.h"
#include "base/paths.h"

namespace {

namespace fs = std::filesystem;

bool isOfName(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '/' || c == '-';
}

// The names of sources and pages in a line's comment: "volume.h", "lib/rng.glsl". Addresses are left out.
std::vector<std::string> filesNamedIn(std::string_view line) {
    std::vector<std::string> files;
    const std::size_t comment = line.find("//");
    if (comment == std::string_view::npos) return files;
    for (std::size_t i = comment + 2; i < line.size();) {
        std::size_t end = i;
        while (end < line.size() && isOfName(line[end])) ++end;
        std::string_view name = line.substr(i, end - i);
        while (name.ends_with('.')) name.remove_suffix(1);
        i = end + 1;
        const bool isPart = end < line.size() && line[end] == '*';  // "reference_tracer*.cpp"
        for (const char* ending : {".h", ".cpp", ".glsl", ".comp", ".inl", ".md"})
            if (name.size() > std::string_view(ending).size() && name.ends_with(ending) &&
                !name.starts_with('/') && !name.starts_with('.') && !isPart)
                files.emplace_back(name);
    }
    return files;
}

std::set<std::string> allFileNames() {
    std::set<std::string> names;
    for (const char* folder : {"src", "shaders", "tests"})
        for (const fs::path& path : macula::test::sourcesIn(folder)) names.insert(path.filename().string());
    for (const char* folder : {".", "docs", "docs/measurements"})
        for (const auto& entry : fs::directory_iterator(macula::test::projectFolder() / folder))
            names.insert(entry.path().filename().string());
    return names;
}

TEST(Comments, NamesOfFilesAreFound) {
    using Names = std::vector<std::string>;
    EXPECT_EQ(filesNamedIn("int a;  // see volume.h, and lib/rng.glsl."),
              (Names{"volume.h", "lib/rng.glsl"}));
    EXPECT_EQ(filesNamedIn("#include \"volume.h\""), Names{});
    EXPECT_EQ(filesNamedIn("// https://example.org/nifti1.h, reference_tracer*.cpp, 0.5, .h"), Names{});
}

TEST(Comments, NameFilesThatExist) {
    const std::set<std::string> names = allFileNames();
    const std::set<std::string> ofOthers{"itk_compiler_detection.h"};
    std::size_t count = 0;
    for (const char* folder : {"src", "shaders"}) {
        for (const fs::path& path : macula::test::sourcesIn(folder)) {
            std::ifstream text(path);
            int number = 0;
            for (std::string line; std::getline(text, line);) {
                ++number;
                for (const std::string& file : filesNamedIn(line)) {
                    ++count;
                    const std::string name = fs::path(file).filename().string();
                    EXPECT_TRUE(names.contains(name) || ofOthers.contains(name))
                        << path.lexically_relative(macula::test::projectFolder()) << ":" << number
                        << ": there is no " << file;
                }
            }
        }
    }
    EXPECT_GT(count, 100u) << "the sources were not found";
}

}  // namespace

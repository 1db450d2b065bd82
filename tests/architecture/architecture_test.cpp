// Which folder may include which, and how long a file may be: ARCHITECTURE.md, checked.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/paths.h"

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

const fs::path kRoot = macula::test::projectFolder();
constexpr int kMaxLines = 600;

// Folder of src/ to the folders it may include besides itself.
const std::map<std::string, Names> kArrows{
    {"base", {}},
    {"dicom", {"base"}},
    {"segment", {"base"}},
    {"image", {"base"}},
    {"pipeline/gpu", {"base"}},
    {"pipeline/volume", {"base", "pipeline/gpu"}},
    {"pipeline/trace", {"base", "pipeline/gpu", "pipeline/volume"}},
    {"pipeline/splat", {"base", "pipeline/gpu"}},
    {"pipeline/hybrid", {"base", "pipeline/gpu", "pipeline/volume", "pipeline/trace", "pipeline/splat"}},
    {"presets", {"base", "pipeline/volume"}},
    {"viewer",
     {"base", "dicom", "segment", "image", "presets", "pipeline/gpu", "pipeline/volume", "pipeline/trace",
      "pipeline/splat", "pipeline/hybrid"}},
    {"cli",
     {"base", "dicom", "segment", "image", "presets", "pipeline/gpu", "pipeline/volume", "pipeline/trace",
      "pipeline/splat", "pipeline/hybrid"}}};

struct Library {
    std::string name;
    std::vector<std::string> prefixes;  // of what stands between the brackets
    Names folders;                      // which may include it
};
const std::vector<Library> kLibraries{
    {"Qt", {"Q", "Qt"}, {"viewer"}},
    {"Vulkan",
     {"vulkan/", "vk_"},
     {"pipeline/gpu", "pipeline/volume", "pipeline/trace", "pipeline/splat", "pipeline/hybrid", "viewer"}},
    {"DCMTK", {"dcmtk/"}, {"dicom"}},
    {"OpenJPEG", {"openjpeg"}, {"dicom"}},
    {"ITK", {"itk", "ITK"}, {"dicom", "segment"}},
    {"OpenImageIO", {"OpenImageIO/", "OpenEXR/", "Imath/"}, {"image"}},
    {"CLI11", {"CLI/"}, {"cli"}},
    {"VTK", {"vtk"}, {"cli"}},
    {"pugixml", {"pugi"}, {"presets"}},
    {"SQLite", {"sqlite3"}, {}},
    {"OpenXR", {"openxr/"}, {}}};

struct Include {
    std::string file;  // relative to the repository
    int line = 0;
    std::string target;
};

bool isSource(const fs::path& path) {
    const std::string extension = path.extension().string();
    return extension == ".h" || extension == ".cpp" || extension == ".inl" || extension == ".glsl" ||
           extension == ".comp" || extension == ".vert" || extension == ".frag";
}

std::vector<fs::path> sourcesIn(const char* folder) {
    std::vector<fs::path> files;
    if (!fs::is_directory(kRoot / folder)) return files;
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
        if (entry.is_regular_file() && isSource(entry.path())) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

// "dicom", "pipeline/trace": the longest known folder that `path` begins with; else its first part.
std::string folderOf(const std::string& path) {
    std::string best;
    for (const auto& [folder, unused] : kArrows) {
        if (path.starts_with(folder + "/") && folder.size() > best.size()) best = folder;
    }
    return best.empty() ? path.substr(0, path.find('/')) : best;
}

std::vector<Include> includesOf(const std::string& file, std::istream& text) {
    std::vector<Include> includes;
    std::string line;
    for (int number = 1; std::getline(text, line); ++number) {
        const std::size_t hash = line.find_first_not_of(" \t");
        if (hash == std::string::npos || line[hash] != '#') continue;
        const std::size_t word = line.find_first_not_of(" \t", hash + 1);
        if (word == std::string::npos || line.compare(word, 7, "include") != 0) continue;
        const std::size_t open = line.find_first_of("\"<", word);
        if (open == std::string::npos) continue;
        const std::size_t close = line.find_first_of("\">", open + 1);
        includes.push_back({file, number, line.substr(open + 1, close - open - 1)});
    }
    return includes;
}

std::vector<Include> includesOf(const fs::path& path) {
    std::ifstream text(path);
    return includesOf(path.lexically_relative(kRoot).generic_string(), text);
}

// Qt's headers have no folder and no extension: QWindow, but also queue begins with a q, and quill.h with a Q
// in theory.
bool belongsTo(const Library& library, const std::string& target) {
    return std::any_of(library.prefixes.begin(), library.prefixes.end(), [&](const std::string& prefix) {
        if (!target.starts_with(prefix)) return false;
        if (prefix != "Q") return true;
        return target.size() > 1 && target[1] >= 'A' && target[1] <= 'Z' &&
               target.find('.') == std::string::npos;
    });
}

// Empty when the include is allowed, else why it is not.
std::string whyForbidden(const Include& include) {
    const std::string inside = include.file.substr(std::string_view("src/").size());
    const std::string from = folderOf(inside);
    const auto arrows = kArrows.find(from);
    if (arrows == kArrows.end()) return "folder src/" + from + " is not in kArrows; say what it may include";

    for (const Library& library : kLibraries) {
        if (belongsTo(library, include.target) && !library.folders.contains(from)) {
            return library.name + " is not for src/" + from;
        }
    }
    const std::string to = folderOf(include.target);
    const bool ours = kArrows.contains(to) || to == "pipeline" || to == "session" || to == "xr";
    if (ours && to != from && !arrows->second.contains(to))
        return "no arrow leads from " + from + " to " + to;
    return {};
}

std::string whyForbidden(const char* file, const char* line) {
    std::istringstream text(line);
    const auto includes = includesOf(file, text);
    return includes.empty() ? "no include found" : whyForbidden(includes.front());
}

// The checker itself: a rule that never fires proves nothing.
TEST(Architecture, RulesFire) {
    EXPECT_NE(whyForbidden("src/base/a.cpp", "#include \"dicom/scan.h\""), "");
    EXPECT_NE(whyForbidden("src/dicom/a.cpp", "#include \"pipeline/gpu/device.h\""), "");
    EXPECT_NE(whyForbidden("src/pipeline/gpu/a.cpp", "#include \"pipeline/trace/path_tracer.h\""), "");
    EXPECT_NE(whyForbidden("src/pipeline/volume/a.cpp", "# include \"pipeline/trace/environment.h\""), "");
    EXPECT_NE(whyForbidden("src/pipeline/trace/a.cpp", "#include <QImage>"), "");
    EXPECT_NE(whyForbidden("src/pipeline/splat/a.cpp", "#include \"pipeline/trace/film.h\""), "");
    EXPECT_NE(whyForbidden("src/pipeline/trace/a.cpp", "#include <dcmtk/dcmdata/dctk.h>"), "");
    EXPECT_NE(whyForbidden("src/viewer/a.cpp", "#include <OpenImageIO/imageio.h>"), "");
    EXPECT_NE(whyForbidden("src/viewer/a.cpp", "#include \"cli/report.h\""), "");
    EXPECT_NE(whyForbidden("src/cli/a.cpp", "#include \"viewer/viewport.h\""), "");
    EXPECT_NE(whyForbidden("src/cli/a.cpp", "#include <QtGui/QWindow>"), "");
    EXPECT_NE(whyForbidden("src/cli/a.cpp", "#include <vulkan/vulkan.h>"), "");
    EXPECT_NE(whyForbidden("src/image/a.cpp", "#include <vulkan/vulkan_core.h>"), "");
    EXPECT_NE(whyForbidden("src/presets/a.cpp", "#include \"dicom/scan.h\""), "");
    EXPECT_NE(whyForbidden("src/pipeline/volume/a.cpp", "#include <pugixml.hpp>"), "");
    EXPECT_NE(whyForbidden("src/segment/a.cpp", "#include \"dicom/scan.h\""), "");
    EXPECT_NE(whyForbidden("src/pipeline/volume/a.cpp", "#include <itkImage.h>"), "");
    EXPECT_EQ(whyForbidden("src/segment/a.cpp", "#include <itkImage.h>"), "");
    EXPECT_NE(whyForbidden("src/novel/a.cpp", "#include <vector>"), "");
    EXPECT_EQ(whyForbidden("src/viewer/a.cpp", "#include <QWindow>"), "");
    EXPECT_EQ(whyForbidden("src/viewer/a.cpp", "#include \"pipeline/trace/path_tracer.h\""), "");
    EXPECT_EQ(whyForbidden("src/base/a.cpp", "#include <queue>"), "");
    EXPECT_EQ(whyForbidden("src/cli/a.cpp", "#include \"presets/embedded_files.h\""), "");
}

TEST(Architecture, ArrowsPointDownOnly) {
    std::size_t count = 0;
    for (const fs::path& path : sourcesIn("src")) {
        for (const Include& include : includesOf(path)) {
            ++count;
            const std::string why = whyForbidden(include);
            EXPECT_EQ(why, "") << include.file << ":" << include.line << " includes " << include.target;
        }
    }
    EXPECT_GT(count, 100u) << "the sources were not found at " << kRoot;
}

// One translation unit or two per heavy library, so that a cold build stays short and each has one owner.
TEST(Architecture, HeavyHeadersStayInFewFiles) {
    const std::map<std::string, std::size_t> most{{"OpenImageIO", 1}, {"OpenJPEG", 1}, {"ITK", 4}};
    std::map<std::string, Names> users;
    for (const fs::path& path : sourcesIn("src")) {
        for (const Include& include : includesOf(path)) {
            for (const Library& library : kLibraries) {
                if (belongsTo(library, include.target)) users[library.name].insert(include.file);
            }
        }
    }
    for (const auto& [name, limit] : most) EXPECT_LE(users[name].size(), limit) << name;
    for (const char* name : {"OpenImageIO", "DCMTK", "OpenJPEG"}) {
        for (const std::string& file : users[name])
            EXPECT_TRUE(file.ends_with(".cpp")) << name << " in " << file;
    }
}

TEST(Architecture, NoFileIsTwoThings) {
    for (const char* folder : {"src", "shaders", "tests", "presets"}) {
        for (const fs::path& path : sourcesIn(folder)) {
            std::ifstream text(path);
            const auto lines = std::count(std::istreambuf_iterator<char>(text), {}, '\n');
            EXPECT_LE(lines, kMaxLines) << path.lexically_relative(kRoot) << ": split it by what it is about";
        }
    }
}

}  // namespace

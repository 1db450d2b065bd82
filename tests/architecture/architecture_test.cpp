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

#include "architecture/sources.h"
#include "base/paths.h"

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;
using macula::test::sourcesIn;

const fs::path kRoot = macula::test::projectFolder();
constexpr int kMaxLines = 600;
constexpr int kMaxLinesOfAVerb = 250;
constexpr int kMaxMeanLinesOfVerbs = 80;

struct Library {
    std::string name;
    std::vector<std::string> prefixes;  // of what stands between the brackets
};
const std::vector<Library> kLibraries{
    {"Qt", {"Q", "Qt"}},     {"Vulkan", {"vulkan/", "vk_"}},
    {"DCMTK", {"dcmtk/"}},   {"OpenJPEG", {"openjpeg"}},
    {"ITK", {"itk", "ITK"}}, {"GDCM", {"gdcm"}},
    {"niftilib", {"nifti"}}, {"OpenImageIO", {"OpenImageIO/", "OpenEXR/", "Imath/"}},
    {"CLI11", {"CLI/"}},     {"VTK", {"vtk"}},
    {"pugixml", {"pugi"}},   {"SQLite", {"sqlite3", "SQLiteCpp/"}},
    {"OpenXR", {"openxr/"}}, {"Highway", {"hwy/"}},
    {"libcurl", {"curl/"}},  {"libarchive", {"archive.h", "archive_entry.h"}}};

// ARCHITECTURE.md: the arrows of its diagram, and who may use which library.
struct Rules {
    std::map<std::string, Names> arrows;     // folder to the folders that it may include, besides itself
    std::map<std::string, Names> libraries;  // to the folders that may include them
};

std::string trimmed(std::string_view text) {
    const auto from = text.find_first_not_of(" `\t");
    if (from == std::string_view::npos) return {};
    return std::string(text.substr(from, text.find_last_not_of(" `\t") - from + 1));
}

std::vector<std::string> partsOf(std::string_view line, std::string_view separator) {
    std::vector<std::string> parts;
    while (true) {
        const std::size_t end = line.find(separator);
        parts.push_back(trimmed(line.substr(0, end)));
        if (end == std::string_view::npos) return parts;
        line.remove_prefix(end + separator.size());
    }
}

// What arrows lead to in several steps, they lead to.
void close(std::map<std::string, Names>& arrows) {
    for (bool grown = true; grown;) {
        grown = false;
        for (auto& [from, reached] : arrows) {
            const Names before = reached;
            for (const std::string& to : before) reached.insert(arrows[to].begin(), arrows[to].end());
            grown = grown || reached.size() > before.size();
        }
    }
}

Rules readRules() {
    Rules rules;
    std::ifstream text(kRoot / "ARCHITECTURE.md");
    bool isTable = false;
    bool isGraph = false;  // other diagrams are flowcharts
    for (std::string line; std::getline(text, line);) {
        isGraph = line == "graph TD" || (isGraph && line != "```");
        if (const auto ends = partsOf(line, "-->"); isGraph && ends.size() == 2) {
            rules.arrows[ends[0]].insert(ends[1]);
            rules.arrows[ends[1]];
        }
        isTable = line.starts_with("| library |") || (isTable && line.starts_with("|"));
        const auto cells = partsOf(line, "|");
        if (!isTable || cells.size() != 4 || cells[1] == "library" || cells[1].starts_with("-")) continue;
        for (const std::string& folder : partsOf(cells[2], ",")) rules.libraries[cells[1]].insert(folder);
    }
    close(rules.arrows);
    return rules;
}

const Rules& rules() {
    static const Rules read = readRules();
    return read;
}

struct Include {
    std::string file;  // relative to the repository
    int line = 0;
    std::string target;
};

// "dicom", "pipeline/trace": the longest known folder that `path` begins with; else its first part.
std::string folderOf(const std::string& path) {
    std::string best;
    for (const auto& [folder, unused] : rules().arrows) {
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

// Where `target` is looked for: shaders are included from shaders/, all else from src/.
std::string folderOfTarget(const std::string& target) {
    const bool isShader = target.starts_with("lib/") || target.starts_with("shared/");
    return folderOf(isShader ? "shaders/" + target : target);
}

// Empty when the include is allowed, else why it is not.
std::string whyForbidden(const Include& include) {
    const bool isShader = include.file.starts_with("shaders/");
    const std::string from = folderOf(isShader ? include.file : include.file.substr(4));  // after src/
    const auto arrows = rules().arrows.find(from);
    if (arrows == rules().arrows.end()) return from + " is not in the diagram of ARCHITECTURE.md";

    for (const Library& library : kLibraries) {
        if (!belongsTo(library, include.target)) continue;
        const auto allowed = rules().libraries.find(library.name);
        if (allowed == rules().libraries.end() || !allowed->second.contains(from))
            return library.name + " is not for " + from;
    }
    const std::string shader = "shaders/" + include.target.substr(0, include.target.find('/'));
    const std::string to =
        isShader && rules().arrows.contains(shader) ? shader : folderOfTarget(include.target);
    const bool ours = rules().arrows.contains(to) || to == "pipeline" || to == "xr";
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
    EXPECT_NE(whyForbidden("src/cli/a.cpp", "#include \"viewer/viewport/viewport.h\""), "");
    EXPECT_NE(whyForbidden("src/viewer/window/a.cpp", "#include \"viewer/driven/driven_hand.h\""), "");
    EXPECT_EQ(whyForbidden("src/viewer/driven/a.cpp", "#include \"viewer/window/main_window.h\""), "");
    EXPECT_EQ(whyForbidden("src/viewer/driven/a.cpp", "#include <QWindow>"), "");
    EXPECT_NE(whyForbidden("src/live/a.cpp", "#include \"evaluate/tradeoff.h\""), "");
    EXPECT_NE(whyForbidden("src/cli/a.cpp", "#include \"evaluate/tradeoff.h\""), "");
    EXPECT_NE(whyForbidden("src/cli/shared/a.cpp", "#include \"evaluate/tradeoff.h\""), "");
    EXPECT_NE(whyForbidden("src/cli/shared/a.cpp", "#include \"cli/command.h\""), "");
    EXPECT_EQ(whyForbidden("src/bench/a.cpp", "#include \"evaluate/tradeoff.h\""), "");
    EXPECT_EQ(whyForbidden("src/bench/a.cpp", "#include \"cli/shared/report.h\""), "");
    EXPECT_NE(whyForbidden("src/bench/a.cpp", "#include \"cli/command.h\""), "");
    EXPECT_NE(whyForbidden("src/c/a.cpp", "#include \"cli/report.h\""), "");
    EXPECT_NE(whyForbidden("src/c/a.cpp", "#include <QImage>"), "");
    EXPECT_NE(whyForbidden("src/live/a.cpp", "#include \"c/last_error.h\""), "");
    EXPECT_EQ(whyForbidden("src/c/a.cpp", "#include \"live/device/open_device.h\""), "");
    EXPECT_NE(whyForbidden("src/live/a.cpp", "#include <QObject>"), "");
    EXPECT_NE(whyForbidden("src/live/a.cpp", "#include <SQLiteCpp/Database.h>"), "");
    EXPECT_NE(whyForbidden("src/live/a.cpp", "#include <sqlite3.h>"), "");
    EXPECT_NE(whyForbidden("src/session/a.cpp", "#include \"pipeline/splat/model/splats.h\""), "");
    EXPECT_NE(whyForbidden("src/pipeline/hybrid/a.cpp", "#include \"session/store.h\""), "");
    EXPECT_EQ(whyForbidden("src/live/a.cpp", "#include \"session/store.h\""), "");
    EXPECT_NE(whyForbidden("src/live/a.cpp", "#include <CLI/App.hpp>"), "");
    EXPECT_NE(whyForbidden("src/evaluate/a.cpp", "#include <CLI/App.hpp>"), "");
    EXPECT_NE(whyForbidden("src/dicom/a.cpp", "#include <itkImage.h>"), "");
    EXPECT_NE(whyForbidden("src/pipeline/gpu/a.cpp", "#include \"shared/trace_params.h\""), "");
    EXPECT_NE(whyForbidden("shaders/shared/a.h", "#include \"lib/rng.glsl\""), "");
    EXPECT_NE(whyForbidden("shaders/lib/a.glsl", "#include \"trace/film.glsl\""), "");
    EXPECT_NE(whyForbidden("shaders/splat/a.comp", "#include \"trace/film.glsl\""), "");
    EXPECT_EQ(whyForbidden("shaders/splat/a.comp", "#include \"lib/splat_lib.glsl\""), "");
    EXPECT_EQ(whyForbidden("shaders/trace/a.comp", "#include \"shared/trace_params.h\""), "");
    EXPECT_EQ(whyForbidden("src/pipeline/trace/a.cpp", "#include \"shared/trace_params.h\""), "");
    EXPECT_EQ(whyForbidden("src/live/a.cpp", "#include \"pipeline/trace/path_tracer.h\""), "");
    EXPECT_NE(whyForbidden("src/cli/a.cpp", "#include <QtGui/QWindow>"), "");
    EXPECT_NE(whyForbidden("src/cli/a.cpp", "#include <vulkan/vulkan.h>"), "");
    EXPECT_NE(whyForbidden("src/image/a.cpp", "#include <vulkan/vulkan_core.h>"), "");
    EXPECT_NE(whyForbidden("src/presets/a.cpp", "#include \"dicom/scan.h\""), "");
    EXPECT_NE(whyForbidden("src/pipeline/volume/a.cpp", "#include <pugixml.hpp>"), "");
    EXPECT_NE(whyForbidden("src/segment/a.cpp", "#include \"dicom/scan.h\""), "");
    EXPECT_NE(whyForbidden("src/pipeline/volume/a.cpp", "#include <itkImage.h>"), "");
    EXPECT_EQ(whyForbidden("src/segment/a.cpp", "#include <itkImage.h>"), "");
    EXPECT_NE(whyForbidden("src/study/a.cpp", "#include \"scene/state/study_state.h\""), "");
    EXPECT_NE(whyForbidden("src/scene/a.cpp", "#include \"live/frame/frame_input.h\""), "");
    EXPECT_NE(whyForbidden("src/scene/a.cpp", "#include \"session/store.h\""), "");
    EXPECT_NE(whyForbidden("src/live/a.cpp", "#include \"pictures/picture_request.h\""), "");
    EXPECT_EQ(whyForbidden("src/pictures/a.cpp", "#include \"study/open/opened_study.h\""), "");
    EXPECT_NE(whyForbidden("src/novel/a.cpp", "#include <vector>"), "");
    EXPECT_EQ(whyForbidden("src/viewer/a.cpp", "#include <QWindow>"), "");
    EXPECT_EQ(whyForbidden("src/viewer/a.cpp", "#include \"pipeline/trace/path_tracer.h\""), "");
    EXPECT_EQ(whyForbidden("src/base/a.cpp", "#include <queue>"), "");
    EXPECT_EQ(whyForbidden("src/cli/a.cpp", "#include \"presets/embedded_files.h\""), "");
}

// The diagram has no circle, knows every folder of src/ and shaders/, and names no library that nobody uses.
TEST(Architecture, TheDiagramIsOfThisHouse) {
    for (const auto& [from, reached] : rules().arrows)
        EXPECT_FALSE(reached.contains(from)) << from << " leads back to itself";
    for (const auto& [folder, unused] : rules().arrows) {
        const fs::path path = kRoot / (folder.starts_with("shaders/") ? folder : "src/" + folder);
        EXPECT_TRUE(fs::is_directory(path)) << path;
    }
    for (const auto& [name, folders] : rules().libraries) {
        const auto known = std::ranges::find(kLibraries, name, &Library::name);
        ASSERT_NE(known, kLibraries.end()) << name;
        Names users;
        for (const fs::path& path : sourcesIn("src")) {
            for (const Include& include : includesOf(path)) {
                if (belongsTo(*known, include.target)) users.insert(folderOf(include.file.substr(4)));
            }
        }
        EXPECT_EQ(users, folders) << name << " is used elsewhere than ARCHITECTURE.md says";
    }
}

TEST(Architecture, ArrowsPointDownOnly) {
    std::size_t count = 0;
    for (const char* folder : {"src", "shaders"}) {
        for (const fs::path& path : sourcesIn(folder)) {
            for (const Include& include : includesOf(path)) {
                ++count;
                const std::string why = whyForbidden(include);
                EXPECT_EQ(why, "") << include.file << ":" << include.line << " includes " << include.target;
            }
        }
    }
    EXPECT_GT(count, 100u) << "the sources were not found at " << kRoot;
}

// Why a file of live/frame or live/store may not include `target`; empty where it may. What draws knows no
// study, file or store, and what keeps models knows of frames no more than who asks for them.
std::string whyForbiddenInLive(const std::string& file, const std::string& target) {
    const auto isOf = [&](const char* folder) { return target.starts_with(folder); };
    if (file.starts_with("src/live/frame/")) {
        if (isOf("session/") || isOf("live/store/")) return "frames know no store";
        if (isOf("study/")) return "frames know no study";
        if (isOf("scene/") && !isOf("scene/camera/") && !isOf("scene/drawing/"))
            return "frames know of a scene only cameras and drawings";
    }
    if (file.starts_with("src/live/store/") && isOf("live/frame/") && target != "live/frame/scene_keeper.h")
        return "stores know of frames only who keeps their models";
    return {};
}

TEST(Architecture, FramesAndStoresAreApart) {
    EXPECT_NE(whyForbiddenInLive("src/live/frame/a.h", "live/store/study_keeper.h"), "");
    EXPECT_NE(whyForbiddenInLive("src/live/frame/a.h", "session/store.h"), "");
    EXPECT_NE(whyForbiddenInLive("src/live/frame/a.h", "study/open/loaded_study.h"), "");
    EXPECT_NE(whyForbiddenInLive("src/live/frame/a.h", "scene/state/study_state.h"), "");
    EXPECT_NE(whyForbiddenInLive("src/live/store/a.h", "live/frame/frame_input.h"), "");
    EXPECT_EQ(whyForbiddenInLive("src/live/store/a.h", "scene/drawing/drawing.h"), "");
    EXPECT_EQ(whyForbiddenInLive("src/live/hosted/a.h", "live/store/study_keeper.h"), "");
    std::size_t count = 0;
    for (const char* folder : {"src/live/frame", "src/live/store"}) {
        for (const fs::path& path : sourcesIn(folder)) {
            for (const Include& include : includesOf(path)) {
                ++count;
                EXPECT_EQ(whyForbiddenInLive(include.file, include.target), "")
                    << include.file << ":" << include.line << " includes " << include.target;
            }
        }
    }
    EXPECT_GT(count, 100u) << "the sources were not found at " << kRoot;
}

// Maps each folder to the folders that its files include, in one or more steps.
std::map<std::string, Names> foldersReached(const std::vector<Include>& includes) {
    std::map<std::string, Names> reached;
    for (const Include& include : includes) {
        const std::string from = fs::path(include.file).parent_path().generic_string();
        const std::string to = fs::path("src/" + include.target).parent_path().generic_string();
        if (from == to || !fs::exists(kRoot / "src" / include.target)) continue;
        reached[from].insert(to);
        reached[to];
    }
    close(reached);
    return reached;
}

// Within a room too, no folder includes another that includes it.
TEST(Architecture, NoCircleBetweenFolders) {
    const std::string dicom = "src/dicom/";
    const auto circle = foldersReached({{dicom + "read/a.cpp", 1, "dicom/stack/stack.h"},
                                        {dicom + "stack/stack.h", 1, "dicom/split/split.h"},
                                        {dicom + "split/split.h", 1, "dicom/read/tags.h"}});
    EXPECT_TRUE(circle.at("src/dicom/read").contains("src/dicom/read")) << "a rule that never fires";
    std::vector<Include> includes;
    for (const fs::path& path : sourcesIn("src")) {
        const auto more = includesOf(path);
        includes.insert(includes.end(), more.begin(), more.end());
    }
    const auto reached = foldersReached(includes);
    EXPECT_GT(reached.size(), 60u) << "the sources were not found at " << kRoot;
    for (const auto& [folder, others] : reached) {
        for (const std::string& other : others) {
            const bool isBack = reached.at(other).contains(folder);
            EXPECT_FALSE(isBack) << folder << " and " << other << " include each other";
        }
    }
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

std::ptrdiff_t linesOf(const fs::path& path) {
    std::ifstream text(path);
    return std::count(std::istreambuf_iterator<char>(text), {}, '\n');
}

TEST(Architecture, NoFileIsTwoThings) {
    for (const char* folder : {"src", "shaders", "tests", "presets"}) {
        for (const fs::path& path : sourcesIn(folder)) {
            EXPECT_LE(linesOf(path), kMaxLines)
                << path.lexically_relative(kRoot) << ": split it by what it is about";
        }
    }
}

// A verb parses and prints. Other rooms do its work, where tests and other programs reach it.
TEST(Architecture, AVerbIsOptionsAndPrinting) {
    std::ptrdiff_t all = 0;
    std::ptrdiff_t files = 0;
    for (const char* folder : {"src/cli", "src/bench"}) {
        for (const fs::path& path : sourcesIn(folder)) {
            const std::ptrdiff_t lines = linesOf(path);
            EXPECT_LE(lines, kMaxLinesOfAVerb) << path.lexically_relative(kRoot);
            all += lines;
            ++files;
        }
    }
    ASSERT_GT(files, 0);
    // Not their sum, which grows with each verb.
    EXPECT_LE(all, kMaxMeanLinesOfVerbs * files);
}

// Who calls decides what is printed, and where to.
TEST(Architecture, WhatProgramsSharePrintsNothing) {
    for (const char* folder :
         {"src/study", "src/scene", "src/live", "src/pictures", "src/c", "src/evaluate"}) {
        for (const fs::path& path : sourcesIn(folder)) {
            std::ifstream stream(path);
            const std::string text{std::istreambuf_iterator<char>(stream), {}};
            for (const char* way : {"fmt::print", "std::cout", "std::cerr", "fputs", "printf(", "std::puts"})
                EXPECT_EQ(text.find(way), std::string::npos) << path.lexically_relative(kRoot) << ": " << way;
        }
    }
}

// Nothing else is told to the thread sanitizer.
TEST(Architecture, ThreadsReachTheWindowInOneWay) {
    Names ways;
    for (const fs::path& path : sourcesIn("src/viewer")) {
        std::ifstream stream(path);
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        for (const char* way : {"invokeMethod", "postEvent"})
            if (text.find(way) != std::string::npos) ways.insert(path.filename().string());
    }
    EXPECT_EQ(ways, Names{"post.cpp"});
}

}  // namespace

// What can be checked of a page in Markdown: its headings, links, paths and command lines.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace macula::test {

struct PageText {
    std::string text;
    int line = 0;
};

struct Page {
    std::set<std::string> anchors;    // of its headings, as GitHub makes them
    std::vector<PageText> links;      // targets of links and pictures, not those within code
    std::vector<PageText> codeSpans;  // what stands between single backticks
    std::vector<PageText> codeLines;  // of fenced and of indented blocks, without the indentation
};

Page readPage(std::string_view markdown);

// "file:line: why" for each relative link that leads to no file or to no heading, and each path of this
// repository in backticks that does not exist. `file` is what the page is, from `root`.
std::vector<std::string> brokenReferences(const Page& page, const std::filesystem::path& root,
                                          const std::filesystem::path& file);

// What the sources of this repository are called, and what is said in them.
struct Sources {
    std::vector<std::string> files;  // "/src/base/volume.h"
    std::set<std::string> words;     // identifiers, and words of comments
};
Sources readSources(const std::filesystem::path& root);

// "line: name" for each name in backticks that no source has: of a file ("trace/settings.h"), and of what is
// written in mixed case, as types and functions are ("PathTracer", "gpu::Device").
std::vector<std::string> unknownNames(const Page& page, const Sources& sources);

}  // namespace macula::test

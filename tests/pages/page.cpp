#include "pages/page.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>

namespace macula::test {
namespace {

namespace fs = std::filesystem;

// Lower case, spaces as hyphens, punctuation left out; letters beyond ASCII stay.
std::string anchorOf(std::string_view heading) {
    std::string anchor;
    for (const char c : heading) {
        const auto code = static_cast<unsigned char>(c);
        if (c == ' ')
            anchor += '-';
        else if (std::isalnum(code) || c == '-' || c == '_' || code >= 0x80)
            anchor += char(std::tolower(code));
    }
    return anchor;
}

void addHeading(Page& page, std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of("# "), line.size()));
    const std::string anchor = anchorOf(line);
    std::string unused = anchor;
    for (int i = 1; page.anchors.contains(unused); ++i) unused = anchor + "-" + std::to_string(i);
    page.anchors.insert(unused);
}

// Takes the code spans out of a line, so that what is left is prose.
std::string withoutCode(Page& page, std::string_view line, int number) {
    std::string prose;
    while (true) {
        const std::size_t open = line.find('`');
        const std::size_t close = open == std::string_view::npos ? open : line.find('`', open + 1);
        if (close == std::string_view::npos) return prose + std::string(line);
        prose += line.substr(0, open);
        page.codeSpans.push_back({std::string(line.substr(open + 1, close - open - 1)), number});
        line.remove_prefix(close + 1);
    }
}

void addLinks(Page& page, std::string_view prose, int number) {
    for (std::size_t at = prose.find("]("); at != std::string_view::npos; at = prose.find("](", at + 2)) {
        const std::size_t close = prose.find(')', at);
        if (close != std::string_view::npos)
            page.links.push_back({std::string(prose.substr(at + 2, close - at - 2)), number});
    }
}

bool isElsewhere(std::string_view target) {
    return target.starts_with("http://") || target.starts_with("https://") || target.starts_with("mailto:");
}

// A path of this repository; not "src/cli/NAME_command.cpp", "shaders/lib/splat_*.glsl" or "src/{a,b}".
bool isPath(std::string_view code) {
    const bool isOurs =
        std::ranges::any_of(std::vector<std::string_view>{"src/", "shaders/", "tests/", "docs/", "presets/",
                                                          "packaging/", "cmake/"},
                            [&](std::string_view folder) { return code.starts_with(folder); });
    return isOurs && code.find_first_of("*{}<>[] ") == std::string_view::npos &&
           code.find("NAME") == std::string_view::npos && code.find("…") == std::string_view::npos;
}

bool isWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// What stands for other names: conventions, and endings of files.
bool isPlaceholder(std::string_view name) {
    static const std::set<std::string, std::less<>> kConventions{"PascalCase", "camelCase", "kName"};
    return name.find("NAME") != std::string_view::npos || kConventions.contains(name) ||
           name.starts_with(".") || name.starts_with("_");
}

bool isFileName(std::string_view name) {
    static const std::set<std::string, std::less<>> kEndings{".h", ".cpp", ".inl", ".glsl", ".comp", ".json"};
    const std::size_t dot = name.rfind('.');
    return dot != std::string_view::npos && dot > 0 && kEndings.contains(name.substr(dot)) &&
           std::ranges::all_of(name, [](char c) { return isWord(c) || c == '.' || c == '/' || c == '-'; });
}

bool isInMixedCase(std::string_view name) {
    const auto has = [&](int (*is)(int)) {
        return std::ranges::any_of(name, [&](char c) { return is(static_cast<unsigned char>(c)) != 0; });
    };
    return has(std::isupper) && has(std::islower) &&
           std::ranges::all_of(name, [](char c) { return isWord(c) || c == ':'; });
}

}  // namespace

Page readPage(std::string_view markdown) {
    Page page;
    std::istringstream lines{std::string(markdown)};
    bool isFenced = false;
    bool mayIndent = true;  // an indented block follows an empty line, not a list or a paragraph
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.find_first_not_of(' ') != std::string::npos &&
            line.substr(line.find_first_not_of(' ')).starts_with("```")) {
            isFenced = !isFenced;
            continue;
        }
        const bool isIndented = mayIndent && line.starts_with("    ");
        if (isFenced || isIndented) {
            const std::size_t from = line.find_first_not_of(' ');
            if (from != std::string::npos) page.codeLines.push_back({line.substr(from), number});
            continue;
        }
        mayIndent = line.empty();
        if (line.starts_with("#")) addHeading(page, line);
        addLinks(page, withoutCode(page, line, number), number);
    }
    return page;
}

std::vector<std::string> brokenReferences(const Page& page, const fs::path& root, const fs::path& file) {
    std::vector<std::string> broken;
    const auto tell = [&](const PageText& at, const std::string& why) {
        broken.push_back(file.generic_string() + ":" + std::to_string(at.line) + ": " + at.text + " " + why);
    };
    for (const PageText& link : page.links) {
        if (isElsewhere(link.text)) continue;
        const std::size_t hash = link.text.find('#');
        const std::string target = link.text.substr(0, hash);
        const fs::path path = target.empty() ? root / file : root / file.parent_path() / target;
        if (!target.empty() && !fs::exists(path)) {
            tell(link, "leads to no file");
        } else if (hash != std::string::npos) {
            std::ifstream stream(path);
            const std::string text{std::istreambuf_iterator<char>(stream), {}};
            const Page other = target.empty() ? page : readPage(text);
            if (!other.anchors.contains(link.text.substr(hash + 1))) tell(link, "leads to no heading");
        }
    }
    for (const PageText& code : page.codeSpans) {
        if (isPath(code.text) && !fs::exists(root / code.text)) tell(code, "does not exist");
    }
    return broken;
}

Sources readSources(const fs::path& root) {
    Sources sources;
    for (const char* folder : {"src", "shaders", "tests", "presets", "cmake"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            if (!entry.is_regular_file()) continue;
            sources.files.push_back("/" + entry.path().lexically_relative(root).generic_string());
            if (std::string_view(folder) != "src" && std::string_view(folder) != "shaders") continue;
            std::ifstream stream(entry.path());
            std::string word;
            for (auto c = std::istreambuf_iterator<char>(stream); c != std::istreambuf_iterator<char>();
                 ++c) {
                if (isWord(*c)) {
                    word += *c;
                } else if (!word.empty()) {
                    sources.words.insert(std::move(word));
                    word.clear();
                }
            }
        }
    }
    return sources;
}

std::vector<std::string> unknownNames(const Page& page, const Sources& sources) {
    std::vector<std::string> unknown;
    for (const PageText& code : page.codeSpans) {
        const std::string& name = code.text;
        if (isPlaceholder(name)) continue;
        bool isKnown = true;
        if (isFileName(name)) {
            isKnown = std::ranges::any_of(
                sources.files, [&](const std::string& file) { return file.ends_with("/" + name); });
        } else if (isInMixedCase(name)) {
            std::istringstream parts(name);
            for (std::string part; std::getline(parts, part, ':');)
                isKnown = isKnown && (part.empty() || sources.words.contains(part));
        }
        if (!isKnown) unknown.push_back(std::to_string(code.line) + ": " + name);
    }
    return unknown;
}

}  // namespace macula::test

#include "pictures/picture_names.h"

#include <fmt/format.h>

#include <array>
#include <set>
#include <string_view>

#include "base/parsing.h"
#include "base/utf8.h"

namespace macula::pictures {

namespace {

constexpr std::size_t kMostBytes = 120;
// Endings of picture files; another ending may be part of a name: "view.2".
constexpr std::array<std::string_view, 10> kEndings{".png", ".jpg",  ".jpeg", ".tif", ".tiff",
                                                    ".exr", ".webp", ".bmp",  ".dng", ".heic"};

bool isSafe(char c) {
    const auto u = static_cast<unsigned char>(c);
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '.' ||
           c == '-' || c == '_' || u >= 0x80;
}

std::vector<std::string> partsOf(const std::string& path) {
    std::vector<std::string> parts{""};
    for (const char c : path) {
        if (c == '/' || c == '\\') {
            parts.emplace_back();
        } else {
            parts.back() += isSafe(c) ? c : '_';
        }
    }
    std::erase_if(parts, [](const std::string& part) {
        return part.find_first_not_of('.') == std::string::npos;  // "", "." and ".." too
    });
    return parts;
}

bool isFromRoot(const std::string& path) {
    return path.starts_with('/') || path.starts_with('\\') || (path.size() > 1 && path[1] == ':');
}

std::string nameOf(const std::string& request) {
    std::vector<std::string> parts = partsOf(request);
    if (parts.empty()) return {};
    if (isFromRoot(request)) parts.erase(parts.begin(), parts.end() - 1);
    std::string name = fmt::format("{}", fmt::join(parts, "_"));
    for (const std::string_view ending : kEndings) {
        if (name.size() > ending.size() && lowerCase(name).ends_with(ending)) {
            name.resize(name.size() - ending.size());
            break;
        }
    }
    name.erase(0, name.find_first_not_of('.'));  // no hidden files
    name.resize(startOf(name, kMostBytes).size());
    return name.find_first_not_of("._-") == std::string::npos ? std::string() : name;
}

}  // namespace

std::vector<std::string> pictureNames(std::span<const std::string> requests) {
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (std::size_t i = 0; i < requests.size(); ++i) {
        std::string name = nameOf(requests[i]);
        if (name.empty()) name = fmt::format("camera_{:04}", i);
        std::string unique = name;
        for (int n = 2; !taken.insert(lowerCase(unique)).second; ++n) unique = fmt::format("{}_{}", name, n);
        names.push_back(std::move(unique));
    }
    return names;
}

}  // namespace macula::pictures

#include "unpack/safe_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace macula::unpack {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostParts = 16;
constexpr std::size_t kMostOfPart = 100;         // bytes
constexpr std::size_t kMostOfName = 512;         // bytes that are remembered of a part
constexpr std::size_t kMostOfExtension = 8;      // with its point
constexpr std::string_view kSeparators = "/\\";  // the second by programs that do as Windows does

bool isPlain(std::string_view text) {
    return std::ranges::all_of(text, [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_' || c == '.';
    });
}

std::vector<std::string_view> partsOf(std::string_view name) {
    std::vector<std::string_view> parts;
    while (!name.empty()) {
        const std::size_t end = std::min(name.find_first_of(kSeparators), name.size());
        const std::string_view part = name.substr(0, end);
        if (!part.empty() && part != ".") parts.push_back(part);
        name.remove_prefix(std::min(end + 1, name.size()));
    }
    return parts;
}

std::string_view extensionOf(std::string_view part) {
    const std::size_t point = part.rfind('.');
    if (point == std::string_view::npos || point == 0) return {};
    const std::string_view extension = part.substr(point);
    return extension.size() > 1 && extension.size() <= kMostOfExtension && isPlain(extension)
               ? extension
               : std::string_view();
}

}  // namespace

bool SafeNames::isLeftByMacOs(std::string_view nameInArchive) {
    return std::ranges::any_of(partsOf(nameInArchive), [](std::string_view part) {
        return part.starts_with("._") || part == ".DS_Store" || part == "__MACOSX";
    });
}

SafeNames::Place SafeNames::placeOf(std::string_view nameInArchive) {
    const std::vector<std::string_view> parts = partsOf(nameInArchive);
    Place place;
    const bool leadsUp = std::ranges::find(parts, std::string_view("..")) != parts.end();
    place.wasOutside = leadsUp || (!nameInArchive.empty() &&
                                   kSeparators.find(nameInArchive.front()) != std::string_view::npos);
    if (leadsUp || parts.empty() || parts.size() > kMostParts) {
        place.path = otherPlace();
        if (!parts.empty()) place.path += extensionOf(parts.back());
        return place;
    }
    for (const std::string_view part : parts) {
        const bool isKept = part.size() <= kMostOfPart && !part.starts_with('.') && isPlain(part);
        place.path /= isKept ? std::string(part) : numbered(place.path, part);
    }
    return place;
}

fs::path SafeNames::otherPlace() {
    return fmt::format("n{:06}", ++last_);
}

std::string SafeNames::numbered(const fs::path& folder, std::string_view part) {
    const std::string key = folder.native() + '/' + std::string(part.substr(0, kMostOfName));
    std::string& number = numbers_[key];
    if (number.empty()) number = otherPlace().native() + std::string(extensionOf(part));
    return number;
}

}  // namespace macula::unpack

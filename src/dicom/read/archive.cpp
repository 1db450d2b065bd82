#include "dicom/read/archive.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "dicom/read/random_file.h"

namespace macula::dicom {

namespace {

using namespace std::string_view_literals;

struct Kind {
    std::string_view name;
    std::size_t at = 0;
    std::string_view magic;
    std::array<std::string_view, 5> endings;  // that names may have, besides none and those of DICOM
};

constexpr std::array kKinds = std::to_array<Kind>({
    {"zip", 0, "PK\x03\x04"sv, {".zip"}},
    {"gzip", 0, "\x1f\x8b\x08"sv, {".gz", ".tgz"}},
    {"bzip2", 0, "BZh"sv, {".bz2", ".tbz2", ".tbz"}},
    {"xz", 0, "\xfd\x37zXZ\0"sv, {".xz", ".txz"}},
    {"Zstandard", 0, "\x28\xb5\x2f\xfd"sv, {".zst", ".tzst"}},
    {"7z", 0, "7z\xbc\xaf\x27\x1c"sv, {".7z"}},
    {"RAR", 0, "Rar!\x1a\x07"sv, {".rar"}},
    {"tar", 257, "ustar"sv, {".tar"}},
});

std::string lowerCase(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

bool fits(const Kind& kind, const std::filesystem::path& file) {
    const std::string ending = lowerCase(file.extension().string());
    constexpr std::array kOfImages{""sv, ".dcm"sv, ".dicom"sv, ".ima"sv, ".img"sv};
    if (std::ranges::find(kind.endings, ending) == kind.endings.end() &&
        std::ranges::find(kOfImages, ending) == kOfImages.end())
        return false;
    // Compressed files of other kinds, such as volume.nii.gz, are not archives.
    const std::string inside = lowerCase(file.stem().extension().string());
    return inside != ".nii" && inside != ".nrrd" && inside != ".spz" && inside != ".svg";
}

}  // namespace

std::string_view archiveKind(const std::filesystem::path& file) {
    constexpr std::size_t kHead = 262;
    const RandomFile opened(file);
    std::array<std::byte, kHead> head{};
    std::size_t size = head.size();
    if (!opened.read(0, head)) {
        // A shorter file cannot have the magic that lies far behind its beginning.
        constexpr std::size_t kShort = 6;
        size = kShort;
        if (!opened.read(0, std::span(head).first(kShort))) return {};
    }
    const std::string_view begin(reinterpret_cast<const char*>(head.data()), size);
    for (const Kind& kind : kKinds) {
        if (begin.size() > kind.at && begin.substr(kind.at).starts_with(kind.magic))
            return fits(kind, file) ? kind.name : std::string_view();
    }
    return {};
}

}  // namespace macula::dicom

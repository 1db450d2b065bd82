#include "pipeline/hybrid/views/picture_cache.h"

#include <bit>
#include <cstring>
#include <span>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/sha256.h"
#include "pipeline/trace/settings.h"

namespace macula::hybrid {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr int kMostSide = trace::kMaxPictureSide;
constexpr std::size_t kMostHeader = 512;

std::string_view bytesOf(const std::vector<glm::vec4>& rgba) {
    const auto bytes = std::as_bytes(std::span(rgba));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// The header, with a digest of its own numbers and of the pixels that follow.
std::string headerOf(const std::string& key, const KeptPicture& picture) {
    const std::string numbers = fmt::format("{}\n{} {}\n", key, picture.sizePx.x, picture.sizePx.y);
    return fmt::format("macula picture 2\n{}{}\n", numbers,
                       sha256Hex(numbers + sha256Hex(bytesOf(picture.rgba))));
}

std::size_t pixelsOf(const glm::ivec2& size) {
    return std::size_t(size.x) * std::size_t(size.y);
}

}  // namespace

fs::path PictureCache::fileOf(const std::string& key) const {
    MACULA_CHECK(key.size() == 64 && key.find_first_not_of("0123456789abcdef") == std::string::npos);
    return folder_ / (key + ".rgba");
}

Result<void> PictureCache::prepare() const {
    std::error_code error;
    if (folder_.empty() || fs::is_directory(folder_, error)) return {};
    if (!fs::create_directories(folder_, error) || error)
        return Error{ErrorCode::outputNotWritable, Text("The folder for pictures cannot be made."),
                     folder_.string(), Text("Check the path and the permissions.")};
    return {};
}

std::optional<KeptPicture> PictureCache::find(const std::string& key) const {
    if (folder_.empty()) return {};
    constexpr std::size_t kMostBytes = std::size_t(kMostSide) * kMostSide * sizeof(glm::vec4) + kMostHeader;
    const auto text = readText(fileOf(key), kMostBytes);
    if (!text) return {};
    KeptPicture picture;
    int used = 0;
    const std::string format = "macula picture 2\n" + key + "\n%6d %6d\n%*64s\n%n";
    // No valid header is longer than kMostHeader.
    const std::string start = text->substr(0, kMostHeader);
    if (std::sscanf(start.c_str(), format.c_str(), &picture.sizePx.x, &picture.sizePx.y, &used) != 2 ||
        used == 0 || picture.sizePx.x < 1 || picture.sizePx.y < 1 || picture.sizePx.x > kMostSide ||
        picture.sizePx.y > kMostSide)
        return {};
    const std::size_t pixels = pixelsOf(picture.sizePx);
    // The end of the header is counted from the end of the file, because the newline in the format also skips
    // pixel bytes that look like white space.
    if (text->size() < pixels * sizeof(glm::vec4)) return {};
    const std::size_t header = text->size() - pixels * sizeof(glm::vec4);
    picture.rgba.resize(pixels);
    std::memcpy(picture.rgba.data(), text->data() + header, pixels * sizeof(glm::vec4));
    if (text->compare(0, header, headerOf(key, picture)) != 0) return {};
    return picture;
}

Result<void> PictureCache::keep(const std::string& key, const KeptPicture& picture) const {
    if (folder_.empty()) return {};
    MACULA_CHECK_EQ(picture.rgba.size(), pixelsOf(picture.sizePx));
    std::string text = headerOf(key, picture);
    text += bytesOf(picture.rgba);
    return writeTextAtomically(fileOf(key), text);
}

}  // namespace macula::hybrid

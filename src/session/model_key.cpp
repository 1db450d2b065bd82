#include "session/model_key.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/sha256.h"

namespace macula::session {

namespace {

constexpr std::size_t kDigestLength = 64;

bool isPartName(std::string_view name) {
    return !name.empty() && name.size() <= 40 &&
           name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string_view::npos;
}

}  // namespace

bool isDigest(std::string_view text) {
    return text.size() == kDigestLength &&
           text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

// The prefixes keep a study and a series from ever having the same identity.
std::string studyIdentity(std::string_view studyUid) {
    return sha256Hex(fmt::format("macula study\n{}\n{}", studyUid.size(), studyUid));
}

std::string seriesIdentity(std::string_view studyUid, std::string_view seriesUid) {
    return sha256Hex(
        fmt::format("macula series\n{}\n{}\n{}\n{}", studyUid.size(), studyUid, seriesUid.size(), seriesUid));
}

std::string textOfParts(std::vector<KeyPart> parts) {
    std::ranges::sort(parts, {}, &KeyPart::name);
    std::string text;
    for (const KeyPart& part : parts) text += part.name + "=" + part.digest + "\n";
    return text;
}

bool partsOfText(std::string_view text, std::vector<KeyPart>& parts) {
    parts.clear();
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::size_t equals = text.find('=');
        if (end == std::string_view::npos || equals == std::string_view::npos || equals > end) return false;
        KeyPart part{std::string(text.substr(0, equals)),
                     std::string(text.substr(equals + 1, end - equals - 1))};
        const bool isNext = parts.empty() || parts.back().name < part.name;
        if (!isNext || !isPartName(part.name) || !isDigest(part.digest)) return false;
        parts.push_back(std::move(part));
        text.remove_prefix(end + 1);
    }
    return true;
}

bool ModelKey::isValid() const {
    std::vector<KeyPart> read;
    return isDigest(volume) && partsOfText(textOfParts(parts), read) && read.size() == parts.size();
}

std::string ModelKey::digest() const {
    return sha256Hex(fmt::format("macula model\n{}\n{}\n{}", volume, trainer, textOfParts(parts)));
}

std::vector<std::string> differences(const ModelKey& a, const ModelKey& b) {
    std::vector<std::string> names;
    if (a.trainer != b.trainer) names.emplace_back("trainer");
    if (a.volume != b.volume) names.emplace_back("volume");
    for (const ModelKey* key : {&a, &b}) {
        const ModelKey& other = key == &a ? b : a;
        for (const KeyPart& part : key->parts)
            if (std::ranges::find(other.parts, part) == other.parts.end()) names.push_back(part.name);
    }
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

}  // namespace macula::session

#include "scene/segments/own_segments_json.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "scene/segments/own_segments.h"

namespace macula::scene {

namespace {

using nlohmann::json;

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string base64Of(const std::vector<std::uint8_t>& bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t n = 0; n < bytes.size(); n += 3) {
        unsigned word = unsigned(bytes[n]) << 16;
        if (n + 1 < bytes.size()) word |= unsigned(bytes[n + 1]) << 8;
        if (n + 2 < bytes.size()) word |= unsigned(bytes[n + 2]);
        for (int part = 0; part < 4; ++part)
            text += n + std::size_t(part) <= bytes.size() ? kDigits[word >> (18 - 6 * part) & 63u] : '=';
    }
    return text;
}

// Nothing for text that is no base64.
std::optional<std::vector<std::uint8_t>> fromBase64(std::string_view text) {
    if (text.size() % 4 != 0) return std::nullopt;
    std::array<int, 256> valueOf{};
    valueOf.fill(-1);
    for (std::size_t n = 0; n < kDigits.size(); ++n) valueOf[std::uint8_t(kDigits[n])] = int(n);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(text.size() / 4 * 3);
    unsigned word = 0;
    std::size_t digits = 0;
    std::size_t fill = 0;
    for (const char c : text) {
        const int value = valueOf[std::uint8_t(c)];
        if (c == '=') {
            ++fill;
        } else if (value < 0 || fill > 0) {
            return std::nullopt;
        }
        word = word << 6 | unsigned(std::max(value, 0));
        if (++digits % 4 != 0) continue;
        for (const unsigned shift : {16u, 8u, 0u}) bytes.push_back(std::uint8_t(word >> shift));
        word = 0;
    }
    if (fill > 2) return std::nullopt;
    bytes.resize(bytes.size() - fill);
    return bytes;
}

void putNumber(std::vector<std::uint8_t>& to, std::uint64_t number) {
    constexpr unsigned kMore = 0x80u;
    for (; number >= kMore; number >>= 7) to.push_back(std::uint8_t(number | kMore));
    to.push_back(std::uint8_t(number));
}

// Voxels outside of the set and voxels in it, in turn, through the box.
std::vector<std::uint8_t> runsOf(const VoxelSet& set) {
    std::vector<std::uint8_t> bytes;
    const glm::ivec3 size = set.high() - set.low() + 1;
    std::uint64_t end = 0;  // of the last run
    std::uint64_t length = 0;
    set.forEach([&](const glm::ivec3& voxel) {
        const glm::ivec3 at = voxel - set.low();
        const std::uint64_t place =
            (std::uint64_t(at.z) * std::uint64_t(size.y) + std::uint64_t(at.y)) * std::uint64_t(size.x) +
            std::uint64_t(at.x);
        if (length > 0 && place == end) {
            ++length;
            ++end;
            return;
        }
        if (length > 0) putNumber(bytes, length);
        putNumber(bytes, place - end);
        end = place + 1;
        length = 1;
    });
    if (length > 0) putNumber(bytes, length);
    return bytes;
}

// Nothing for runs that leave the box.
std::optional<VoxelSet> setOfRuns(const std::vector<std::uint8_t>& bytes, const glm::ivec3& low,
                                  const glm::ivec3& high) {
    const glm::ivec3 size = high - low + 1;
    const std::uint64_t most = std::uint64_t(size.x) * std::uint64_t(size.y) * std::uint64_t(size.z);
    VoxelSet set(low, high);
    std::uint64_t place = 0;
    std::uint64_t number = 0;
    unsigned shift = 0;
    bool isIn = false;
    for (const std::uint8_t byte : bytes) {
        constexpr unsigned kMostShift = 56;
        if (shift > kMostShift) return std::nullopt;
        number |= std::uint64_t(byte & 0x7Fu) << shift;
        shift += 7;
        if ((byte & 0x80u) != 0) continue;
        if (number > most - place) return std::nullopt;
        for (const std::uint64_t end = place + number; isIn && place < end; ++place)
            set.add(low + glm::ivec3(int(place % std::uint64_t(size.x)),
                                     int(place / std::uint64_t(size.x) % std::uint64_t(size.y)),
                                     int(place / std::uint64_t(size.x) / std::uint64_t(size.y))));
        if (!isIn) place += number;
        isIn = !isIn;
        number = 0;
        shift = 0;
    }
    return shift == 0 ? std::optional(set.cropped()) : std::nullopt;
}

json toJson(const glm::ivec3& v) {
    return {v.x, v.y, v.z};
}

glm::ivec3 vectorFrom(const json& from) {
    return {from.at(0).get<int>(), from.at(1).get<int>(), from.at(2).get<int>()};
}

json toJson(const Segment& segment, const VoxelSet& voxels) {
    json to{{"number", segment.number},
            {"label", segment.label},
            {"description", segment.description},
            {"algorithm", segment.algorithm},
            {"algorithmName", segment.algorithmName}};
    if (segment.recommendedRgb) to["rgb"] = *segment.recommendedRgb;
    if (voxels.isEmpty()) return to;
    to["low"] = toJson(voxels.low());
    to["high"] = toJson(voxels.high());
    to["runs"] = base64Of(runsOf(voxels));
    return to;
}

// Throws json::exception for missing members; nothing for voxels beyond the volume.
std::optional<OwnSegment> segmentFrom(const json& from, const Volume& volume) {
    OwnSegment own;
    own.segment.number = from.at("number").get<std::uint16_t>();
    own.segment.label = from.at("label").get<std::string>();
    own.segment.description = from.value("description", std::string());
    own.segment.algorithm = from.value("algorithm", std::string());
    own.segment.algorithmName = from.value("algorithmName", std::string());
    if (from.contains("rgb")) own.segment.recommendedRgb = from.at("rgb").get<std::array<std::uint8_t, 3>>();
    if (!from.contains("runs")) {
        own.voxels = std::make_shared<const VoxelSet>();
        return own;
    }
    const glm::ivec3 low = vectorFrom(from.at("low"));
    const glm::ivec3 high = vectorFrom(from.at("high"));
    if (glm::any(glm::lessThan(low, glm::ivec3(0))) || glm::any(glm::greaterThan(low, high)) ||
        glm::any(glm::greaterThanEqual(high, volume.size())))
        return std::nullopt;
    const auto bytes = fromBase64(from.at("runs").get_ref<const std::string&>());
    auto set = bytes ? setOfRuns(*bytes, low, high) : std::nullopt;
    if (!set) return std::nullopt;
    own.voxels = std::make_shared<const VoxelSet>(*std::move(set));
    return own;
}

Error notReadable() {
    return {ErrorCode::inputNotUsable,
            Text("The own segments of this study cannot be read."),
            {},
            Text("They stay stored as they are; a newer version of the program may read them.")};
}

}  // namespace

Result<std::string> toJson(const study::LoadedSegmentation& revision, const Volume& volume) {
    json segments = json::array();
    for (const study::LoadedSegment& each : revision.segments)
        segments.push_back(toJson(each.segment, each.voxels->cropped()));
    const json whole{{"digest", revision.digest}, {"size", toJson(volume.size())}, {"segments", segments}};
    std::string text = whole.dump(-1, ' ', true, json::error_handler_t::replace);
    if (text.size() > kMostOwnJsonBytes)
        return Error{
            ErrorCode::usage,
            Text("The own segments of this study are too large to be kept with it."),
            {},
            Text("Save them as a file, or make them smoother: single voxels take most of the room.")};
    return text;
}

Result<std::shared_ptr<const study::LoadedSegmentation>> ownRevisionFromJson(std::string_view text,
                                                                             const Volume& volume) try {
    const json whole = json::parse(text);
    const auto digest = whole.at("digest").get<std::string>();
    const json& segments = whole.at("segments");
    const bool isDigest =
        digest.size() == 64 && digest.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!isDigest || vectorFrom(whole.at("size")) != volume.size() || !segments.is_array() ||
        segments.size() > kMostOwnSegments)
        return notReadable();
    std::vector<OwnSegment> own;
    for (const json& each : segments) {
        auto segment = segmentFrom(each, volume);
        const bool isUsable =
            segment && segment->segment.number > 0 && std::ranges::none_of(own, [&](const OwnSegment& other) {
                return other.segment.number == segment->segment.number;
            });
        if (!isUsable) return notReadable();
        own.push_back(*std::move(segment));
    }
    return ownRevision(std::move(own), volume, digest);
} catch (const json::exception&) {
    return notReadable();
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory,
                 Text("There is not enough memory for the own segments of this study."),
                 {},
                 Text("Close other programs, and open the study again.")};
}

}  // namespace macula::scene

#include "study/open/volume_key.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/sha256.h"

namespace macula::study {

namespace {

// Rounds, because programs write the same direction with different numbers of digits.
long long thousandths(double value) {
    return std::llround(1000.0 * value);
}

std::string directionText(const glm::dvec3& direction) {
    return fmt::format(" {} {} {}", thousandths(direction.x), thousandths(direction.y),
                       thousandths(direction.z));
}

std::string factsOf(const dicom::Stack& stack) {
    if (stack.frames.empty()) return {};
    const dicom::Frame& first = stack.frames.front();
    std::string facts = fmt::format("{} {}", stack.modality, first.frameOfReferenceUid);
    if (first.plane)
        facts += directionText(first.plane->rowDirection) + directionText(first.plane->columnDirection);
    for (std::size_t n = 0; n < first.attributes.size(); ++n) {
        const std::string& value = first.attributes[n];
        const bool isOfAll = std::ranges::all_of(stack.frames, [&](const dicom::Frame& frame) {
            return n < frame.attributes.size() && frame.attributes[n] == value;
        });
        // Written with its length, so that no value can be mistaken for two.
        if (isOfAll && !value.empty()) facts += fmt::format(" {}:{}:{}", n, value.size(), value);
    }
    return facts;
}

}  // namespace

std::vector<std::string> volumeKeys(std::span<const FoundVolume> volumes) {
    std::map<std::pair<const dicom::Series*, std::string>, int> alike;
    std::vector<std::string> keys;
    keys.reserve(volumes.size());
    for (const FoundVolume& volume : volumes) {
        std::string digest = sha256Hex(factsOf(*volume.stack));
        const int count = ++alike[{volume.series, digest}];
        keys.push_back(count == 1 ? std::move(digest) : fmt::format("{}-{}", digest, count));
    }
    return keys;
}

}  // namespace macula::study

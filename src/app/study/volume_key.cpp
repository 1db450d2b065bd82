#include "app/study/volume_key.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/sha256.h"

namespace macula::app {

namespace {

// Written by programs in different digits.
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
        // By its length, so that no value can be taken for two.
        if (isOfAll && !value.empty()) facts += fmt::format(" {}:{}:{}", n, value.size(), value);
    }
    return facts;
}

}  // namespace

std::string volumeKey(const FoundVolumes& found, std::size_t index) {
    MACULA_CHECK(index < found.volumes().size());
    const FoundVolume& volume = found.volumes()[index];
    const std::string facts = factsOf(*volume.stack);
    int before = 0;
    for (std::size_t n = 0; n < index; ++n) {
        const FoundVolume& other = found.volumes()[n];
        if (other.series == volume.series && factsOf(*other.stack) == facts) ++before;
    }
    const std::string digest = sha256Hex(facts);
    return before == 0 ? digest : fmt::format("{}-{}", digest, before + 1);
}

}  // namespace macula::app

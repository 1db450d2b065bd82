#include "pipeline/volume/mask_bits.h"

#include <algorithm>

#include "base/check.h"
#include "base/parallel.h"

namespace macula {

bool MaskBits::showsAny(const glm::ivec3& low, const glm::ivec3& high) const {
    for (int k = low.z; k <= high.z; ++k) {
        for (int j = low.y; j <= high.y; ++j) {
            for (int i = low.x; i <= high.x; ++i) {
                if (shows(i, j, k)) return true;
            }
        }
    }
    return false;
}

MaskBits maskBits(const Mask& mask, const Volume& volume) {
    const glm::ivec3 size = volume.size();
    if (mask.bits) {
        MACULA_CHECK(mask.bits->size == size);
        return *mask.bits;
    }
    const LabelMap& map = *mask.labels;
    const glm::ivec3 mapSize = map.size();
    const glm::dmat4 labelFromVoxel = glm::inverse(map.worldFromVoxel()) * volume.worldFromVoxel();
    std::vector<bool> chosen(65536, mask.numbers.empty());
    if (mask.numbers.empty()) {
        chosen[0] = false;
    } else {
        for (const std::uint16_t number : mask.numbers) chosen[number] = true;
    }
    const bool keep = mask.keep == Keep::inside;
    MaskBits bits{size, {}};
    const std::size_t row = std::size_t(size.x);
    const std::size_t voxels = row * std::size_t(size.y) * std::size_t(size.z);
    bits.words.resize((voxels + 31) / 32);
    // Rows share words, so work is divided by words: only one thread writes each.
    constexpr std::size_t kWords = 4096;
    parallelFor((bits.words.size() + kWords - 1) / kWords, [&](std::size_t portion) {
        const std::size_t end = std::min(voxels, (portion + 1) * kWords * 32);
        for (std::size_t n = portion * kWords * 32; n < end; ++n) {
            const std::size_t j = n / row % std::size_t(size.y);
            const std::size_t k = n / row / std::size_t(size.y);
            const glm::dvec3 voxel(double(n % row), double(j), double(k));
            const glm::ivec3 at = glm::ivec3(glm::floor(transformPoint(labelFromVoxel, voxel) + 0.5));
            const bool inMap =
                glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) && glm::all(glm::lessThan(at, mapSize));
            const bool inside = inMap && chosen[map.label(at.x, at.y, at.z)];
            if (inside == keep) bits.words[n / 32] |= 1u << (n % 32);
        }
    });
    return bits;
}

}  // namespace macula

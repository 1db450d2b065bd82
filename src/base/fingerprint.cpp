#include "base/fingerprint.h"

#include <fmt/format.h>

#include <vector>

#include "base/parallel.h"
#include "base/sha256.h"

namespace macula {

std::string fingerprint(const Volume& volume) {
    const glm::ivec3 size = volume.size();
    // {:a} is exact, and the same in every locale. The unit keeps the spelling of the first stored digests: a
    // new display name must not change the digest of a volume.
    const std::string unit =
        volume.unitName() == unitSymbol(Unit::suvBodyWeight) ? "g/mL" : volume.unitName();
    std::string text = fmt::format("{} {} {}", size.x, size.y, size.z);
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) text += fmt::format(" {:a}", volume.worldFromVoxel()[column][row]);
    }
    text += fmt::format(" {:a} {:a} {}", volume.unitsFromStored().slope, volume.unitsFromStored().intercept,
                        unit);
    if (const auto& padding = volume.padding()) text += fmt::format(" {} {}", padding->low, padding->high);
    if (const auto& padding = volume.floatPadding()) text += fmt::format(" {:a}", *padding);

    const bool isFloat = volume.format() == VoxelFormat::float32;
    text += isFloat ? " float32" : " stored16";
    const auto slices = static_cast<std::size_t>(size.z);
    const std::size_t sliceVoxels = volume.voxelCount() / slices;
    std::vector<std::string> digests(slices);
    parallelFor(slices, [&](std::size_t k) {
        const std::size_t first = k * sliceVoxels;
        digests[k] = sha256Hex(isFloat ? std::as_bytes(volume.floatVoxels().subspan(first, sliceVoxels))
                                       : std::as_bytes(volume.voxels().subspan(first, sliceVoxels)));
    });
    for (const std::string& digest : digests) text += " " + digest;
    return sha256Hex(text);
}

}  // namespace macula

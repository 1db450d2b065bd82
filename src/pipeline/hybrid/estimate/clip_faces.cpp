#include "pipeline/hybrid/estimate/clip_faces.h"

#include <algorithm>
#include <iterator>

#include "pipeline/splat/draw/displayed.h"

namespace macula::hybrid {

namespace {

constexpr glm::ivec3 kSteps[] = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};

class FaceSearch {
  public:
    FaceSearch(const CoarseMatter& matter, const ShownMatter& shown)
        : matter_(matter),
          shown_(shown),
          half_(0.5 * matter.cellMm() / matter.volume().spacingMm()),
          apart_(glm::ceil(half_)),
          worldFromVoxel_(matter.volume().worldFromVoxel()) {}

    void inCell(std::size_t cell, std::vector<FacePlace>& found) const {
        if (!isCut(cell)) return;
        for (std::size_t s = 0; s < CoarseMatter::kSamples; ++s) {
            const glm::dvec3 voxel(matter_.voxelOf(cell, s));
            if (isRepeated(cell, s)) continue;
            if (!shown_.shows(matter_.volume(), voxel)) continue;
            glm::dvec3 outwards{0.0};
            glm::dvec3 firstRemoved{0.0};
            for (const glm::ivec3& step : kSteps) {
                const glm::dvec3 by = glm::dvec3(step) * apart_;
                if (shown_.isInShape(matter_.volume(), voxel + by)) continue;
                outwards += worldFromVoxel_ * by;
                if (firstRemoved == glm::dvec3(0.0)) firstRemoved = worldFromVoxel_ * by;
            }
            // A slab so thin that both sides are removed has no net direction: either one will do.
            if (!(glm::length(outwards) > 0.0)) outwards = firstRemoved;
            if (!(glm::length(outwards) > 0.0)) continue;
            const GreyValues& values = *shown_.faces;
            const float entry = matter_.entriesOf(cell)[s];
            const float grey = std::clamp((entry - values.low) / (values.high - values.low), 0.0f, 1.0f);
            if (!(grey > 0.0f) && !values.belowIsBlack) continue;
            found.push_back({.cell = std::uint32_t(cell),
                             .voxel = voxel,
                             .outwards = glm::normalize(outwards),
                             .radiance = splat::lightOfGrey(grey, values.keepsHue) / values.exposure});
        }
    }

  private:
    // In a cell of few voxels several octants sample the same voxel.
    bool isRepeated(std::size_t cell, std::size_t s) const {
        const glm::ivec3 voxel = matter_.voxelOf(cell, s);
        for (std::size_t before = 0; before < s; ++before) {
            if (matter_.voxelOf(cell, before) == voxel) return true;
        }
        return false;
    }
    // Whether the shape ends within an edge of the middle of the cell.
    bool isCut(std::size_t cell) const {
        const glm::dvec3 middle = (glm::dvec3(matter_.cellAt(cell)) + 0.5) * 2.0 * half_ - 0.5;
        const bool isIn = shown_.isInShape(matter_.volume(), middle);
        return std::any_of(std::begin(kSteps), std::end(kSteps), [&](const glm::ivec3& step) {
            return shown_.isInShape(matter_.volume(), middle + 2.0 * glm::dvec3(step) * half_) != isIn;
        });
    }

    const CoarseMatter& matter_;
    const ShownMatter& shown_;
    glm::dvec3 half_;   // of a cell, voxels
    glm::dvec3 apart_;  // largest distance of neighbouring samples, whole voxels
    glm::dmat3 worldFromVoxel_;
};

}  // namespace

std::vector<FacePlace> facePlaces(const CoarseMatter& matter, const ShownMatter& shown) {
    if (!shown.faces || !shown.clip.hasShape()) return {};
    const FaceSearch search(matter, shown);
    const auto layers = std::size_t(matter.size().z);
    const std::size_t layer = matter.cellCount() / layers;
    std::vector<std::vector<FacePlace>> found(layers);
    forEachCell(matter, shown, 1, [&](std::size_t cell, PartShown part) {
        if (part == PartShown::some) search.inCell(cell, found[cell / layer]);
    });
    std::vector<FacePlace> all;
    for (const std::vector<FacePlace>& some : found) all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace macula::hybrid

#include "pipeline/hybrid/estimate/coarse_matter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "base/parallel.h"
#include "pipeline/volume/voxel_gradient.h"

namespace macula::hybrid {

namespace {

// The edges in voxels of cells that measure about `mm`.
glm::ivec3 edgesFor(double mm, const glm::dvec3& spacingMm, const glm::ivec3& voxels) {
    return glm::clamp(glm::ivec3(glm::round(mm / spacingMm)), glm::ivec3(1), voxels);
}

glm::ivec3 cellsFor(const glm::ivec3& edge, const glm::ivec3& voxels) {
    return (voxels + edge - 1) / edge;
}

std::size_t countOf(const glm::ivec3& size) {
    return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
}

}  // namespace

CoarseMatter::CoarseMatter(std::shared_ptr<const Volume> volume, std::size_t mostCells)
    : volume_(std::move(volume)), map_(entryMapOf(*volume_)) {
    MACULA_CHECK(volume_->format() == VoxelFormat::stored16 && mostCells > 0);
    const glm::ivec3 voxels = volume_->size();
    const glm::dvec3 spacing = volume_->spacingMm();
    // A search, because rounding to whole voxels can make more cells than the size suggests.
    for (double mm = std::min({spacing.x, spacing.y, spacing.z});; mm *= 1.05) {
        edge_ = edgesFor(mm, spacing, voxels);
        size_ = cellsFor(edge_, voxels);
        if (countOf(size_) <= mostCells) break;
    }
    entries_.resize(cellCount() * kSamples);
    const std::size_t layer = std::size_t(size_.x) * std::size_t(size_.y);
    parallelFor(std::size_t(size_.z), [&](std::size_t z) {
        for (std::size_t cell = z * layer; cell < (z + 1) * layer; ++cell) {
            for (std::size_t s = 0; s < kSamples; ++s) {
                const glm::ivec3 at = voxelOf(cell, s);
                entries_[cell * kSamples + s] = map_.entryOf(volume_->stored(at.x, at.y, at.z));
            }
        }
    });
}

glm::dvec3 CoarseMatter::cellMm() const {
    return glm::dvec3(edge_) * volume_->spacingMm();
}

double CoarseMatter::edgeMm() const {
    const glm::dvec3 mm = cellMm();
    return std::cbrt(mm.x * mm.y * mm.z);
}

std::size_t CoarseMatter::indexOf(const glm::ivec3& cell) const {
    return (std::size_t(cell.z) * std::size_t(size_.y) + std::size_t(cell.y)) * std::size_t(size_.x) +
           std::size_t(cell.x);
}

glm::ivec3 CoarseMatter::cellAt(std::size_t index) const {
    const std::size_t row = index / std::size_t(size_.x);
    return {int(index % std::size_t(size_.x)), int(row % std::size_t(size_.y)),
            int(row / std::size_t(size_.y))};
}

std::size_t CoarseMatter::cellOf(const glm::dvec3& voxel) const {
    const glm::dvec3 clamped = glm::clamp(voxel + 0.5, glm::dvec3(0.0), glm::dvec3(volume_->size()) - 0.5);
    return indexOf(glm::min(glm::ivec3(clamped) / edge_, size_ - 1));
}

glm::ivec3 CoarseMatter::voxelOf(std::size_t cell, std::size_t sample) const {
    const glm::ivec3 low = cellAt(cell) * edge_;
    const glm::ivec3 half{int(sample & 1u), int(sample >> 1u & 1u), int(sample >> 2u & 1u)};
    return glm::min(low + (2 * half + 1) * edge_ / 4, volume_->size() - 1);
}

glm::vec4 ShownMatter::opticsAt(const CoarseMatter& matter, std::uint16_t entry,
                                const glm::ivec3& voxel) const {
    const glm::vec4& usual = optics[entry];
    if (steep.empty() || steep[entry] == usual) return usual;
    const auto part =
        float(steepPart(gradientPerMmAt(matter.volume(), matter.entryMap(), voxel), steepGradientPerMm));
    const float extinction = std::lerp(usual.w, steep[entry].w, part);
    const float share = extinction > 0.0f ? part * steep[entry].w / extinction : 0.0f;
    return {glm::mix(glm::vec3(usual), glm::vec3(steep[entry]), share), extinction};
}

bool ShownMatter::shows(const Volume& volume, const glm::dvec3& voxel) const {
    if (mask) {
        const glm::ivec3 at = glm::clamp(glm::ivec3(glm::round(voxel)), glm::ivec3(0), volume.size() - 1);
        if (!mask->shows(at.x, at.y, at.z)) return false;
    }
    return isInShape(volume, voxel);
}

bool ShownMatter::isInShape(const Volume& volume, const glm::dvec3& voxel) const {
    return !clip.hasShape() || macula::shows(clip, transformPoint(volume.worldFromVoxel(), voxel));
}

PartShown ShownMatter::partInShape(const CoarseMatter& matter, const glm::ivec3& first,
                                   const glm::ivec3& end) const {
    if (!clip.hasShape()) return PartShown::all;
    // Voxels reach half a voxel beyond their centres.
    const glm::dvec3 edge(matter.cellVoxels());
    const Box voxels{glm::dvec3(first) * edge - 0.5, glm::dvec3(end) * edge - 0.5};
    const glm::dmat4& worldFromVoxel = matter.volume().worldFromVoxel();
    if (removesAll(clip, worldFromVoxel, voxels)) return PartShown::nothing;
    return removesNothing(clip, worldFromVoxel, voxels) ? PartShown::all : PartShown::some;
}

void forEachCell(const CoarseMatter& matter, const ShownMatter& shown, int margin,
                 const std::function<void(std::size_t cell, PartShown part)>& body) {
    constexpr int kRun = 12;  // cells along x that are tested together
    const glm::ivec3 size = matter.size();
    parallelFor(std::size_t(size.z), [&](std::size_t layer) {
        const int z = int(layer);
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; x += kRun) {
                const int end = std::min(x + kRun, size.x);
                const PartShown part = shown.partInShape(matter, glm::ivec3(x, y, z) - margin,
                                                         glm::ivec3(end, y + 1, z + 1) + margin);
                for (int at = x; at < end; ++at) body(matter.indexOf({at, y, z}), part);
            }
        }
    });
}

}  // namespace macula::hybrid

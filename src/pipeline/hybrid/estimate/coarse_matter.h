// A volume in cells of a few voxels, of each of which eight voxels are known: enough to tell within
// milliseconds what a curve and a clip show of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/volume.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/entry_map.h"
#include "pipeline/volume/mask_bits.h"

namespace macula::hybrid {

class CoarseMatter {
  public:
    static constexpr std::size_t kSamples = 8;  // of a cell: one in each of its eighths
    static constexpr std::size_t kMostCells = 400'000;

    // Cells about as long as wide and deep in mm, whole voxels, at most so many. The volume must be stored16.
    // On all cores.
    explicit CoarseMatter(std::shared_ptr<const Volume> volume, std::size_t mostCells = kMostCells);

    const Volume& volume() const { return *volume_; }
    const EntryMap& entryMap() const { return map_; }
    glm::ivec3 size() const { return size_; }  // cells
    std::size_t cellCount() const {
        return std::size_t(size_.x) * std::size_t(size_.y) * std::size_t(size_.z);
    }
    glm::dvec3 cellMm() const;  // edges of a cell
    double edgeMm() const;      // of a cube as large as a cell
    glm::ivec3 cellVoxels() const { return edge_; }

    std::size_t indexOf(const glm::ivec3& cell) const;
    glm::ivec3 cellAt(std::size_t index) const;
    // The cell that a voxel lies in; a point outside lies in the nearest. Integers at voxel centres.
    std::size_t cellOf(const glm::dvec3& voxel) const;
    glm::ivec3 voxelOf(std::size_t cell, std::size_t sample) const;
    // Of its samples, by EntryMap.
    std::span<const std::uint16_t, kSamples> entriesOf(std::size_t cell) const {
        return std::span<const std::uint16_t, kSamples>(entries_.data() + cell * kSamples, kSamples);
    }

  private:
    std::shared_ptr<const Volume> volume_;
    EntryMap map_;
    glm::ivec3 edge_{1};  // voxels
    glm::ivec3 size_{1};
    std::vector<std::uint16_t> entries_;
};

// Faces of a clip that show the values themselves (Clip::greyFaces).
struct GreyValues {
    float low = 0.0f;  // entries of black and white
    float high = 1.0f;
    bool belowIsBlack = false;  // else clear
    float exposure = 1.0f;      // that the greys are shown with
    bool keepsHue = false;      // and by which tone map: toneMapHue, else toneMapNeutral

    bool operator==(const GreyValues&) const = default;
};

// How much of some cells the shape of a clip shows; `some` of cells of which it may be all or nothing.
enum class PartShown { nothing, some, all };

// What is shown of a volume: by which optics, and where. Made anew for each curve and clip.
struct ShownMatter {
    std::vector<glm::vec4> optics;         // opticsByEntry
    Clip clip;                             // what of it is not in `mask` is its shape
    std::shared_ptr<const MaskBits> mask;  // null: none
    std::optional<GreyValues> faces = {};  // of the shape
    std::vector<glm::vec4> steep = {};     // Medium::steep; empty: steep matter has no curves of its own
    double steepGradientPerMm = 0.0;

    // Of a voxel with that entry.
    glm::vec4 opticsAt(const CoarseMatter& matter, std::uint16_t entry, const glm::ivec3& voxel) const;

    // Of that point, as far as the shape goes, and of that voxel.
    bool isInShape(const Volume& volume, const glm::dvec3& voxel) const;
    bool shows(const Volume& volume, const glm::dvec3& voxel) const;
    // What the shape of the clip, whatever its mask, shows of the cells from `first` to before `end`.
    PartShown partInShape(const CoarseMatter& matter, const glm::ivec3& first, const glm::ivec3& end) const;
};

// Calls body(cell, part) for each cell, on all cores: one layer after another along z, each by one thread.
// `part` is what the shape shows of the cell and of those within `margin` cells of it, and perhaps of more.
void forEachCell(const CoarseMatter& matter, const ShownMatter& shown, int margin,
                 const std::function<void(std::size_t cell, PartShown part)>& body);

}  // namespace macula::hybrid

// A volume in cells of a few voxels, with eight sampled voxels each: enough to find within milliseconds what
// a curve and a clip show of it.
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
    static constexpr std::size_t kSamples = 8;  // per cell: one in each octant
    static constexpr std::size_t kMostCells = 400'000;

    // Makes nearly cubic cells (in mm) of whole voxels, at most `mostCells`. The volume must be stored16.
    // Uses all cores.
    explicit CoarseMatter(std::shared_ptr<const Volume> volume, std::size_t mostCells = kMostCells);

    const Volume& volume() const { return *volume_; }
    const EntryMap& entryMap() const { return map_; }
    glm::ivec3 size() const { return size_; }  // cells
    std::size_t cellCount() const {
        return std::size_t(size_.x) * std::size_t(size_.y) * std::size_t(size_.z);
    }
    glm::dvec3 cellMm() const;  // edges of a cell
    double edgeMm() const;      // of a cube of a cell's volume
    glm::ivec3 cellVoxels() const { return edge_; }

    std::size_t indexOf(const glm::ivec3& cell) const;
    glm::ivec3 cellAt(std::size_t index) const;
    // The cell that a voxel lies in; a point outside lies in the nearest. Integers at voxel centres.
    std::size_t cellOf(const glm::dvec3& voxel) const;
    glm::ivec3 voxelOf(std::size_t cell, std::size_t sample) const;
    // The entries of its samples, by entryMap().
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

// How the faces of a clip show grey values (Clip::greyFaces).
struct GreyValues {
    float low = 0.0f;  // entries of black and white
    float high = 1.0f;
    bool belowIsBlack = false;  // else transparent
    float exposure = 1.0f;      // of the picture
    bool keepsHue = false;      // the picture's tone map: toneMapHue, else toneMapNeutral

    bool operator==(const GreyValues&) const = default;
};

// How much of some cells the shape of a clip shows. `some` is conservative: it may be all or nothing.
enum class PartShown { nothing, some, all };

// Which part of a volume is shown, and with which optics. Each curve and clip needs a new one.
struct ShownMatter {
    std::vector<glm::vec4> optics;         // opticsByEntry
    Clip clip;                             // only its shape counts: its mask is `mask`
    std::shared_ptr<const MaskBits> mask;  // null: none
    std::optional<GreyValues> faces = {};  // on the faces of the shape
    std::vector<glm::vec4> steep = {};     // Medium::steep; empty: steep matter has no curves of its own
    double steepGradientPerMm = 0.0;

    // The optics of a voxel with this entry.
    glm::vec4 opticsAt(const CoarseMatter& matter, std::uint16_t entry, const glm::ivec3& voxel) const;

    // Whether the shape contains this point; and whether the mask shows the nearest voxel, too.
    bool isInShape(const Volume& volume, const glm::dvec3& voxel) const;
    bool shows(const Volume& volume, const glm::dvec3& voxel) const;
    // What the shape of the clip, whatever its mask, shows of the cells from `first` to before `end`.
    PartShown partInShape(const CoarseMatter& matter, const glm::ivec3& first, const glm::ivec3& end) const;
};

// Calls body(cell, part) for each cell, on all cores; one thread does all of a layer of constant z. `part`
// says how much the shape shows of a region that contains the cell and its neighbours within `margin` cells.
void forEachCell(const CoarseMatter& matter, const ShownMatter& shown, int margin,
                 const std::function<void(std::size_t cell, PartShown part)>& body);

}  // namespace macula::hybrid

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/available_memory.h"
#include "base/check.h"
#include "dicom/messages.h"
#include "dicom/pixels/pixels.h"
#include "dicom/segmentation/grid_placement.h"
#include "dicom/segmentation/segmentation.h"

namespace macula::dicom {

namespace {

Error notUsable(const Segmentation& segmentation, std::string message, std::string hint) {
    return {ErrorCode::inputNotUsable, std::move(message), segmentation.file.string(), std::move(hint)};
}

using Placements = std::vector<GridPlacement>;

// Places a frame in the plane of a slice that lies a little off its even place, as if both lay at that place.
std::optional<GridPlacement> placeOnSlice(const Segmentation& segmentation, ImagePlane plane,
                                          const glm::dmat4& worldFromVoxel, const glm::dmat4& voxelFromWorld,
                                          std::span<const glm::dvec3> slicePositionsMm) {
    const double along = transformPoint(voxelFromWorld, plane.positionMm).z;
    const double last = static_cast<double>(slicePositionsMm.size()) - 1.0;
    if (!(along > -1.0 && along < last + 1.0)) return {};
    const glm::dvec3 positionMm = plane.positionMm;
    for (const double k : {std::round(along), std::floor(along), std::ceil(along)}) {
        if (k < 0.0 || k > last) continue;
        const glm::dvec3 even = transformPoint(worldFromVoxel, {0.0, 0.0, k});
        plane.positionMm = positionMm + even - slicePositionsMm[static_cast<std::size_t>(k)];
        auto placement = placeOnGrid(voxelFromWorld, plane, segmentation.columns, segmentation.rows);
        // A frame that runs across the slices has no one slice.
        if (placement && placement->origin.z == static_cast<int>(k) && placement->columnStep.z == 0 &&
            placement->rowStep.z == 0) {
            return placement;
        }
    }
    return {};
}

// The placements of all frames; `firstOff` tells which one does not lie on the grid.
std::optional<Placements> placeAll(const Segmentation& segmentation, const glm::dmat4& worldFromVoxel,
                                   std::span<const glm::dvec3> slicePositionsMm = {},
                                   std::size_t* firstOff = nullptr) {
    if (!isInvertibleAffine(worldFromVoxel)) return {};
    const glm::dmat4 voxelFromWorld = glm::inverse(worldFromVoxel);
    Placements placements;
    placements.reserve(segmentation.frames.size());
    for (const Segmentation::Frame& frame : segmentation.frames) {
        auto placement = placeOnGrid(voxelFromWorld, frame.plane, segmentation.columns, segmentation.rows);
        if (!placement && !slicePositionsMm.empty()) {
            placement =
                placeOnSlice(segmentation, frame.plane, worldFromVoxel, voxelFromWorld, slicePositionsMm);
        }
        if (!placement) {
            if (firstOff != nullptr) *firstOff = placements.size();
            return {};
        }
        placements.push_back(*placement);
    }
    return placements;
}

// Writes frames into the grid, and counts what cannot be kept.
class Painter {
  public:
    Painter(const Segmentation& segmentation, glm::ivec3 size)
        : segmentation_(segmentation),
          size_(size),
          labels_(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                  static_cast<std::size_t>(size.z)) {
        const CellFormat& format = segmentation.format;
        shift_ = format.highBit + 1 - format.bitsStored;
        mask_ = (1u << format.bitsStored) - 1u;
    }

    void paint(const Segmentation::Frame& frame, const GridPlacement& placement,
               std::span<const std::uint16_t> cells) {
        std::size_t at = 0;
        for (int row = 0; row < segmentation_.rows; ++row) {
            glm::ivec3 voxel = placement.origin + row * placement.rowStep;
            for (int column = 0; column < segmentation_.columns; ++column, voxel += placement.columnStep) {
                const std::uint16_t label = labelOf(frame, cells[at++]);
                if (label != 0) set(voxel, label);
            }
        }
    }

    std::vector<Segment> segments() const {
        std::vector<Segment> all = segmentation_.segments;
        std::set<std::uint16_t> described;
        for (const Segment& segment : all) described.insert(segment.number);
        for (const std::uint16_t number : seen_) {
            if (described.insert(number).second)
                all.push_back({.number = number, .label = fmt::format("Segment {}", number)});
        }
        return all;
    }

    std::vector<Message> messages() const {
        std::vector<Message> all;
        const auto tell = [&](std::string_view key, std::size_t count) {
            if (count > 0) all.push_back(message(key, {{"count", static_cast<std::int64_t>(count)}}));
        };
        tell(key::kSegmentsOverlap, overlaps_);
        tell(key::kSegmentsOutside, outside_);
        return all;
    }

    std::vector<std::uint16_t> take() { return std::move(labels_); }

  private:
    std::uint16_t labelOf(const Segmentation::Frame& frame, std::uint16_t cell) const {
        const unsigned value = (unsigned{cell} >> shift_) & mask_;
        switch (segmentation_.type) {
            case SegmentationType::binary:
                return value != 0 ? frame.segment : std::uint16_t{0};
            case SegmentationType::fractional:
                return value > 0 && 2 * value >= static_cast<unsigned>(segmentation_.fractionalMaximum)
                           ? frame.segment
                           : std::uint16_t{0};
            case SegmentationType::labelMap:
                break;
        }
        return static_cast<std::uint16_t>(value);
    }

    void set(const glm::ivec3& voxel, std::uint16_t label) {
        if (label != lastSeen_) {
            seen_.insert(label);
            lastSeen_ = label;
        }
        if (voxel.x < 0 || voxel.y < 0 || voxel.z < 0 || voxel.x >= size_.x || voxel.y >= size_.y ||
            voxel.z >= size_.z) {
            ++outside_;
            return;
        }
        std::uint16_t& place =
            labels_[(static_cast<std::size_t>(voxel.z) * static_cast<std::size_t>(size_.y) +
                     static_cast<std::size_t>(voxel.y)) *
                        static_cast<std::size_t>(size_.x) +
                    static_cast<std::size_t>(voxel.x)];
        if (place != 0 && place != label) ++overlaps_;
        place = label;
    }

    const Segmentation& segmentation_;
    glm::ivec3 size_;
    std::vector<std::uint16_t> labels_;
    int shift_ = 0;
    unsigned mask_ = 0;
    std::set<std::uint16_t> seen_;
    std::uint16_t lastSeen_ = 0;
    std::size_t overlaps_ = 0;
    std::size_t outside_ = 0;
};

Result<LabelMap> load(const Segmentation& segmentation, const Placements& placements,
                      const glm::dmat4& worldFromVoxel, glm::ivec3 size, Progress& progress) {
    const int frames = static_cast<int>(segmentation.frames.size());
    MACULA_TRY(PixelReader reader,
               PixelReader::open(segmentation.file, {segmentation.transferSyntaxUid, segmentation.columns,
                                                     segmentation.rows, frames, segmentation.format}));
    for (int i = 0; i < frames; ++i) {
        if (reader.isCutOff(i)) {
            return notUsable(segmentation, "The segmentation ends before its last frame does.",
                             "Copy the file again from its source.");
        }
    }
    // This is checked once it is known what the file really holds: a header alone cannot ask for more than it
    // could fill.
    const double voxels = double(size.x) * double(size.y) * double(size.z);
    // Two small frames far apart span a grid that nothing fills.
    constexpr double kMostVoxelsPerPixel = 64.0;
    constexpr double kSmallGrid = 1e8;
    const double pixels = double(frames) * double(segmentation.rows) * double(segmentation.columns);
    if (voxels > kSmallGrid && voxels > kMostVoxelsPerPixel * pixels) {
        return notUsable(segmentation,
                         "The frames of the segmentation lie too far apart for a grid of their own.",
                         "Open it with the series it was drawn on.");
    }
    const auto available = availableMemory();
    if (voxels * sizeof(std::uint16_t) > static_cast<double>(available.value_or(UINT64_MAX))) {
        constexpr double kLargestNamed = 9e18;
        return notEnoughMemory(
            static_cast<std::uint64_t>(std::min(voxels * sizeof(std::uint16_t), kLargestNamed)), available);
    }
    progress.beginStage(fmt::format("Reading a segmentation of {} frames", frames),
                        static_cast<std::size_t>(frames));
    Painter painter(segmentation, size);
    std::vector<std::uint16_t> cells(static_cast<std::size_t>(segmentation.columns) *
                                     static_cast<std::size_t>(segmentation.rows));
    for (int i = 0; i < frames; ++i, progress.advance()) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "Loading was cancelled.", {}, {}};
        MACULA_TRY_VOID(reader.read(i, cells));
        const auto at = static_cast<std::size_t>(i);
        painter.paint(segmentation.frames[at], placements[at], cells);
    }
    return LabelMap::create(size, worldFromVoxel, painter.segments(), painter.take(), painter.messages());
}

Error outOfMemory(const Segmentation& segmentation) {
    return {ErrorCode::outOfMemory, "There is not enough memory to load the segmentation.",
            segmentation.file.string(), "Close other programs."};
}

// Axes that could be those of a grid that holds all frames: along the normal, or from the lowest frame to the
// highest; as far apart as the header says, or as the two nearest are.
std::vector<glm::dvec3> likelySliceAxes(const Segmentation& segmentation) {
    const auto& frames = segmentation.frames;
    const glm::dvec3 normal = glm::normalize(frames.front().plane.normal());
    const auto height = [&](const Segmentation::Frame& f) { return glm::dot(f.plane.positionMm, normal); };
    const auto [lowest, highest] = std::minmax_element(
        frames.begin(), frames.end(), [&](const auto& a, const auto& b) { return height(a) < height(b); });
    const double distance = height(*highest) - height(*lowest);
    const double stated = segmentation.spacingMm;
    if (distance < kSamePositionMm) return {normal * (stated > 0.0 ? stated : 1.0)};

    std::vector<double> heights;
    for (const auto& frame : frames) heights.push_back(height(frame));
    std::sort(heights.begin(), heights.end());
    double nearest = distance;
    for (std::size_t i = 1; i < heights.size(); ++i) {
        if (const double gap = heights[i] - heights[i - 1]; gap >= kSamePositionMm)
            nearest = std::min(nearest, gap);
    }
    std::vector<glm::dvec3> axes;
    for (const double spacing : {stated, nearest}) {
        if (spacing <= 0.0) continue;
        const double steps = std::round(distance / spacing);
        if (steps < 1.0) continue;
        // The step is taken over the whole length, so that what a rounded spacing is wrong by does not add
        // up.
        axes.push_back(normal * (distance / steps));
        axes.push_back((highest->plane.positionMm - lowest->plane.positionMm) / steps);
    }
    return axes;
}

}  // namespace

Result<LabelMap> loadSegmentation(const Segmentation& segmentation, const glm::dmat4& worldFromVoxel,
                                  glm::ivec3 size, Progress& progress,
                                  std::span<const glm::dvec3> slicePositionsMm) try {
    if (size.x < 1 || size.y < 1 || size.z < 1 || !isInvertibleAffine(worldFromVoxel)) {
        return notUsable(segmentation, "The series of the segmentation is no volume.",
                         "Choose another series.");
    }
    MACULA_CHECK(slicePositionsMm.empty() || slicePositionsMm.size() == static_cast<std::size_t>(size.z));
    std::size_t firstOff = 0;
    const auto placements = placeAll(segmentation, worldFromVoxel, slicePositionsMm, &firstOff);
    if (!placements) {
        return notUsable(segmentation,
                         fmt::format("Frame {} of the segmentation does not lie on the voxels of the series.",
                                     firstOff + 1),
                         "Open the segmentation with the series it was drawn on.");
    }
    return load(segmentation, *placements, worldFromVoxel, size, progress);
} catch (const std::exception&) {
    return outOfMemory(segmentation);
}

Result<LabelMap> loadSegmentation(const Segmentation& segmentation, Progress& progress) try {
    if (segmentation.frames.empty())
        return notUsable(segmentation, "The segmentation has no frames.", "Choose another segmentation.");
    const ImagePlane& plane = segmentation.frames.front().plane;
    for (const glm::dvec3& sliceAxis : likelySliceAxes(segmentation)) {
        glm::dmat4 worldFromVoxel =
            affine(plane.columnSpacingMm * plane.rowDirection, plane.rowSpacingMm * plane.columnDirection,
                   sliceAxis, plane.positionMm);
        auto placements = placeAll(segmentation, worldFromVoxel);
        if (!placements) continue;
        glm::ivec3 low = placements->front().origin;
        glm::ivec3 high = low;
        for (const GridPlacement& p : *placements) {
            for (const glm::ivec3& corner : {p.origin, p.origin + (segmentation.columns - 1) * p.columnStep +
                                                           (segmentation.rows - 1) * p.rowStep}) {
                low = glm::min(low, corner);
                high = glm::max(high, corner);
            }
        }
        worldFromVoxel[3] = worldFromVoxel * glm::dvec4(glm::dvec3(low), 1.0);
        for (GridPlacement& p : *placements) p.origin -= low;
        return load(segmentation, *placements, worldFromVoxel, high - low + glm::ivec3(1), progress);
    }
    return notUsable(segmentation, "The frames of the segmentation do not lie on one grid.",
                     "Open the segmentation with the series it was drawn on.");
} catch (const std::exception&) {
    return outOfMemory(segmentation);
}

}  // namespace macula::dicom

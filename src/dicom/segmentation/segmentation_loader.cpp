#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/available_memory.h"
#include "base/check.h"
#include "base/exceptions.h"
#include "dicom/messages/messages.h"
#include "dicom/pixels/pixels.h"
#include "dicom/segmentation/segment_cells.h"
#include "dicom/segmentation/segmentation.h"
#include "dicom/segmentation/segmentation_grid.h"

namespace macula::dicom {

namespace {

Error notUsable(const Segmentation& segmentation, Text message, Text hint) {
    return {ErrorCode::inputNotUsable, std::move(message), segmentation.file.string(), std::move(hint)};
}

// Writes frames into the grid, and counts what cannot be kept.
class Painter {
  public:
    Painter(const Segmentation& segmentation, glm::ivec3 size)
        : segmentation_(segmentation),
          size_(size),
          cells_(segmentation),
          labelOfZero_(freeLabel(segmentation)),
          labels_(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                  static_cast<std::size_t>(size.z)) {}

    void paint(const Segmentation::Frame& frame, const GridPlacement& placement,
               std::span<const std::uint16_t> cells) {
        std::size_t at = 0;
        for (int row = 0; row < segmentation_.rows; ++row) {
            glm::ivec3 voxel = placement.origin + row * placement.rowStep;
            for (int column = 0; column < segmentation_.columns; ++column, voxel += placement.columnStep) {
                if (const auto segment = cells_.segmentOf(frame, cells[at++])) set(voxel, *segment);
            }
        }
    }

    std::vector<Segment> segments() const {
        std::vector<Segment> all = segmentation_.segments;
        std::set<std::uint16_t> described;
        for (Segment& segment : all) {
            if (segment.number == 0) segment.number = labelOfZero_;
            described.insert(segment.number);
        }
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
        for (const std::uint16_t number : segmentation_.paddedSegments)
            all.push_back(message(key::kSegmentIsPadding, {{"number", std::int64_t(number)}}));
        if (hasZero()) all.push_back(message(key::kSegmentZero, {{"number", std::int64_t(labelOfZero_)}}));
        return all;
    }

    // Whether the map could not distinguish segment 0 from another segment.
    bool isAmbiguous() const { return hasZero() && isLabelOfZeroTaken_; }

    std::vector<std::uint16_t> take() { return std::move(labels_); }

  private:
    // Above all numbers that cells can hold, where there is one; otherwise the highest that is not described.
    static std::uint16_t freeLabel(const Segmentation& segmentation) {
        if (segmentation.format.bitsStored < 16) return std::uint16_t(1 << segmentation.format.bitsStored);
        std::uint16_t label = 65535;
        for (auto segment = segmentation.segments.rbegin();
             segment != segmentation.segments.rend() && segment->number == label && label > 1; ++segment)
            --label;
        return label;
    }
    bool hasZero() const {
        return !segmentation_.segments.empty() && segmentation_.segments.front().number == 0;
    }

    void set(const glm::ivec3& voxel, std::uint16_t segment) {
        const std::uint16_t label = segment == 0 ? labelOfZero_ : segment;
        if (segment == labelOfZero_) isLabelOfZeroTaken_ = true;
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
    SegmentCells cells_;
    std::uint16_t labelOfZero_;
    bool isLabelOfZeroTaken_ = false;
    std::vector<std::uint16_t> labels_;
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
            return notUsable(segmentation, Text("The segmentation ends before its last frame does."),
                             Text("Copy the file again from its source."));
        }
    }
    // Checked once the cells have been read, so that a false header cannot make it allocate more than they
    // fill.
    const double voxels = double(size.x) * double(size.y) * double(size.z);
    // Two small frames far apart span a grid that nothing fills.
    constexpr double kMostVoxelsPerPixel = 64.0;
    constexpr double kSmallGrid = 1e8;
    const double pixels = double(frames) * double(segmentation.rows) * double(segmentation.columns);
    if (voxels > kSmallGrid && voxels > kMostVoxelsPerPixel * pixels) {
        return notUsable(segmentation,
                         Text("The frames of the segmentation lie too far apart for a grid of their own."),
                         Text("Open it with the series it was drawn on."));
    }
    const auto available = availableMemory();
    if (voxels * sizeof(std::uint16_t) > static_cast<double>(available.value_or(UINT64_MAX))) {
        constexpr double kLargestNamed = 9e18;
        return notEnoughMemory(
            static_cast<std::uint64_t>(std::min(voxels * sizeof(std::uint16_t), kLargestNamed)), available);
    }
    progress.beginStage(Text("Reading a segmentation of {} frames", frames),
                        static_cast<std::size_t>(frames));
    Painter painter(segmentation, size);
    std::vector<std::uint16_t> cells(static_cast<std::size_t>(segmentation.columns) *
                                     static_cast<std::size_t>(segmentation.rows));
    for (int i = 0; i < frames; ++i, progress.advance()) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Loading was cancelled."), {}, {}};
        MACULA_TRY_VOID(reader.read(i, cells));
        const auto at = static_cast<std::size_t>(i);
        painter.paint(segmentation.frames[at], placements[at], cells);
    }
    if (painter.isAmbiguous())
        return notUsable(segmentation, Text("The segmentation has more segments than a label map can hold."),
                         Text("Choose another segmentation."));
    return LabelMap::create(size, worldFromVoxel, painter.segments(), painter.take(), painter.messages());
}

}  // namespace

Result<LabelMap> loadSegmentation(const Segmentation& segmentation, const glm::dmat4& worldFromVoxel,
                                  glm::ivec3 size, Progress& progress,
                                  std::span<const glm::dvec3> slicePositionsMm) try {
    if (size.x < 1 || size.y < 1 || size.z < 1 || !isInvertibleAffine(worldFromVoxel)) {
        return notUsable(segmentation, Text("The series of the segmentation is no volume."),
                         Text("Choose another series."));
    }
    MACULA_CHECK(slicePositionsMm.empty() || slicePositionsMm.size() == static_cast<std::size_t>(size.z));
    std::size_t firstOff = 0;
    const auto placements = placeFrames(segmentation, worldFromVoxel, slicePositionsMm, &firstOff);
    if (!placements) {
        return notUsable(
            segmentation,
            Text("Frame {} of the segmentation does not lie on the voxels of the series.", firstOff + 1),
            Text("Open the segmentation with the series it was drawn on."));
    }
    return load(segmentation, *placements, worldFromVoxel, size, progress);
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("load the segmentation"), segmentation.file.string());
}

Result<LabelMap> loadSegmentation(const Segmentation& segmentation, Progress& progress) try {
    if (segmentation.frames.empty())
        return notUsable(segmentation, Text("The segmentation has no frames."),
                         Text("Choose another segmentation."));
    if (const auto grid = ownGrid(segmentation))
        return load(segmentation, grid->placements, grid->worldFromVoxel, grid->size, progress);
    return notUsable(segmentation, Text("The frames of the segmentation do not lie on one grid."),
                     Text("Open the segmentation with the series it was drawn on."));
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("load the segmentation"), segmentation.file.string());
}

}  // namespace macula::dicom

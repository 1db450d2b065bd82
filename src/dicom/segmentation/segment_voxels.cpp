#include "dicom/segmentation/segment_voxels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/available_memory.h"
#include "base/exceptions.h"
#include "dicom/pixels/pixels.h"
#include "dicom/segmentation/segment_cells.h"
#include "dicom/segmentation/segmentation_grid.h"

namespace macula::dicom {

namespace {

constexpr double kSmallBoxBytes = 1e7;
// Limit for boxes: two small frames far apart could span a huge one.
constexpr double kMostVoxelsPerPixel = 64.0;

Error notUsable(const Segmentation& segmentation, Text message, Text hint) {
    return {ErrorCode::inputNotUsable, std::move(message), segmentation.file.string(), std::move(hint)};
}

Error wasCancelled() {
    return {ErrorCode::cancelled, Text("Loading was cancelled."), {}, {}};
}

struct VoxelBox {
    glm::ivec3 low{0};
    glm::ivec3 high{-1};  // below `low`: the box is empty

    bool isEmpty() const { return high.x < low.x; }
    void add(const glm::ivec3& voxel) {
        if (isEmpty()) {
            low = high = voxel;
        } else {
            low = glm::min(low, voxel);
            high = glm::max(high, voxel);
        }
    }
};

// Reads the file twice: first for the box of each segment, so that it takes no more memory than it needs;
// then for its voxels.
class Reader {
  public:
    Reader(const Segmentation& segmentation, const SegmentationGrid& grid, Progress& progress)
        : segmentation_(segmentation), grid_(grid), progress_(progress), cells_(segmentation) {}

    Result<void> read();
    std::map<std::uint16_t, VoxelSet> take() { return std::move(sets_); }
    std::size_t outside() const { return outside_; }

  private:
    // Calls visit(segment, voxel) for every cell that belongs to a segment.
    template <class Visit>
    Result<void> forEachCell(PixelReader& reader, const Visit& visit);
    Result<void> makeSets();
    bool isInGrid(const glm::ivec3& voxel) const {
        const glm::ivec3& size = grid_.size;
        return voxel.x >= 0 && voxel.y >= 0 && voxel.z >= 0 && voxel.x < size.x && voxel.y < size.y &&
               voxel.z < size.z;
    }

    const Segmentation& segmentation_;
    const SegmentationGrid& grid_;
    Progress& progress_;
    SegmentCells cells_;
    std::map<std::uint16_t, VoxelBox> boxes_;
    std::map<std::uint16_t, VoxelSet> sets_;
    std::size_t outside_ = 0;
};

template <class Visit>
Result<void> Reader::forEachCell(PixelReader& reader, const Visit& visit) {
    std::vector<std::uint16_t> cells(static_cast<std::size_t>(segmentation_.columns) *
                                     static_cast<std::size_t>(segmentation_.rows));
    const int frames = static_cast<int>(segmentation_.frames.size());
    for (int i = 0; i < frames; ++i, progress_.advance()) {
        if (progress_.cancelled()) return wasCancelled();
        MACULA_TRY_VOID(reader.read(i, cells));
        const Segmentation::Frame& frame = segmentation_.frames[static_cast<std::size_t>(i)];
        const GridPlacement& place = grid_.placements[static_cast<std::size_t>(i)];
        std::size_t at = 0;
        for (int row = 0; row < segmentation_.rows; ++row) {
            glm::ivec3 voxel = place.origin + row * place.rowStep;
            for (int column = 0; column < segmentation_.columns; ++column, voxel += place.columnStep) {
                if (const auto segment = cells_.segmentOf(frame, cells[at++])) visit(*segment, voxel);
            }
        }
    }
    return {};
}

// Called once the cells have been read, so that a false header cannot make it allocate more than they fill.
Result<void> Reader::makeSets() {
    const double pixels =
        double(segmentation_.frames.size()) * double(segmentation_.rows) * double(segmentation_.columns);
    double bytes = 0.0;
    for (const auto& [segment, box] : boxes_) {
        const double ofBox = VoxelSet::bytesFor(box.low, box.high);
        if (ofBox > kSmallBoxBytes && 8.0 * ofBox > kMostVoxelsPerPixel * pixels)
            return notUsable(segmentation_, Text("The frames of the segmentation lie too far apart."),
                             Text("Choose another segmentation."));
        bytes += ofBox;
    }
    const auto available = availableMemory();
    if (bytes > static_cast<double>(available.value_or(UINT64_MAX)))
        return notEnoughMemory(static_cast<std::uint64_t>(std::min(bytes, 9e18)), available);
    for (const auto& [segment, box] : boxes_) sets_.emplace(segment, VoxelSet(box.low, box.high));
    return {};
}

Result<void> Reader::read() {
    const int frames = static_cast<int>(segmentation_.frames.size());
    const PixelLayout layout{segmentation_.transferSyntaxUid, segmentation_.columns, segmentation_.rows,
                             frames, segmentation_.format};
    progress_.beginStage(Text("Reading a segmentation of {} frames", frames),
                         2 * static_cast<std::size_t>(frames));
    {
        MACULA_TRY(PixelReader reader, PixelReader::open(segmentation_.file, layout, progress_.token()));
        for (int i = 0; i < frames; ++i) {
            if (reader.isCutOff(i))
                return notUsable(segmentation_, Text("The segmentation ends before its last frame does."),
                                 Text("Copy the file again from its source."));
        }
        VoxelBox* box = nullptr;
        int last = -1;  // none
        MACULA_TRY_VOID(forEachCell(reader, [&](std::uint16_t segment, const glm::ivec3& voxel) {
            if (!isInGrid(voxel)) {
                ++outside_;
                return;
            }
            if (segment != last) {
                box = &boxes_[segment];
                last = segment;
            }
            box->add(voxel);
        }));
    }
    MACULA_TRY_VOID(makeSets());
    // Opened again: frames of a deflated file are fastest in ascending order.
    MACULA_TRY(PixelReader reader, PixelReader::open(segmentation_.file, layout, progress_.token()));
    VoxelSet* set = nullptr;
    int last = -1;
    bool hasChanged = false;
    MACULA_TRY_VOID(forEachCell(reader, [&](std::uint16_t segment, const glm::ivec3& voxel) {
        if (!isInGrid(voxel)) return;
        if (segment != last) {
            const auto found = sets_.find(segment);
            set = found == sets_.end() ? nullptr : &found->second;
            last = segment;
        }
        const bool fits = set != nullptr && glm::all(glm::lessThanEqual(set->low(), voxel)) &&
                          glm::all(glm::lessThanEqual(voxel, set->high()));
        if (fits) {
            set->add(voxel);
        } else {
            hasChanged = true;
        }
    }));
    if (hasChanged)
        return notUsable(segmentation_, Text("The segmentation changed while it was read."),
                         Text("Open the study again."));
    return {};
}

// Sets volume and centroid of the segment from its voxels in a grid.
void measure(SegmentVoxels& segment, const VoxelSet& voxels, const glm::dmat4& worldFromVoxel,
             bool hasThickness) {
    glm::dvec3 sum(0.0);
    std::size_t count = 0;
    voxels.forEach([&](const glm::ivec3& voxel) {
        sum += glm::dvec3(voxel);
        ++count;
    });
    if (count == 0) return;
    segment.centroidMm = transformPoint(worldFromVoxel, sum / double(count));
    if (hasThickness)
        segment.volumeMm3 = double(count) * std::abs(glm::determinant(glm::dmat3(worldFromVoxel)));
}

std::vector<SegmentVoxels> describe(const Segmentation& segmentation,
                                    std::map<std::uint16_t, VoxelSet> sets) {
    std::vector<SegmentVoxels> all;
    for (const Segment& segment : segmentation.segments) {
        SegmentVoxels described;
        described.segment = segment;
        if (const auto found = sets.find(segment.number); found != sets.end()) {
            described.voxels = std::move(found->second);
            sets.erase(found);
        }
        all.push_back(std::move(described));
    }
    for (auto& [number, voxels] : sets) {
        SegmentVoxels nameless;
        nameless.segment.number = number;
        nameless.segment.label = fmt::format("Segment {}", number);
        nameless.voxels = std::move(voxels);
        all.push_back(std::move(nameless));
    }
    std::ranges::sort(all, {}, [](const SegmentVoxels& each) { return each.segment.number; });
    return all;
}

// The box of the voxels of a grid whose centre may lie in a voxel of `set`, which is on another grid.
VoxelBox boxOfNearest(const VoxelSet& set, const glm::dmat4& setFromVoxel, const glm::ivec3& size) {
    if (set.isEmpty()) return {};
    const glm::dmat4 voxelFromSet = glm::inverse(setFromVoxel);
    const std::array<glm::dvec3, 2> ends{glm::dvec3(set.low()) - 0.5, glm::dvec3(set.high()) + 0.5};
    glm::dvec3 low(1e9);
    glm::dvec3 high(-1e9);
    for (unsigned n = 0; n < 8; ++n) {
        const glm::dvec3 corner =
            transformPoint(voxelFromSet, {ends[n & 1u].x, ends[n >> 1u & 1u].y, ends[n >> 2u & 1u].z});
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    low = glm::max(glm::ceil(low), glm::dvec3(0.0));
    high = glm::min(glm::floor(high), glm::dvec3(size - 1));
    if (!(low.x <= high.x && low.y <= high.y && low.z <= high.z)) return {};
    return {.low = glm::ivec3(low), .high = glm::ivec3(high)};
}

// A few frames of large voxels may fill the volume with each of thousands of segments, so the memory of all
// is checked before the first is made.
Result<void> checkResampledFits(const std::vector<SegmentVoxels>& segments, const glm::dmat4& setFromVoxel,
                                const glm::ivec3& size) {
    double bytes = 0.0;
    for (const SegmentVoxels& each : segments) {
        const VoxelBox box = boxOfNearest(each.voxels, setFromVoxel, size);
        if (!box.isEmpty()) bytes += VoxelSet::bytesFor(box.low, box.high);
    }
    const auto available = availableMemory();
    if (bytes > static_cast<double>(available.value_or(UINT64_MAX)))
        return notEnoughMemory(static_cast<std::uint64_t>(std::min(bytes, 9e18)), available);
    return {};
}

Result<SegmentVoxelSets> loadResampled(const Segmentation& segmentation, const glm::dmat4& worldFromVoxel,
                                       const glm::ivec3& size, Progress& progress) {
    const std::optional<SegmentationGrid> own = ownGrid(segmentation);
    if (!own)
        return notUsable(segmentation, Text("The frames of the segmentation do not lie on one grid."),
                         Text("Choose another segmentation."));
    Reader reader(segmentation, *own, progress);
    MACULA_TRY_VOID(reader.read());
    SegmentVoxelSets sets;
    sets.segments = describe(segmentation, reader.take());
    sets.isResampled = true;
    const bool hasThickness = own->size.z > 1 || segmentation.spacingMm > 0.0;
    const glm::dmat4 setFromVoxel = glm::inverse(own->worldFromVoxel) * worldFromVoxel;
    MACULA_TRY_VOID(checkResampledFits(sets.segments, setFromVoxel, size));
    progress.beginStage(Text("Putting segments on the voxels of the volume"), sets.segments.size());
    for (SegmentVoxels& each : sets.segments) {
        measure(each, each.voxels, own->worldFromVoxel, hasThickness);
        each.voxels = nearestVoxels(each.voxels, setFromVoxel, size, progress.token());
        if (progress.cancelled()) return wasCancelled();
        progress.advance();
    }
    return sets;
}

}  // namespace

VoxelSet nearestVoxels(const VoxelSet& set, const glm::dmat4& setFromVoxel, const glm::ivec3& size,
                       const CancelToken& token) {
    const VoxelBox box = boxOfNearest(set, setFromVoxel, size);
    if (box.isEmpty()) return {};
    const glm::ivec3 first = box.low;
    const glm::ivec3 last = box.high;
    VoxelSet found(first, last);
    const glm::dvec3 step = transformVector(setFromVoxel, {1.0, 0.0, 0.0});
    for (int k = first.z; k <= last.z && !token.cancelled(); ++k) {
        for (int j = first.y; j <= last.y; ++j) {
            const glm::dvec3 begin = transformPoint(setFromVoxel, {double(first.x), double(j), double(k)});
            for (int i = first.x; i <= last.x; ++i) {
                const glm::dvec3 at = begin + double(i - first.x) * step;
                if (set.contains(glm::ivec3(glm::floor(at + 0.5)))) found.add({i, j, k});
            }
        }
    }
    return found.cropped();
}

Result<SegmentVoxelSets> loadSegmentVoxels(const Segmentation& segmentation, const glm::dmat4& worldFromVoxel,
                                           glm::ivec3 size, Progress& progress,
                                           std::span<const glm::dvec3> slicePositionsMm) try {
    if (size.x < 1 || size.y < 1 || size.z < 1 || !isInvertibleAffine(worldFromVoxel))
        return notUsable(segmentation, Text("The series of the segmentation is no volume."),
                         Text("Choose another series."));
    if (slicePositionsMm.size() != static_cast<std::size_t>(size.z)) slicePositionsMm = {};
    auto placements = placeFrames(segmentation, worldFromVoxel, slicePositionsMm);
    if (!placements || segmentation.frames.empty())
        return loadResampled(segmentation, worldFromVoxel, size, progress);
    const SegmentationGrid grid{worldFromVoxel, size, *std::move(placements)};
    Reader reader(segmentation, grid, progress);
    MACULA_TRY_VOID(reader.read());
    SegmentVoxelSets sets;
    sets.outside = reader.outside();
    sets.segments = describe(segmentation, reader.take());
    for (SegmentVoxels& each : sets.segments) measure(each, each.voxels, worldFromVoxel, true);
    return sets;
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("load the segmentation"), segmentation.file.string());
}

}  // namespace macula::dicom

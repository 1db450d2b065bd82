#include "dicom/write/segment_frames.h"

#include <cmath>

namespace macula::dicom {

SegmentFrames::SegmentFrames(const WrittenSegmentation& segmentation) : segmentation_(segmentation) {
    const glm::ivec3& size = segmentation.size;
    // Other segments can share a voxel only where more than one has any.
    std::vector<bool> isTaken;
    if (segmentation.segments.size() > 1)
        isTaken.resize(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    for (std::size_t n = 0; n < segmentation.segments.size(); ++n) {
        firstOf_.push_back(frames_.size());
        int last = -1;
        segmentation.segments[n].voxels->forEach([&](const glm::ivec3& voxel) {
            if (voxel.z != last) frames_.push_back({n, voxel.z});  // slices come in ascending order
            last = voxel.z;
            if (isTaken.empty()) return;
            const std::size_t at =
                (std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y)) * std::size_t(size.x) +
                std::size_t(voxel.x);
            doOverlap_ = doOverlap_ || isTaken[at];
            isTaken[at] = true;
        });
    }
}

double SegmentFrames::bytesOfCells() const {
    const double bits = double(frames_.size()) * segmentation_.size.x * segmentation_.size.y;
    return 2.0 * std::ceil(bits / 16.0);
}

std::vector<std::uint8_t> SegmentFrames::cells() const {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(bytesOfCells()));
    const auto columns = std::size_t(segmentation_.size.x);
    const auto rows = std::size_t(segmentation_.size.y);
    for (std::size_t n = 0; n < segmentation_.segments.size(); ++n) {
        std::size_t frame = firstOf_[n];
        segmentation_.segments[n].voxels->forEach([&](const glm::ivec3& voxel) {
            while (frames_[frame].slice != voxel.z) ++frame;
            const std::size_t bit = (frame * rows + std::size_t(voxel.y)) * columns + std::size_t(voxel.x);
            bytes[bit / 8] = std::uint8_t(bytes[bit / 8] | 1u << bit % 8);
        });
    }
    return bytes;
}

}  // namespace macula::dicom

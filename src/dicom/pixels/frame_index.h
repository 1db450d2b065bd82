// Finds the frames of encapsulated pixel data (PS3.5 A.4), whatever their division into fragments.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dicom/read/random_file.h"
#include "dicom/read/transfer_syntax.h"

namespace macula::dicom {

// A part of a file.
struct Extent {
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
};

class FrameIndex {
  public:
    // The number of frames that are complete: fewer than the header claims when the file is cut off.
    std::size_t frames() const { return ends_.size(); }
    // The extents of a frame, all inside the file: together they are its stream.
    std::span<const Extent> operator[](std::size_t frame) const {
        const std::size_t first = frame == 0 ? 0 : ends_[frame - 1];
        return std::span(extents_).subspan(first, ends_[frame] - first);
    }

    void addFrame(std::span<const Extent> extents) {
        extents_.insert(extents_.end(), extents.begin(), extents.end());
        ends_.push_back(extents_.size());
    }

  private:
    std::vector<Extent> extents_;
    std::vector<std::size_t> ends_;  // where each frame ends, in extents_
};

// `firstItem`: where the item of the Basic Offset Table begins. `frames`: as the header claims. Separates
// frames by that table, by the extended one (7FE0,0001; empty when there is none), by taking one fragment for
// each, or by the markers at the beginning and end of streams; nothing when none of these fits. Takes memory
// in proportion to the items in the file, whatever the header claims.
std::optional<FrameIndex> indexFrames(const RandomFile& file, std::uint64_t firstItem, std::size_t frames,
                                      Codec codec, std::span<const std::uint64_t> extendedOffsets);

}  // namespace macula::dicom

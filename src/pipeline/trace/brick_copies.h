// Copies of bricks for a few rays that cross them cell by cell. In a copy all voxels that a brick's cells
// read lie in rows, whatever blocks they come from, so that a cell's corners are at fixed distances from its
// first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "pipeline/trace/host_tables.h"

namespace macula::trace {

// Used by one thread.
class BrickCopies {
  public:
    // A copy holds voxels 8b - 2 to 8b + 8 of a brick b along each axis; beyond the volume its outer voxels
    // repeat.
    static constexpr int kEdge = 11;
    static constexpr int kRow = 12;  // values from one row to the next
    static constexpr int kLayer = kRow * kEdge;
    static constexpr int kValues = kLayer * kEdge + 4;    // of a copy; two at a time can be read from each
    static constexpr int kFirstCell = kLayer + kRow + 1;  // voxel 8b - 1

    // `reach`, 0 or 1, says how far around its cells a brick's values are read. With 0, nobody sets the
    // outermost voxels of copies.
    BrickCopies(const PooledVoxels& voxels, const glm::ivec3& size, int reach);

    // Where the copy of a brick begins. It stays there as long as a lane holds it.
    std::int32_t hold(std::size_t lane, const glm::ivec3& brick);

    std::size_t count() const { return bricks_.size(); }  // of copies that may exist
    const std::uint16_t* values() const { return values_.get(); }

    static constexpr std::size_t kHolders = 16;

  private:
    static constexpr std::size_t kNone = std::size_t(-1);

    // The part of a brick's copy along an axis that one block holds.
    struct Part {
        int block = 0;
        int first = 0;  // voxel of the block
        int count = 0;
        int to = 0;  // voxel of the copy
    };
    struct Parts {
        Part before, within, after;
    };

    Parts partsAlong(int brick, int last) const;
    void copy(const glm::ivec3& brick, std::uint16_t* to) const;
    void repeatOuter(int brick, int last, int stride, std::uint16_t* to) const;
    void copyPart(const Part& x, const Part& y, const Part& z, std::uint16_t* to) const;

    PooledVoxels voxels_;
    glm::ivec3 last_;
    int reach_;
    std::unique_ptr<std::uint16_t[]> values_;
    std::vector<std::int64_t> bricks_;   // by copy: the index of its brick, or -1
    std::vector<std::uint8_t> holders_;  // by copy
    std::size_t held_[kHolders];         // by lane
};

}  // namespace macula::trace

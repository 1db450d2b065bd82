// A subset of the voxels of a grid: a bit for each voxel of a box.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace macula {

class VoxelSet {
  public:
    VoxelSet() = default;  // empty
    // An empty set within a box, both corners included. May throw std::bad_alloc.
    VoxelSet(const glm::ivec3& low, const glm::ivec3& high);

    // The bytes that a set within such a box takes, at least; may exceed the memory of the machine.
    static double bytesFor(const glm::ivec3& low, const glm::ivec3& high);

    bool contains(const glm::ivec3& voxel) const {
        const glm::ivec3 at = voxel - low_;
        if (!isInBox(at)) return false;
        return (words_[wordOf(at)] >> (at.x % kBits) & 1u) != 0;
    }
    // `voxel` must lie within the box.
    void add(const glm::ivec3& voxel);

    std::size_t count() const;
    bool isEmpty() const;
    const glm::ivec3& low() const { return low_; }
    glm::ivec3 high() const { return low_ + size_ - 1; }  // below `low` if there is no box
    std::size_t bytes() const { return words_.size() * sizeof(Word); }

    // The same set within the smallest box.
    VoxelSet cropped() const;

    // Calls visit(voxel) for each voxel of the set, x fastest, then y, then z.
    template <class Visit>
    void forEach(const Visit& visit) const {
        std::size_t n = 0;
        for (int z = 0; z < size_.z; ++z) {
            for (int y = 0; y < size_.y; ++y) {
                for (int w = 0; w < wordsPerRow_; ++w) {
                    for (Word word = words_[n++]; word != 0; word &= word - 1)
                        visit(low_ + glm::ivec3(w * kBits + std::countr_zero(word), y, z));
                }
            }
        }
    }

    bool operator==(const VoxelSet& b) const;  // the same voxels, whatever the boxes

  private:
    using Word = std::uint64_t;
    static constexpr int kBits = 64;

    bool isInBox(const glm::ivec3& at) const {
        return at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < size_.x && at.y < size_.y && at.z < size_.z;
    }
    std::size_t wordOf(const glm::ivec3& at) const {
        return (std::size_t(at.z) * std::size_t(size_.y) + std::size_t(at.y)) * std::size_t(wordsPerRow_) +
               std::size_t(at.x / kBits);
    }

    glm::ivec3 low_{0};
    glm::ivec3 size_{0};
    int wordsPerRow_ = 0;
    std::vector<Word> words_;  // each row of x starts a new word
};

}  // namespace macula

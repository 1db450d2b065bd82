#include "base/voxel_set.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace macula {

VoxelSet::VoxelSet(const glm::ivec3& low, const glm::ivec3& high) : low_(low), size_(high - low + 1) {
    MACULA_CHECK(size_.x > 0 && size_.y > 0 && size_.z > 0);
    wordsPerRow_ = (size_.x + kBits - 1) / kBits;
    words_.resize(std::size_t(wordsPerRow_) * std::size_t(size_.y) * std::size_t(size_.z));
}

double VoxelSet::bytesFor(const glm::ivec3& low, const glm::ivec3& high) {
    const glm::dvec3 size = glm::dvec3(high) - glm::dvec3(low) + 1.0;
    return std::ceil(size.x / kBits) * size.y * size.z * double(sizeof(Word));
}

void VoxelSet::add(const glm::ivec3& voxel) {
    const glm::ivec3 at = voxel - low_;
    MACULA_CHECK(isInBox(at));
    words_[wordOf(at)] |= Word{1} << (at.x % kBits);
}

std::size_t VoxelSet::count() const {
    std::size_t sum = 0;
    for (const Word word : words_) sum += std::size_t(std::popcount(word));
    return sum;
}

bool VoxelSet::isEmpty() const {
    return std::all_of(words_.begin(), words_.end(), [](Word word) { return word == 0; });
}

VoxelSet VoxelSet::cropped() const {
    glm::ivec3 least = high() + 1;
    glm::ivec3 most = low_ - 1;
    forEach([&](const glm::ivec3& voxel) {
        least = glm::min(least, voxel);
        most = glm::max(most, voxel);
    });
    if (most.x < least.x) return {};
    if (least == low_ && most == high()) return *this;
    VoxelSet smaller(least, most);
    forEach([&](const glm::ivec3& voxel) { smaller.add(voxel); });
    return smaller;
}

bool VoxelSet::operator==(const VoxelSet& b) const {
    const VoxelSet mine = cropped();
    const VoxelSet other = b.cropped();
    return mine.low_ == other.low_ && mine.size_ == other.size_ && mine.words_ == other.words_;
}

}  // namespace macula

#include "base/label_map.h"

#include <algorithm>

#include "base/check.h"

namespace macula {

Result<LabelMap> LabelMap::create(glm::ivec3 size, const glm::dmat4& worldFromVoxel,
                                  std::vector<Segment> segments, std::vector<std::uint16_t> labels,
                                  std::vector<Message> messages) {
    const auto fail = [](Text message) {
        return Error{ErrorCode::inputNotUsable, std::move(message), {}, Text("Choose another segmentation.")};
    };
    if (size.x < 1 || size.y < 1 || size.z < 1) return fail(Text("The segmentation has no voxels."));
    const auto slice = std::uint64_t(size.x) * std::uint64_t(size.y);  // the product of three might overflow
    if (labels.size() / slice != std::uint64_t(size.z) || labels.size() % slice != 0)
        return fail(Text("The segmentation has not as many voxels as its size says."));
    if (!isInvertibleAffine(worldFromVoxel))
        return fail(Text("The segmentation does not say where it lies."));
    LabelMap map;
    map.size_ = size;
    map.worldFromVoxel_ = worldFromVoxel;
    map.segments_ = std::move(segments);
    std::stable_sort(map.segments_.begin(), map.segments_.end(),
                     [](const Segment& a, const Segment& b) { return a.number < b.number; });
    map.labels_ = std::move(labels);
    map.messages_ = std::move(messages);
    return map;
}

const Segment* LabelMap::segment(std::uint16_t number) const {
    const auto at = std::lower_bound(segments_.begin(), segments_.end(), number,
                                     [](const Segment& s, std::uint16_t n) { return s.number < n; });
    return at != segments_.end() && at->number == number ? &*at : nullptr;
}

std::uint16_t LabelMap::label(int i, int j, int k) const {
    MACULA_CHECK(i >= 0 && i < size_.x && j >= 0 && j < size_.y && k >= 0 && k < size_.z);
    return labels_[(static_cast<std::size_t>(k) * static_cast<std::size_t>(size_.y) +
                    static_cast<std::size_t>(j)) *
                       static_cast<std::size_t>(size_.x) +
                   static_cast<std::size_t>(i)];
}

}  // namespace macula

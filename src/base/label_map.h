// Label maps: which voxels belong to which organ or lesion, as a person or a program drew them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/frames.h"
#include "base/message.h"
#include "base/result.h"

namespace macula {

struct Segment {
    std::uint16_t number = 0;  // the value of its voxels; at least 1 in a label map
    std::string label;         // UTF-8, as all text here
    std::string description;
    std::string algorithm;                                      // MANUAL, SEMIAUTOMATIC or AUTOMATIC
    std::string algorithmName;                                  // name of the program that made the segment
    std::optional<std::array<std::uint8_t, 3>> recommendedRgb;  // in sRGB

    bool operator==(const Segment&) const = default;
};

// Immutable grid of segment numbers, i fastest, then j, then k; 0 means no segment.
class LabelMap {
  public:
    // Takes the labels over, without copying. Fails with inputNotUsable when a size is below 1, the number of
    // labels is not size.x * size.y * size.z, or the affine is not invertible.
    static Result<LabelMap> create(glm::ivec3 size, const glm::dmat4& worldFromVoxel,
                                   std::vector<Segment> segments, std::vector<std::uint16_t> labels,
                                   std::vector<Message> messages = {});

    glm::ivec3 size() const { return size_; }
    const glm::dmat4& worldFromVoxel() const { return worldFromVoxel_; }
    std::span<const Segment> segments() const { return segments_; }  // sorted by number
    const Segment* segment(std::uint16_t number) const;              // null when there is none
    std::span<const std::uint16_t> labels() const { return labels_; }
    std::uint16_t label(int i, int j, int k) const;
    std::span<const Message> messages() const { return messages_; }  // what loading found

  private:
    LabelMap() = default;

    glm::ivec3 size_{0};
    glm::dmat4 worldFromVoxel_{1.0};
    std::vector<Segment> segments_;
    std::vector<std::uint16_t> labels_;
    std::vector<Message> messages_;
};

}  // namespace macula

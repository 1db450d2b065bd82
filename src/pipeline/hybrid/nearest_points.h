// Which of many points is nearest to a place, if one is near at all.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace macula::hybrid {

// Cells of a grid as wide as what is near. A function of its arguments: of two that are as near the first one
// counts.
class NearestPoints {
  public:
    // Coordinates must be finite, `nearMm` above 0.
    NearestPoints(std::span<const glm::vec3> points, double nearMm);

    // Index of the one that is nearest, none farther than `nearMm`.
    std::optional<std::size_t> nearest(const glm::vec3& place) const;

  private:
    using Cell = glm::i64vec3;
    Cell cellOf(const glm::vec3& place) const;

    struct Hash {
        std::size_t operator()(const Cell& cell) const;
    };

    std::vector<glm::vec3> points_;
    double nearMm_;
    std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> cells_;
};

}  // namespace macula::hybrid

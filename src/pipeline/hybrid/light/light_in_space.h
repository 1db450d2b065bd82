// A radiance cache: the light that leaves matter, by place, as traced views have found it, for views from
// elsewhere that are not traced.
//
// Where the phase function is isotropic, what is scattered at a place goes to all sides alike, so light that
// was found for one view is that of every other, in thin matter and haze as well, where a picture has no one
// depth. Places are gathered in cells, though, and a cell may hold both sides of a thin wall. So each keeps
// six means, of light that was seen along +x, -x, +y, -y, +z and -z, a direction counting for the three it
// lies between with the squares of its components: the ambient cube (McTaggart 2004, "Half-Life 2 / Valve
// Source Shading").
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace macula::hybrid {

// All places in mm of one frame, directions of unit length, from the eye.
class LightInSpace {
  public:
    static constexpr std::size_t kMostCells = 1u << 21;  // cells of 96 bytes: as many as a body has pixels

    // `cellMm` above 0: about what a pixel of the views shows. Doubled whenever there are more than
    // `mostCells`, which is at least 8.
    explicit LightInSpace(double cellMm, std::size_t mostCells = kMostCells)
        : cellMm_(cellMm), mostCells_(mostCells) {}

    // What does not come as finite numbers, or from too far (10^6 cells), is left out; radiance above 10^6
    // counts as that.
    void add(const glm::dvec3& atMm, const glm::dvec3& direction, const glm::vec3& radiance);

    // Turns sums into means, once all is added. Where a cell knows little, what is known around it counts as
    // well, as half a sample.
    void finish();

    // The radiance that leaves `atMm` against `direction`, linear between the cells around; nothing where
    // nothing was seen within a cell.
    std::optional<glm::vec3> at(const glm::dvec3& atMm, const glm::dvec3& direction) const;

    double cellMm() const { return cellMm_; }
    std::size_t cells() const { return levels_.front().cells.size(); }

  private:
    // Sums of radiance and of weights; after finish() means and weights.
    using Cell = std::array<glm::vec4, 6>;

    // Cells by place: a hash table with open addressing.
    struct Level {
        std::vector<std::uint64_t> keys;    // by slot; kFree: none
        std::vector<std::uint32_t> places;  // by slot: which cell
        std::vector<Cell> cells;

        const Cell* find(const glm::ivec3& at) const;
        Cell& at(const glm::ivec3& at);
        void grow();
    };
    static Level halved(const Level& level);  // of cells twice as large

    double cellMm_;
    std::size_t mostCells_;
    std::vector<Level> levels_ = std::vector<Level>(1);  // each of cells twice as large as the one before
};

}  // namespace macula::hybrid

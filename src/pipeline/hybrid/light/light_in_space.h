// A radiance cache: the light that leaves matter, by place, as traced views have found it. It lights views
// from elsewhere that are not traced.
//
// With an isotropic phase function, a place scatters light equally to all sides, so what one view has found
// holds for every other, even in thin matter and haze, where a pixel has no single depth. A cell, though, may
// hold both sides of a thin wall. So each cell keeps six means, of light seen along +x, -x, +y, -y, +z and
// -z; a direction counts for the three next to it, with the squares of its components as weights: the
// ambient cube (McTaggart 2004, "Half-Life 2 / Valve Source Shading").
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "shared/primary_vertex.h"

namespace macula::hybrid {

// All places are in mm of one coordinate frame; directions have unit length and lead away from the eye.
class LightInSpace {
  public:
    static constexpr std::size_t kMostCells = 1u << 21;  // cells of 96 bytes: about the pixels of a body

    // `cellMm` above 0: about what a pixel of the views covers. It is doubled whenever add() or addAll() has
    // left more than `mostCells` cells. `mostCells` must be at least 8.
    explicit LightInSpace(double cellMm, std::size_t mostCells = kMostCells)
        : cellMm_(cellMm), mostCells_(mostCells) {}

    // Ignores light that is not finite, or from too far away (10^6 cells); radiance above 10^6 counts as
    // 10^6.
    void add(const glm::dvec3& atMm, const glm::dvec3& direction, const glm::vec3& radiance);
    // The same for all vertices that paths from an eye have met, in their order. Uses all cores; the sums are
    // the same, to the last bit, on any number of cores.
    void addAll(const glm::dvec3& eyeMm, std::span<const shared::PrimaryVertex> met);

    // Turns sums into means. Call once, after the last add. The mean around a cell counts as half a sample of
    // it, which helps cells with few samples.
    void finish();

    // The radiance that leaves `atMm` against `direction`, interpolated linearly between cells; nothing if no
    // light was seen within about a cell.
    std::optional<glm::vec3> at(const glm::dvec3& atMm, const glm::dvec3& direction) const;

    double cellMm() const { return cellMm_; }
    std::size_t cells() const { return countOf(levels_.front()); }

    // Sums of radiance and of weights along +x, -x, +y, -y, +z and -z; after finish() means and weights.
    using Cell = std::array<glm::vec4, 6>;
    // at() weighs the means of a cell's sides by how near the cell is, times this: a side with more samples
    // counts for more.
    static double trust(float weight);

    // A cell's coordinates as a key: x << 42 | y << 21 | z, each plus 2^20.
    static constexpr int kFarthest = 1 << 20;  // cells from the origin, in each direction
    // The hash of a key: a finaliser of MurmurHash3 over its two halves, which a shader without 64-bit
    // numbers computes too (scatteredKey in shaders/lib/light_cells.glsl).
    static std::uint32_t hashOf(std::uint64_t key);
    // Each table holds a share of the cells, so that as many cores can fill and read them.
    static constexpr std::size_t kTables = 16;
    // The cells of a table, in the order in which they were first seen; and the key of each, in an order that
    // depends only on what was added.
    std::span<const Cell> cellsOf(std::size_t table) const { return levels_.front()[table].cells; }
    void forEachKeyOf(std::size_t table,
                      const std::function<void(std::uint64_t key, std::size_t cell)>& body) const;

  private:
    // Cells by place: a hash table with open addressing.
    struct Table {
        std::vector<std::uint64_t> keys;    // by slot; kFree: none
        std::vector<std::uint32_t> places;  // by slot: index into `cells`
        std::vector<Cell> cells;

        const Cell* find(std::uint64_t key) const;
        Cell& at(std::uint64_t key);
        void grow();
    };
    using Level = std::array<Table, kTables>;

    // Light that left a place towards an eye.
    struct Seen {
        glm::dvec3 atMm{0.0};
        glm::dvec3 direction{0.0};  // from the eye
        glm::vec3 radiance{0.0f};
    };
    // Indices of things by their table: those of table t are ordered[begins[t]] to before ordered[begins[t +
    // 1]], in their original order.
    struct Sorted {
        std::vector<std::uint32_t> ordered;
        std::array<std::uint32_t, kTables + 1> begins{};
    };

    static Sorted sortedByTable(std::span<const std::uint64_t> keys);
    static Sorted sortedByParent(const Table& table);
    static std::size_t countOf(const Level& level);
    static const Cell* find(const Level& level, const glm::ivec3& at);
    static Level halved(const Level& level);  // with cells twice as large
    std::uint64_t keyOfPlace(const Seen& seen) const;
    static void addTo(Cell& sums, const Seen& seen);
    void halveWhileTooMany();
    void finish(const Level* coarser, Table& table) const;

    double cellMm_;
    std::size_t mostCells_;
    std::vector<Level> levels_ = std::vector<Level>(1);  // each has cells twice as large as the last
    // Scratch of addAll, kept for the next call.
    std::vector<std::uint64_t> keys_;
    std::vector<Sorted> sorted_;
};

}  // namespace macula::hybrid

#include "pipeline/hybrid/light/light_in_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"

namespace macula::hybrid {

namespace {

constexpr std::uint64_t kFree = ~std::uint64_t(0);
constexpr std::size_t kFirstSlots = 1u << 12;  // a power of two
constexpr int kFarthest = LightInSpace::kFarthest;
constexpr int kCoarser = 3;            // levels beyond the first
constexpr float kMostRadiance = 1e6f;  // 1 is white; sums of larger values might not be finite
constexpr float kPrior = 0.5f;         // samples that the mean around a cell counts for
// With so many samples a cell has its full weight among its neighbours.
constexpr double kEnough = 4.0;
constexpr double kAtLeast = 1e-3;

// The key of a cell, 21 bits for each number.
std::uint64_t keyOf(const glm::ivec3& at) {
    const auto part = [](int v) { return static_cast<std::uint64_t>(std::int64_t(v) + kFarthest); };
    return part(at.x) << 42 | part(at.y) << 21 | part(at.z);
}

glm::ivec3 cellOf(std::uint64_t key) {
    const auto part = [&](int shift) { return int(key >> shift & 0x1fffff) - kFarthest; };
    return {part(42), part(21), part(0)};
}

// The slot of the key, or the free slot in which it belongs.
std::size_t slotOf(const std::vector<std::uint64_t>& keys, std::uint64_t key) {
    std::size_t slot = LightInSpace::hashOf(key) & (keys.size() - 1);
    while (keys[slot] != key && keys[slot] != kFree) slot = (slot + 1) & (keys.size() - 1);
    return slot;
}

// The table of a key, from the upper bits of its hash; slots come from the lower ones.
std::size_t tableOf(std::uint64_t key, std::size_t tables) {
    return LightInSpace::hashOf(key) >> 28 & (tables - 1);
}

// Whether a cell is within `most` of the origin; false for NaN.
bool isWithin(const glm::dvec3& cell, int most) {
    return std::abs(cell.x) < most && std::abs(cell.y) < most && std::abs(cell.z) < most;
}

glm::ivec3 parentOf(const glm::ivec3& at) {
    return {at.x >> 1, at.y >> 1, at.z >> 1};
}

// Calls body(lobe, weight) for the three lobes next to a direction.
template <class Body>
void forEachLobe(const glm::dvec3& direction, const Body& body) {
    for (int axis = 0; axis < 3; ++axis) {
        const double along = direction[axis];
        body(2 * std::size_t(axis) + (along < 0.0 ? 1 : 0), along * along);
    }
}

}  // namespace

std::uint32_t LightInSpace::hashOf(std::uint64_t key) {
    auto h = static_cast<std::uint32_t>(key) * 0x9e3779b1u ^ static_cast<std::uint32_t>(key >> 32);
    h ^= h >> 16;
    h *= 0x85ebca6bu;
    h ^= h >> 13;
    h *= 0xc2b2ae35u;
    return h ^ h >> 16;
}

double LightInSpace::trust(float weight) {
    return kAtLeast + std::min(double(weight), kEnough);
}

const LightInSpace::Cell* LightInSpace::Table::find(std::uint64_t key) const {
    if (keys.empty()) return nullptr;
    const std::size_t slot = slotOf(keys, key);
    return keys[slot] == kFree ? nullptr : &cells[places[slot]];
}

LightInSpace::Cell& LightInSpace::Table::at(std::uint64_t key) {
    if (2 * (cells.size() + 1) > keys.size()) grow();
    const std::size_t slot = slotOf(keys, key);
    if (keys[slot] != kFree) return cells[places[slot]];
    keys[slot] = key;
    places[slot] = static_cast<std::uint32_t>(cells.size());
    return cells.emplace_back(Cell{});
}

void LightInSpace::Table::grow() {
    const std::size_t slots = std::max(2 * keys.size(), kFirstSlots);
    const auto oldKeys = std::exchange(keys, std::vector<std::uint64_t>(slots, kFree));
    const auto oldPlaces = std::exchange(places, std::vector<std::uint32_t>(slots, 0));
    for (std::size_t i = 0; i < oldKeys.size(); ++i) {
        if (oldKeys[i] == kFree) continue;
        const std::size_t slot = slotOf(keys, oldKeys[i]);
        keys[slot] = oldKeys[i];
        places[slot] = oldPlaces[i];
    }
}

std::size_t LightInSpace::countOf(const Level& level) {
    std::size_t count = 0;
    for (const Table& table : level) count += table.cells.size();
    return count;
}

const LightInSpace::Cell* LightInSpace::find(const Level& level, const glm::ivec3& at) {
    const std::uint64_t key = keyOf(at);
    return level[tableOf(key, kTables)].find(key);
}

// Leaves out keys that are kFree.
LightInSpace::Sorted LightInSpace::sortedByTable(std::span<const std::uint64_t> keys) {
    Sorted sorted;
    std::vector<std::uint8_t> tables(keys.size());
    std::array<std::uint32_t, kTables> next{};
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (keys[i] == kFree) continue;
        tables[i] = static_cast<std::uint8_t>(tableOf(keys[i], kTables));
        ++next[tables[i]];
    }
    for (std::size_t t = 0; t < kTables; ++t) {
        sorted.begins[t + 1] = sorted.begins[t] + next[t];
        next[t] = sorted.begins[t];
    }
    sorted.ordered.resize(sorted.begins.back());
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i] != kFree) sorted.ordered[next[tables[i]]++] = static_cast<std::uint32_t>(i);
    return sorted;
}

// The slots, sorted by the table of the cell of twice the size that contains theirs.
LightInSpace::Sorted LightInSpace::sortedByParent(const Table& table) {
    std::vector<std::uint64_t> parents(table.keys.size(), kFree);
    for (std::size_t slot = 0; slot < parents.size(); ++slot)
        if (table.keys[slot] != kFree) parents[slot] = keyOf(parentOf(cellOf(table.keys[slot])));
    return sortedByTable(parents);
}

// Uses all cores; sums cells in the order of tables and slots, whatever the number of cores.
LightInSpace::Level LightInSpace::halved(const Level& level) {
    std::array<Sorted, kTables> sorted;
    parallelFor(kTables, [&](std::size_t t) { sorted[t] = sortedByParent(level[t]); });
    Level half;
    parallelFor(kTables, [&](std::size_t to) {
        for (std::size_t t = 0; t < kTables; ++t) {
            const Table& table = level[t];
            for (std::uint32_t i = sorted[t].begins[to]; i < sorted[t].begins[to + 1]; ++i) {
                const std::uint32_t slot = sorted[t].ordered[i];
                Cell& sums = half[to].at(keyOf(parentOf(cellOf(table.keys[slot]))));
                const Cell& from = table.cells[table.places[slot]];
                for (std::size_t lobe = 0; lobe < from.size(); ++lobe) sums[lobe] += from[lobe];
            }
        }
    });
    return half;
}

// kFree if the place is to be ignored.
std::uint64_t LightInSpace::keyOfPlace(const Seen& seen) const {
    const glm::dvec3 cell = glm::floor(seen.atMm / cellMm_);
    const glm::vec3& light = seen.radiance;
    const bool isFinite = std::isfinite(light.x) && std::isfinite(light.y) && std::isfinite(light.z);
    return isWithin(cell, kFarthest) && isFinite ? keyOf(glm::ivec3(cell)) : kFree;
}

void LightInSpace::addTo(Cell& sums, const Seen& seen) {
    forEachLobe(seen.direction, [&](std::size_t lobe, double weight) {
        sums[lobe] += float(weight) * glm::vec4(glm::min(seen.radiance, kMostRadiance), 1.0f);
    });
}

void LightInSpace::add(const glm::dvec3& atMm, const glm::dvec3& direction, const glm::vec3& radiance) {
    const Seen seen{atMm, direction, radiance};
    const std::uint64_t key = keyOfPlace(seen);
    if (key == kFree) return;
    addTo(levels_.front()[tableOf(key, kTables)].at(key), seen);
    halveWhileTooMany();
}

void LightInSpace::addAll(const glm::dvec3& eyeMm, std::span<const shared::PrimaryVertex> met) {
    constexpr std::size_t kPart = 1u << 14;
    const auto placeOf = [&](std::size_t i) { return eyeMm + glm::dvec3(met[i].fromEyeMm); };
    keys_.resize(met.size());
    sorted_.resize((met.size() + kPart - 1) / kPart);
    parallelFor(sorted_.size(), [&](std::size_t part) {
        const std::size_t end = std::min((part + 1) * kPart, met.size());
        for (std::size_t i = part * kPart; i < end; ++i)
            keys_[i] =
                met[i].fromEyeMm != glm::vec3(0.0f) ? keyOfPlace({placeOf(i), {}, met[i].radiance}) : kFree;
        sorted_[part] = sortedByTable(std::span(keys_).subspan(part * kPart, end - part * kPart));
    });
    parallelFor(kTables, [&](std::size_t t) {
        Table& table = levels_.front()[t];
        for (std::size_t part = 0; part < sorted_.size(); ++part) {
            const Sorted& sorted = sorted_[part];
            for (std::uint32_t n = sorted.begins[t]; n < sorted.begins[t + 1]; ++n) {
                const std::size_t i = part * kPart + sorted.ordered[n];
                const glm::dvec3 direction = glm::normalize(glm::dvec3(met[i].fromEyeMm));
                addTo(table.at(keys_[i]), {placeOf(i), direction, met[i].radiance});
            }
        }
    });
    halveWhileTooMany();
}

// A loop, because cells far apart merge only after several doublings.
void LightInSpace::halveWhileTooMany() {
    while (cells() > mostCells_) {
        levels_.front() = halved(levels_.front());
        cellMm_ *= 2.0;
    }
}

void LightInSpace::finish() {
    for (int i = 0; i < kCoarser; ++i) levels_.push_back(halved(levels_.back()));
    // Begins with the coarsest level, so that coarser cells already hold means.
    for (std::size_t i = levels_.size(); i-- > 0;) {
        const Level* coarser = i + 1 < levels_.size() ? &levels_[i + 1] : nullptr;
        parallelFor(kTables, [&](std::size_t t) { finish(coarser, levels_[i][t]); });
    }
    levels_.resize(1);  // coarser levels are no longer needed
    keys_ = {};
    sorted_ = {};
}

void LightInSpace::finish(const Level* coarser, Table& table) const {
    for (std::size_t slot = 0; slot < table.keys.size(); ++slot) {
        if (table.keys[slot] == kFree) continue;
        Cell& cell = table.cells[table.places[slot]];
        const Cell* around = coarser ? find(*coarser, parentOf(cellOf(table.keys[slot]))) : nullptr;
        glm::vec4 fromAllSides(0.0f);
        for (const glm::vec4& sum : cell) fromAllSides += sum;
        for (std::size_t lobe = 0; lobe < cell.size(); ++lobe) {
            const glm::vec3 usual = around != nullptr
                                        ? glm::vec3((*around)[lobe])
                                        : glm::vec3(fromAllSides) / std::max(fromAllSides.w, 1e-20f);
            const float weight = cell[lobe].w;
            cell[lobe] = glm::vec4((glm::vec3(cell[lobe]) + kPrior * usual) / (weight + kPrior), weight);
        }
    }
}

void LightInSpace::forEachKeyOf(std::size_t table,
                                const std::function<void(std::uint64_t, std::size_t)>& body) const {
    const Table& of = levels_.front()[table];
    for (std::size_t slot = 0; slot < of.keys.size(); ++slot)
        if (of.keys[slot] != kFree) body(of.keys[slot], of.places[slot]);
}

std::optional<glm::vec3> LightInSpace::at(const glm::dvec3& atMm, const glm::dvec3& direction) const {
    const glm::dvec3 place = atMm / cellMm_ - 0.5;
    const glm::dvec3 low = glm::floor(place);
    if (!isWithin(low, kFarthest - 1)) return {};
    const glm::dvec3 part = place - low;
    glm::dvec3 light(0.0);
    double weights = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
        const Cell* cell = find(levels_.front(), glm::ivec3(low) + step);
        if (cell == nullptr) continue;
        const glm::dvec3 near = glm::mix(1.0 - part, part, glm::dvec3(step));
        forEachLobe(direction, [&](std::size_t lobe, double along) {
            const glm::vec4& mean = (*cell)[lobe];
            const double weight = near.x * near.y * near.z * along * trust(mean.w);
            light += weight * glm::dvec3(mean);
            weights += weight;
        });
    }
    if (!(weights > 0.0)) return {};
    return glm::vec3(light / weights);
}

}  // namespace macula::hybrid

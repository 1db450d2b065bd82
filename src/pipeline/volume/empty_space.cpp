#include "pipeline/volume/empty_space.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/check.h"
#include "base/parallel.h"

namespace macula {

namespace {

static_assert(kMaxLeap == 255);  // distances are kept in bytes
using Distance = std::uint8_t;

Distance oneMore(Distance distance) {
    return distance == kMaxLeap ? distance : static_cast<Distance>(distance + 1);
}

// Limits each distance to one more than the three nearest ones in the row before: a straight or a diagonal
// step.
void stepFrom(const Distance* before, Distance* row, int count) {
    for (int x = 0; x < count; ++x) {
        const Distance left = before[std::max(x - 1, 0)];
        const Distance right = before[std::min(x + 1, count - 1)];
        row[x] = std::min(row[x], oneMore(std::min({left, before[x], right})));
    }
}

// Propagates distances along one row, both ways.
void sweepRow(Distance* row, int count) {
    for (int x = 1; x < count; ++x) row[x] = std::min(row[x], oneMore(row[x - 1]));
    for (int x = count - 2; x >= 0; --x) row[x] = std::min(row[x], oneMore(row[x + 1]));
}

}  // namespace

// A distance transform, dimension by dimension: distances within rows, then within planes by steps from row
// to row in both directions, then in space by steps from plane to plane. A diagonal step is one unit of
// Chebyshev distance, so each sweep is exact for all that it has passed. Planes, and later rows of a plane,
// do not depend on each other, and are processed on all cores.
void measureEmptySpace(glm::ivec3 gridSize, std::span<float> bounds) {
    const auto width = static_cast<std::size_t>(gridSize.x);
    const auto height = static_cast<std::size_t>(gridSize.y);
    const auto depth = static_cast<std::size_t>(gridSize.z);
    MACULA_CHECK_EQ(bounds.size(), width * height * depth);
    std::vector<Distance> distance(bounds.size());
    const auto rowAt = [&](std::size_t y, std::size_t z) {
        return distance.data() + (z * height + y) * width;
    };

    parallelFor(depth, [&](std::size_t z) {
        for (std::size_t y = 0; y < height; ++y) {
            const float* bound = bounds.data() + (z * height + y) * width;
            Distance* row = rowAt(y, z);
            for (std::size_t x = 0; x < width; ++x) row[x] = bound[x] > 0.0f ? 0 : kMaxLeap;
            sweepRow(row, gridSize.x);
        }
        for (std::size_t y = 1; y < height; ++y) stepFrom(rowAt(y - 1, z), rowAt(y, z), gridSize.x);
        for (std::size_t y = height - 1; y-- > 0;) stepFrom(rowAt(y + 1, z), rowAt(y, z), gridSize.x);
    });

    // Several rows for each task, so that a task costs more than its start.
    constexpr std::size_t kBricksPerTask = 8192;
    const std::size_t rows = std::max<std::size_t>(kBricksPerTask / width, 1);
    const auto stepPlane = [&](std::size_t before, std::size_t z) {
        parallelFor((height + rows - 1) / rows, [&](std::size_t task) {
            for (std::size_t y = task * rows; y < std::min(height, (task + 1) * rows); ++y) {
                for (std::size_t n = y > 0 ? y - 1 : 0; n <= std::min(y + 1, height - 1); ++n)
                    stepFrom(rowAt(n, before), rowAt(y, z), gridSize.x);
            }
        });
    };
    for (std::size_t z = 1; z < depth; ++z) stepPlane(z - 1, z);
    for (std::size_t z = depth - 1; z-- > 0;) stepPlane(z + 1, z);

    parallelFor(depth, [&](std::size_t z) {
        for (std::size_t i = z * width * height; i < (z + 1) * width * height; ++i) {
            if (distance[i] > 0) bounds[i] = -static_cast<float>(distance[i]);
        }
    });
}

}  // namespace macula

#include "viewer/overlay/freehand_handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace macula::viewer {

namespace {

constexpr std::size_t kMostHandles = 8;

// The indices of the points that have a handle, ascending.
std::vector<std::size_t> heldPoints(std::size_t count, Freehand kind) {
    if (count < 2) return {};
    const std::size_t handles = std::min(count, kMostHandles);
    // A closed line goes on from its last point to the first.
    const std::size_t last = kind == Freehand::closed ? count : count - 1;
    const std::size_t parts = kind == Freehand::closed ? handles : handles - 1;
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < handles; ++i) indices.push_back(i * last / parts);
    return indices;
}

// How much a point moves with a handle `off` points away, where the next handle is `reach` points away.
double weightOf(std::size_t off, std::size_t reach) {
    return off < reach ? 0.5 * (1.0 + std::cos(std::numbers::pi * double(off) / double(reach))) : 0.0;
}

}  // namespace

std::vector<glm::dvec3> freehandHandles(const std::vector<glm::dvec3>& pointsMm, Freehand kind) {
    std::vector<glm::dvec3> handles;
    for (const std::size_t at : heldPoints(pointsMm.size(), kind)) handles.push_back(pointsMm[at]);
    if (kind == Freehand::open || handles.empty()) return handles;
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& mm : pointsMm) sum += mm;
    handles.push_back(sum / double(pointsMm.size()));
    return handles;
}

std::vector<glm::dvec3> withFreehandMoved(std::vector<glm::dvec3> pointsMm, std::size_t handle,
                                          const glm::dvec3& byMm, Freehand kind) {
    const std::vector<std::size_t> held = heldPoints(pointsMm.size(), kind);
    const bool isClosed = kind == Freehand::closed;
    if (isClosed && handle == held.size()) {
        for (glm::dvec3& mm : pointsMm) mm += byMm;
        return pointsMm;
    }
    if (handle >= held.size()) return pointsMm;
    const std::size_t count = pointsMm.size();
    const std::size_t at = held[handle];
    pointsMm[at] += byMm;
    if (handle + 1 < held.size() || isClosed) {
        const std::size_t next = handle + 1 < held.size() ? held[handle + 1] : held.front() + count;
        for (std::size_t off = 1; off < next - at; ++off)
            pointsMm[(at + off) % count] += weightOf(off, next - at) * byMm;
    }
    if (handle > 0 || isClosed) {
        const std::size_t from = at + count;  // so that differences are not negative
        const std::size_t before = handle > 0 ? held[handle - 1] + count : held.back();
        for (std::size_t off = 1; off < from - before; ++off)
            pointsMm[(from - off) % count] += weightOf(off, from - before) * byMm;
    }
    return pointsMm;
}

}  // namespace macula::viewer

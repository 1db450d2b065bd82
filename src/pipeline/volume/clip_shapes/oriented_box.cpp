// A box along any axes.
#include <limits>

#include "pipeline/volume/clip_shape_parts.h"

namespace macula {

namespace {

struct Ends {
    glm::dvec3 low;
    glm::dvec3 high;
};

// Finds ends from which `read` below makes the same box bit for bit, if there are any, because sums round.
Ends endsOf(const OrientedBox& box) {
    Ends ends{box.centreMm - box.halfSizeMm, box.centreMm + box.halfSizeMm};
    const auto isSame = [&](int axis, double low, double high) {
        return 0.5 * (low + high) == box.centreMm[axis] && 0.5 * (high - low) == box.halfSizeMm[axis];
    };
    constexpr double kFar = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double low = ends.low[axis];
        const double high = ends.high[axis];
        for (const double l : {low, std::nextafter(low, -kFar), std::nextafter(low, kFar)}) {
            for (const double h : {high, std::nextafter(high, -kFar), std::nextafter(high, kFar)}) {
                if (!isSame(axis, l, h)) continue;
                ends.low[axis] = l;
                ends.high[axis] = h;
            }
        }
    }
    return ends;
}

}  // namespace

std::array<HalfSpace, 6> sidesOf(const OrientedBox& box) {
    std::array<HalfSpace, 6> sides;
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 normal = box.axes[axis];
        const double centre = glm::dot(normal, box.centreMm);
        sides[2 * std::size_t(axis)] = {normal, centre - box.halfSizeMm[axis]};
        sides[2 * std::size_t(axis) + 1] = {-normal, -centre - box.halfSizeMm[axis]};
    }
    return sides;
}

std::vector<double> OrientedBox::numbers() const {
    return numbersOf({centreMm, axes[0], axes[1], axes[2], halfSizeMm});
}

Result<void> OrientedBox::check() const {
    const glm::dvec3 size = halfSizeMm;
    if (!isFinite(centreMm) || !isFinite(size) || std::min({size.x, size.y, size.z}) <= 0.0)
        return clipNotUsable(Text("the box has no size"),
                             Text("Give a centre and positive half sizes in mm."));
    const glm::dmat3 product = glm::transpose(axes) * axes;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            if (!(std::abs(product[i][j] - (i == j ? 1.0 : 0.0)) < 1e-6))
                return clipNotUsable(Text("the axes of the box are not at right angles"),
                                     Text("Give three unit vectors."));
        }
    }
    return {};
}

void OrientedBox::toMm(const Box& volume) {
    centreMm = mmOfFraction(centreMm, volume);
    halfSizeMm *= volume.high - volume.low;
}

void OrientedBox::toFractions(const Box& volume) {
    centreMm = fractionOfMm(centreMm, volume);
    halfSizeMm /= volume.high - volume.low;
}

OrientedBox OrientedBox::read(const JsonNode& node) {
    node.allowOnly({"low", "high", "keep"});
    const glm::dvec3 low = pointOf(node["low"]);
    const glm::dvec3 high = pointOf(node["high"]);
    if (!glm::all(glm::lessThan(low, high))) node.fail(Text("\"low\" below \"high\" on each axis"));
    return {.centreMm = 0.5 * (low + high), .halfSizeMm = 0.5 * (high - low)};
}

nlohmann::ordered_json OrientedBox::json() const {
    const auto [low, high] = endsOf(*this);
    return {{"low", listOf(low)}, {"high", listOf(high)}};
}

}  // namespace macula

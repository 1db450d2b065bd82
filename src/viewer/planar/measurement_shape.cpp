#include "viewer/planar/measurement_shape.h"

#include <cmath>
#include <numbers>

namespace macula::viewer {

namespace {

using Kind = study::ImageMeasurement::Kind;
using Points = std::vector<glm::dvec2>;

constexpr std::size_t kCentre = 4;  // the handle of an ellipse

Points outlineOf(const glm::dvec2& a, const glm::dvec2& b) {
    constexpr int kPieces = 96;
    const glm::dvec2 centre = 0.5 * (a + b);
    const glm::dvec2 radii = 0.5 * (b - a);
    Points outline;
    for (int i = 0; i <= kPieces; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kPieces;
        outline.push_back(centre + radii * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return outline;
}

}  // namespace

Points handlesOf(const study::ImageMeasurement& measurement) {
    const Points& p = measurement.points;
    if (measurement.kind != Kind::ellipse || p.size() != 2) return p;
    const glm::dvec2 low = glm::min(p[0], p[1]);
    const glm::dvec2 high = glm::max(p[0], p[1]);
    const glm::dvec2 centre = 0.5 * (low + high);
    return {{high.x, centre.y}, {low.x, centre.y}, {centre.x, high.y}, {centre.x, low.y}, centre};
}

std::vector<Points> linesOf(const study::ImageMeasurement& measurement) {
    const Points& p = measurement.points;
    if (p.size() < 2) return {};
    switch (measurement.kind) {
        case Kind::ellipse:
            return {outlineOf(p[0], p[1])};
        case Kind::cobb:
            if (p.size() < 4) return {{p[0], p[1]}};
            return {{p[0], p[1]}, {p[2], p[3]}};
        case Kind::distance:
        case Kind::angle:
            break;
    }
    return {p};
}

study::ImageMeasurement withHandleAt(const study::ImageMeasurement& measurement, std::size_t handle,
                                     const glm::dvec2& at) {
    study::ImageMeasurement moved = measurement;
    Points& p = moved.points;
    if (moved.kind != Kind::ellipse) {
        if (handle < p.size()) p[handle] = at;
        return moved;
    }
    if (handle == kCentre) return movedBy(moved, at - 0.5 * (p[0] + p[1]));
    glm::dvec2 low = glm::min(p[0], p[1]);
    glm::dvec2 high = glm::max(p[0], p[1]);
    constexpr double kLeast = 0.5;  // in pixels: it keeps an extent
    if (handle == 0) high.x = std::max(at.x, low.x + kLeast);
    if (handle == 1) low.x = std::min(at.x, high.x - kLeast);
    if (handle == 2) high.y = std::max(at.y, low.y + kLeast);
    if (handle == 3) low.y = std::min(at.y, high.y - kLeast);
    p = {low, high};
    return moved;
}

study::ImageMeasurement movedBy(study::ImageMeasurement measurement, const glm::dvec2& by) {
    for (glm::dvec2& point : measurement.points) point += by;
    return measurement;
}

}  // namespace macula::viewer

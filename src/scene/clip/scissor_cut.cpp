#include "scene/clip/scissor_cut.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/is_finite.h"

namespace macula::scene {

namespace {

constexpr double kLeastExtent = 1e-6;  // half heights: an outline that is thinner is a line
constexpr std::size_t kRows = 256;

Error notUsable(Text what) {
    return {ErrorCode::usage, std::move(what), {}, Text("Draw around what is to be removed, in one go.")};
}

double distanceToLine(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(point - a, along) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(point, a + t * along);
}

// Douglas-Peucker without recursion, because an outline drawn by hand may have any number of points.
std::vector<glm::dvec2> thinned(const std::vector<glm::dvec2>& line, double off) {
    std::vector<bool> stays(line.size(), false);
    stays.front() = stays.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> spans{{0, line.size() - 1}};
    while (!spans.empty()) {
        const auto [from, to] = spans.back();
        spans.pop_back();
        double most = off;
        std::size_t farthest = 0;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double away = distanceToLine(line[i], line[from], line[to]);
            if (away <= most) continue;
            most = away;
            farthest = i;
        }
        if (farthest == 0) continue;
        stays[farthest] = true;
        spans.emplace_back(from, farthest);
        spans.emplace_back(farthest, to);
    }
    std::vector<glm::dvec2> kept;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (stays[i]) kept.push_back(line[i]);
    }
    return kept;
}

PictureRays raysOf(const Camera& camera) {
    const auto rays = PictureRays::of(camera, 1.0);
    MACULA_CHECK(rays.has_value());
    return *rays;
}

}  // namespace

Result<void> validate(const ScissorCut& cut) {
    MACULA_TRY_VOID(basis(cut.camera));
    if (cut.outline.size() < 3) return notUsable(Text("The outline has fewer than three points."));
    if (cut.outline.size() > kMostOutlinePoints) return notUsable(Text("The outline has too many points."));
    if (!std::ranges::all_of(cut.outline, [](const glm::dvec2& p) { return isFinite(p); }))
        return notUsable(Text("A point of the outline is no number."));
    glm::dvec2 low = cut.outline.front();
    glm::dvec2 high = low;
    for (const glm::dvec2& p : cut.outline) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    if (!(high.x - low.x > kLeastExtent) || !(high.y - low.y > kLeastExtent))
        return notUsable(Text("The outline encloses nothing."));
    return {};
}

std::vector<glm::dvec2> simplified(const std::vector<glm::dvec2>& outline, double offHalfHeights) {
    std::vector<glm::dvec2> points;
    for (const glm::dvec2& p : outline) {
        if (isFinite(p) && (points.empty() || p != points.back())) points.push_back(p);
    }
    if (points.size() < 4) return points;
    double off = std::max(offHalfHeights, 1e-9);
    std::vector<glm::dvec2> fewer = thinned(points, off);
    while (fewer.size() > kMostOutlinePoints) {
        off *= 2.0;
        fewer = thinned(points, off);
    }
    if (fewer.size() >= 3) return fewer;
    // The tolerance has grown to the size of a scribble, and left too few points: takes evenly spaced ones.
    const std::size_t count = std::min(points.size(), kMostOutlinePoints);
    fewer.clear();
    for (std::size_t i = 0; i < count; ++i) fewer.push_back(points[i * points.size() / count]);
    return fewer;
}

ScissorBlades::ScissorBlades(const ScissorCut& cut)
    : rays_(raysOf(cut.camera)), removesOutside_(cut.removesOutside) {
    MACULA_CHECK(cut.outline.size() >= 3);
    low_ = high_ = cut.outline.front();
    for (const glm::dvec2& p : cut.outline) {
        low_ = glm::min(low_, p);
        high_ = glm::max(high_, p);
    }
    rows_.resize(kRows);
    const auto rowOf = [&](double y) {
        const double at = (y - low_.y) / (high_.y - low_.y) * double(kRows);
        return std::size_t(std::clamp(at, 0.0, double(kRows - 1)));
    };
    for (std::size_t i = 0; i < cut.outline.size(); ++i) {
        const Edge edge{cut.outline[i], cut.outline[(i + 1) % cut.outline.size()]};
        const auto [lower, upper] = std::minmax(edge.a.y, edge.b.y);
        for (std::size_t row = rowOf(lower); row <= rowOf(upper); ++row) rows_[row].push_back(edge);
    }
}

bool ScissorBlades::isWithin(const glm::dvec2& place) const {
    if (!(place.x >= low_.x && place.x <= high_.x && place.y >= low_.y && place.y <= high_.y)) return false;
    const double at = (place.y - low_.y) / (high_.y - low_.y) * double(kRows);
    int winding = 0;
    for (const Edge& edge : rows_[std::size_t(std::clamp(at, 0.0, double(kRows - 1)))]) {
        const bool isUp = edge.a.y <= place.y && place.y < edge.b.y;
        const bool isDown = edge.b.y <= place.y && place.y < edge.a.y;
        if (!isUp && !isDown) continue;
        const double left =
            (edge.b.x - edge.a.x) * (place.y - edge.a.y) - (place.x - edge.a.x) * (edge.b.y - edge.a.y);
        if (isUp && left > 0.0) ++winding;
        if (isDown && left < 0.0) --winding;
    }
    return winding != 0;
}

bool ScissorBlades::removes(const glm::dvec3& homogeneous) const {
    const bool within =
        homogeneous.z > 0.0 && isWithin(glm::dvec2(homogeneous.x, homogeneous.y) / homogeneous.z);
    return within != removesOutside_;
}

bool ScissorBlades::isClearOf(const glm::dvec3& from, const glm::dvec3& to) const {
    if (!(from.z > 0.0) && !(to.z > 0.0)) return true;
    if (!(from.z > 0.0) || !(to.z > 0.0)) return false;
    const glm::dvec2 a = glm::dvec2(from.x, from.y) / from.z;
    const glm::dvec2 b = glm::dvec2(to.x, to.y) / to.z;
    return glm::any(glm::lessThan(glm::max(a, b), low_)) || glm::any(glm::greaterThan(glm::min(a, b), high_));
}

}  // namespace macula::scene

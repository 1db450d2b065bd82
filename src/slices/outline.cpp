#include "slices/outline.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/is_finite.h"

namespace macula::slices {

namespace {

constexpr double kFarthestMm = 1e12;
constexpr double kOnTheRimMm = 1e-6;

double crossOf(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

bool isUsable(const Outline& outline) {
    return outline.pointsMm.size() >= kFewestOutlinePoints &&
           std::ranges::all_of(outline.pointsMm, [](const glm::dvec3& mm) {
               return isFinite(mm) && std::abs(mm.x) <= kFarthestMm && std::abs(mm.y) <= kFarthestMm &&
                      std::abs(mm.z) <= kFarthestMm;
           });
}

glm::dvec3 middleOf(const Outline& outline) {
    glm::dvec3 low = outline.pointsMm.front();
    glm::dvec3 high = low;
    for (const glm::dvec3& mm : outline.pointsMm) {
        low = glm::min(low, mm);
        high = glm::max(high, mm);
    }
    return 0.5 * (low + high);
}

// Where two sides cross, as parts of the first; nothing if they do not.
std::optional<double> crossingOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                                 const glm::dvec2& d) {
    const double fromA = crossOf(d - c, a - c);
    const double fromB = crossOf(d - c, b - c);
    const double fromC = crossOf(b - a, c - a);
    const double fromD = crossOf(b - a, d - a);
    const bool isCrossing = (fromA < 0.0) != (fromB < 0.0) && (fromC < 0.0) != (fromD < 0.0) &&
                            fromA != 0.0 && fromB != 0.0 && fromC != 0.0 && fromD != 0.0;
    if (!isCrossing) return std::nullopt;
    return fromA / (fromA - fromB);
}

struct Crossing {
    std::size_t first = 0, second = 0;  // sides; side i begins at point i
    glm::dvec2 at{0.0};
};

std::optional<Crossing> firstCrossing(std::span<const glm::dvec2> polygon) {
    const std::size_t count = polygon.size();
    for (std::size_t i = 0; i + 2 < count; ++i) {
        const glm::dvec2& a = polygon[i];
        const glm::dvec2& b = polygon[i + 1];
        const glm::dvec2 low = glm::min(a, b);
        const glm::dvec2 high = glm::max(a, b);
        for (std::size_t j = i + 2; j < count; ++j) {
            const glm::dvec2& c = polygon[j];
            const glm::dvec2& d = polygon[(j + 1) % count];
            if (std::max(c.x, d.x) < low.x || std::min(c.x, d.x) > high.x || std::max(c.y, d.y) < low.y ||
                std::min(c.y, d.y) > high.y)
                continue;
            if (const auto part = crossingOf(a, b, c, d)) return Crossing{i, j, a + *part * (b - a)};
        }
    }
    return std::nullopt;
}

double distanceToSegment(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 along = b - a;
    const double length2 = glm::dot(along, along);
    const double part = length2 > 0.0 ? std::clamp(glm::dot(point - a, along) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(point, a + part * along);
}

}  // namespace

std::optional<FlatOutline> flatOutline(const Outline& outline, const glm::dvec3& normal) {
    const double length = std::hypot(normal.x, normal.y, normal.z);
    if (!isUsable(outline) || !(length > 0.0) || !std::isfinite(length)) return std::nullopt;
    const glm::dvec3 unit = normal / length;
    // The axis that lies least along the normal, made perpendicular to it.
    const glm::dvec3 sizes = glm::abs(unit);
    glm::dvec3 axis(0.0);
    axis[sizes.x <= sizes.y && sizes.x <= sizes.z ? 0 : sizes.y <= sizes.z ? 1 : 2] = 1.0;
    FlatOutline flat;
    flat.plane.centreMm = middleOf(outline);
    flat.plane.right = glm::normalize(axis - glm::dot(axis, unit) * unit);
    flat.plane.down = glm::cross(unit, flat.plane.right);
    flat.points.reserve(outline.pointsMm.size());
    for (const glm::dvec3& mm : outline.pointsMm) {
        const glm::dvec3 from = mm - flat.plane.centreMm;
        flat.points.emplace_back(glm::dot(from, flat.plane.right), glm::dot(from, flat.plane.down));
    }
    return flat;
}

std::optional<FlatOutline> flatOutline(const Outline& outline) {
    if (!isUsable(outline)) return std::nullopt;
    const glm::dvec3 middle = middleOf(outline);
    glm::dvec3 doubleArea(0.0);
    for (std::size_t i = 0; i < outline.pointsMm.size(); ++i)
        doubleArea += glm::cross(outline.pointsMm[i] - middle,
                                 outline.pointsMm[(i + 1) % outline.pointsMm.size()] - middle);
    return flatOutline(outline, doubleArea);
}

double signedArea(std::span<const glm::dvec2> polygon) {
    double doubleArea = 0.0;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        doubleArea += crossOf(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return 0.5 * doubleArea;
}

std::optional<glm::dvec2> centroidOf(std::span<const glm::dvec2> polygon) {
    glm::dvec2 sum(0.0);
    double doubleArea = 0.0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i - 1] - polygon[0];
        const glm::dvec2 b = polygon[i] - polygon[0];
        doubleArea += crossOf(a, b);
        sum += crossOf(a, b) * (a + b);
    }
    if (!(std::abs(doubleArea) > 0.0)) return std::nullopt;
    return polygon[0] + sum / (3.0 * doubleArea);
}

bool crossesItself(std::span<const glm::dvec2> polygon) {
    return firstCrossing(polygon).has_value();
}

std::vector<glm::dvec2> largestLoop(std::span<const glm::dvec2> polygon) {
    std::vector<glm::dvec2> left(polygon.begin(), polygon.end());
    // Each turn leaves out a loop, so it ends; a scribble is bounded.
    constexpr int kMostLoops = 200;
    for (int turn = 0; turn < kMostLoops; ++turn) {
        const auto crossing = firstCrossing(left);
        if (!crossing) break;
        std::vector<glm::dvec2> inner{crossing->at};
        inner.insert(inner.end(), left.begin() + std::ptrdiff_t(crossing->first) + 1,
                     left.begin() + std::ptrdiff_t(crossing->second) + 1);
        std::vector<glm::dvec2> outer(left.begin(), left.begin() + std::ptrdiff_t(crossing->first) + 1);
        outer.push_back(crossing->at);
        outer.insert(outer.end(), left.begin() + std::ptrdiff_t(crossing->second) + 1, left.end());
        left =
            std::abs(signedArea(inner)) > std::abs(signedArea(outer)) ? std::move(inner) : std::move(outer);
    }
    return left;
}

std::vector<glm::dvec3> simplified(std::span<const glm::dvec3> line, double toleranceMm) {
    if (line.size() < 3) return {line.begin(), line.end()};
    std::vector<bool> isKept(line.size(), false);
    isKept.front() = isKept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> left{
        {0, line.size() - 1}};  // not by recursion: long lines
    while (!left.empty()) {
        const auto [from, to] = left.back();
        left.pop_back();
        double farthest = toleranceMm;
        std::size_t at = 0;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double away = distanceToSegment(line[i], line[from], line[to]);
            if (away > farthest) {
                farthest = away;
                at = i;
            }
        }
        if (at == 0) continue;
        isKept[at] = true;
        left.emplace_back(from, at);
        left.emplace_back(at, to);
    }
    std::vector<glm::dvec3> kept;
    for (std::size_t i = 0; i < line.size(); ++i)
        if (isKept[i]) kept.push_back(line[i]);
    return kept;
}

InsideOf::InsideOf(std::span<const glm::dvec2> polygon) {
    if (polygon.empty()) return;
    const auto [low, high] = std::ranges::minmax(polygon, {}, [](const glm::dvec2& p) { return p.y; });
    low_ = low.y - kOnTheRimMm;
    high_ = high.y + kOnTheRimMm;
    bands_.resize(std::clamp<std::size_t>(polygon.size(), 1, 256));
    const double perMm = double(bands_.size()) / (high_ - low_);
    const auto bandOf = [&](double v) {
        return std::size_t(std::clamp((v - low_) * perMm, 0.0, double(bands_.size() - 1)));
    };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Side side{polygon[i], polygon[(i + 1) % polygon.size()]};
        const std::size_t first = bandOf(std::min(side.from.y, side.to.y) - kOnTheRimMm);
        const std::size_t last = bandOf(std::max(side.from.y, side.to.y) + kOnTheRimMm);
        for (std::size_t band = first; band <= last; ++band) bands_[band].push_back(side);
    }
}

const std::vector<InsideOf::Side>& InsideOf::bandAt(double v) const {
    const double part = (v - low_) / (high_ - low_) * double(bands_.size());
    return bands_[std::size_t(std::clamp(part, 0.0, double(bands_.size() - 1)))];
}

bool InsideOf::operator()(const glm::dvec2& at) const {
    if (bands_.empty() || !(at.y >= low_ && at.y <= high_)) return false;
    bool isInside = false;
    for (const Side& side : bandAt(at.y)) {
        if (distanceToSegment({at, 0.0}, {side.from, 0.0}, {side.to, 0.0}) <= kOnTheRimMm) return true;
        if ((side.from.y > at.y) == (side.to.y > at.y)) continue;
        const double part = (at.y - side.from.y) / (side.to.y - side.from.y);
        if (at.x < side.from.x + part * (side.to.x - side.from.x)) isInside = !isInside;
    }
    return isInside;
}

}  // namespace macula::slices

#include "slices/curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/is_finite.h"

namespace macula::slices {

namespace {

constexpr double kSamePointMm = 1e-3;
constexpr double kStepMm = 0.1;
constexpr int kLeastSteps = 16;  // of a piece between two points

using Points = std::array<glm::dvec3, 4>;

// The piece from b to c of the spline through a, b, c, d, by the pyramid of Barry and Goldman. Its knots are
// the square roots of the distances.
class Piece {
  public:
    explicit Piece(const Points& points) : points_(points) {
        for (std::size_t i = 1; i < 4; ++i)
            knots_.at(i) = knots_.at(i - 1) + std::sqrt(glm::distance(points.at(i - 1), points.at(i)));
    }

    // `share` from 0 at b to 1 at c.
    glm::dvec3 at(double share) const {
        const double t = knots_[1] + share * (knots_[2] - knots_[1]);
        const auto blend = [&](const glm::dvec3& p, const glm::dvec3& q, double from, double to) {
            return (p * (to - t) + q * (t - from)) / (to - from);
        };
        const glm::dvec3 ab = blend(points_[0], points_[1], knots_[0], knots_[1]);
        const glm::dvec3 bc = blend(points_[1], points_[2], knots_[1], knots_[2]);
        const glm::dvec3 cd = blend(points_[2], points_[3], knots_[2], knots_[3]);
        return blend(blend(ab, bc, knots_[0], knots_[2]), blend(bc, cd, knots_[1], knots_[3]), knots_[1],
                     knots_[2]);
    }

  private:
    Points points_;
    std::array<double, 4> knots_{};
};

glm::dvec3 anyAcross(const glm::dvec3& along) {
    // The patient's left, unless the curve runs that way.
    const glm::dvec3 left{1.0, 0.0, 0.0};
    const glm::dvec3 posterior{0.0, 1.0, 0.0};
    const glm::dvec3 usual = std::abs(along.x) < 0.9 ? left : posterior;
    return glm::normalize(usual - along * glm::dot(usual, along));
}

glm::dvec3 reflected(const glm::dvec3& v, const glm::dvec3& normal, double normal2) {
    return v - normal * (2.0 * glm::dot(normal, v) / normal2);
}

}  // namespace

Curve::Curve(std::span<const glm::dvec3> pointsMm) {
    std::vector<glm::dvec3> points;
    for (const glm::dvec3& mm : pointsMm)
        if (isFinite(mm) && (points.empty() || glm::distance(points.back(), mm) > kSamePointMm))
            points.push_back(mm);
    if (points.size() < 2) return;
    trace(points);
    turnFrames();
}

// The ends continue by reflection, so that the first and the last piece bend like their neighbours.
void Curve::trace(std::span<const glm::dvec3> points) {
    const std::size_t pieces = points.size() - 1;
    const auto most = std::max<std::size_t>((kMostPlaces - 1) / pieces, 1);
    places_.push_back({.mm = points[0]});
    for (std::size_t i = 0; i < pieces; ++i) {
        const glm::dvec3& b = points[i];
        const glm::dvec3& c = points[i + 1];
        const Piece piece(
            {i > 0 ? points[i - 1] : 2.0 * b - c, b, c, i + 2 < points.size() ? points[i + 2] : 2.0 * c - b});
        const double wanted = std::max<double>(std::ceil(glm::distance(b, c) / kStepMm), kLeastSteps);
        const auto steps = std::size_t(std::min(wanted, double(most)));
        for (std::size_t s = 1; s <= steps; ++s) {
            const glm::dvec3 mm = s == steps ? c : piece.at(double(s) / double(steps));
            const double step = glm::distance(places_.back().mm, mm);
            if (step > 0.0) places_.push_back({.atMm = places_.back().atMm + step, .mm = mm});
        }
    }
}

void Curve::turnFrames() {
    const std::size_t last = places_.size() - 1;
    for (std::size_t i = 0; i <= last; ++i)
        places_[i].along = glm::normalize(places_[std::min(i + 1, last)].mm - places_[i > 0 ? i - 1 : 0].mm);
    places_[0].across = anyAcross(places_[0].along);
    for (std::size_t i = 0; i < last; ++i) {
        const CurvePlace& from = places_[i];
        CurvePlace& to = places_[i + 1];
        const glm::dvec3 chord = to.mm - from.mm;
        const double chord2 = glm::dot(chord, chord);
        const glm::dvec3 across = reflected(from.across, chord, chord2);
        const glm::dvec3 bend = to.along - reflected(from.along, chord, chord2);
        const double bend2 = glm::dot(bend, bend);
        to.across = bend2 > 0.0 ? reflected(across, bend, bend2) : across;
        to.across = glm::normalize(to.across - to.along * glm::dot(to.across, to.along));
    }
}

CurvePlace Curve::at(double mm) const {
    const auto after = std::ranges::upper_bound(places_, mm, {}, &CurvePlace::atMm);
    if (after == places_.begin() || after == places_.end() || std::isnan(mm)) {
        const bool isBefore = after == places_.begin() || std::isnan(mm);
        CurvePlace end = isBefore ? places_.front() : places_.back();
        const double beyond = std::isnan(mm) ? 0.0 : mm - end.atMm;
        end.mm += beyond * end.along;
        end.atMm += beyond;
        return end;
    }
    const CurvePlace& low = *(after - 1);
    const CurvePlace& high = *after;
    const double share = (mm - low.atMm) / (high.atMm - low.atMm);
    CurvePlace place{.atMm = mm, .mm = glm::mix(low.mm, high.mm, share)};
    place.along = glm::normalize(glm::mix(low.along, high.along, share));
    const glm::dvec3 across = glm::mix(low.across, high.across, share);
    place.across = glm::normalize(across - place.along * glm::dot(across, place.along));
    return place;
}

double Curve::nearestMm(const glm::dvec3& mm) const {
    double nearest = 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
        const glm::dvec3 chord = places_[i + 1].mm - places_[i].mm;
        const double share =
            std::clamp(glm::dot(mm - places_[i].mm, chord) / glm::dot(chord, chord), 0.0, 1.0);
        const double away = glm::distance(mm, places_[i].mm + share * chord);
        if (!(away < least)) continue;
        least = away;
        nearest = glm::mix(places_[i].atMm, places_[i + 1].atMm, share);
    }
    return nearest;
}

}  // namespace macula::slices

#include "segment/surface_profile.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace macula::segment {

namespace {

constexpr double kIntoBodyMm = 6.0;  // a sheet's blocks may seem to lie this deep in the body that touches it
constexpr double kStepMm = 5.0;      // most that a sheet rises from column to column
constexpr double kWingMm = 80.0;     // width on each side of a gap to which its bridge is fitted
constexpr double kLeastWingMm = 10.0;
constexpr double kWidestGapMm = 450.0;
constexpr double kLargestErrorMm = 2.0;  // rms of a bridge at its wings
// A body that reaches farther through the bridge does not lie on such a sheet.
constexpr double kThroughMm = 6.0;
constexpr double kMostThrough = 0.1;  // share of the columns in which a body may reach through

}  // namespace

SurfaceProfile::SurfaceProfile(double uMm, double vMm, int side, const std::vector<SurfaceBody>& body,
                               double middle)
    : uMm_(uMm), vMm_(vMm), side_(side), middle_(middle), body_(body), top_(body.size()) {}

bool SurfaceProfile::hasBody(int u) const {
    return body_[std::size_t(u)].low <= body_[std::size_t(u)].high;
}

// The end of the body in a column, times side as top_ is.
double SurfaceProfile::bodyEnd(int u) const {
    return side_ * (side_ > 0 ? body_[std::size_t(u)].high : body_[std::size_t(u)].low);
}

void SurfaceProfile::add(int u, int v) {
    const double distance = side_ * v;
    if (hasBody(u) ? distance < bodyEnd(u) - kIntoBodyMm / vMm_ : distance < side_ * middle_) return;
    std::optional<double>& top = top_[std::size_t(u)];
    top = std::min(top.value_or(distance), distance);
}

double SurfaceProfile::widthMm() const {
    return uMm_ * double(std::count_if(top_.begin(), top_.end(), [](const auto& top) { return bool(top); }));
}

std::optional<int> SurfaceProfile::top(int u) const {
    const std::optional<double>& top = top_[std::size_t(u)];
    if (!top) return {};
    return side_ * int(std::ceil(*top - 0.25));
}

std::vector<SurfaceProfile::Run> SurfaceProfile::runs() const {
    std::vector<Run> runs;
    for (int u = 0; u < int(top_.size()); ++u) {
        const auto& top = top_[std::size_t(u)];
        if (!top) continue;
        const bool goesOn = !runs.empty() && runs.back().last == u - 1 &&
                            std::abs(*top - *top_[std::size_t(u) - 1]) * vMm_ <= kStepMm;
        if (goesOn) {
            runs.back().last = u;
        } else {
            runs.push_back({u, u});
        }
    }
    return runs;
}

// Drops a run that lies behind both of its neighbours: where the body hides the upper sheet of a table, only
// the lower sheet may be visible.
void SurfaceProfile::dropWhatLiesBehind() {
    const std::vector<Run> all = runs();
    const std::vector<std::optional<double>> before = top_;
    for (std::size_t n = 1; n + 1 < all.size(); ++n) {
        const auto at = [&](int u) { return *before[std::size_t(u)]; };
        const double step = kStepMm / vMm_;
        if (at(all[n].first) - at(all[n - 1].last) <= step) continue;
        if (at(all[n].last) - at(all[n + 1].first) <= step) continue;
        for (int u = all[n].first; u <= all[n].last; ++u) top_[std::size_t(u)].reset();
    }
}

void SurfaceProfile::bridge(const Run& left, const Run& right) {
    const int width = right.first - left.last - 1;
    if (width < 1 || width * uMm_ > kWidestGapMm) return;
    const int wing = std::max(3, int(kWingMm / uMm_));
    std::vector<glm::dvec2> points;
    const double centre = 0.5 * (left.last + right.first);
    const double scale = 0.5 * width + wing;
    const auto take = [&](int first, int last) {
        for (int u = first; u <= last; ++u) points.emplace_back((u - centre) / scale, *top_[std::size_t(u)]);
    };
    const int leftFirst = std::max(left.first, left.last - wing);
    const int rightLast = std::min(right.last, right.first + wing);
    if ((left.last - leftFirst + 1) * uMm_ < kLeastWingMm) return;
    if ((rightLast - right.first + 1) * uMm_ < kLeastWingMm) return;
    take(leftFirst, left.last);
    take(right.first, rightLast);

    // Fits a parabola by least squares.
    glm::dmat3 normal(0.0);
    glm::dvec3 moment(0.0);
    for (const glm::dvec2& point : points) {
        const glm::dvec3 basis(1.0, point.x, point.x * point.x);
        normal += glm::outerProduct(basis, basis);
        moment += basis * point.y;
    }
    if (std::abs(glm::determinant(normal)) < 1e-9) return;
    const glm::dvec3 parabola = glm::inverse(normal) * moment;
    const auto at = [&](double x) { return parabola.x + x * (parabola.y + x * parabola.z); };
    double error = 0.0;
    for (const glm::dvec2& point : points) error += (at(point.x) - point.y) * (at(point.x) - point.y);
    if (std::sqrt(error / double(points.size())) * vMm_ > kLargestErrorMm) return;

    int through = 0;
    bool touches = false;
    for (int u = left.last + 1; u < right.first; ++u) {
        if (!hasBody(u)) continue;
        const double depthMm = (bodyEnd(u) - at((u - centre) / scale)) * vMm_;
        through += depthMm > kThroughMm ? 1 : 0;
        touches = touches || depthMm > -1.5 * vMm_;
    }
    if (through > kMostThrough * width) return;
    for (int u = left.last + 1; u < right.first; ++u) top_[std::size_t(u)] = at((u - centre) / scale);
    touchesBody_ = touchesBody_ || touches;
}

void SurfaceProfile::bridgeGaps() {
    dropWhatLiesBehind();
    const std::vector<Run> all = runs();
    for (std::size_t n = 1; n < all.size(); ++n) bridge(all[n - 1], all[n]);
    for (int u = 0; u < int(top_.size()); ++u) {
        auto& top = top_[std::size_t(u)];
        if (top && hasBody(u) && (bodyEnd(u) - *top) * vMm_ > kThroughMm) top.reset();
    }
}

}  // namespace macula::segment

#include "slices/curved_slice.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "slices/voxel_grid.h"

namespace macula::slices {

namespace {

constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();
constexpr int kMostSlabSteps = 512;  // to each side

// A direction perpendicular to `axis`, turned about it.
glm::dvec3 turned(const glm::dvec3& across, const glm::dvec3& beside, double deg) {
    const double angle = glm::radians(std::isfinite(deg) ? deg : 0.0);
    return across * std::cos(angle) + beside * std::sin(angle);
}

// Projects values onto one. Skips those that are missing.
class Projected {
  public:
    explicit Projected(Projection projection) : projection_(projection) {}

    void add(double value, double weight) {
        if (std::isnan(value)) return;
        sum_ += weight * value;
        weight_ += weight;
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
    }
    float value() const {
        if (!(weight_ > 0.0)) return kNoValue;
        if (projection_ == Projection::maximum) return float(high_);
        return float(projection_ == Projection::minimum ? low_ : sum_ / weight_);
    }

  private:
    Projection projection_;
    double sum_ = 0.0;
    double weight_ = 0.0;
    double low_ = std::numeric_limits<double>::infinity();
    double high_ = -std::numeric_limits<double>::infinity();
};

template <class Voxels>
class CurvedSampler {
  public:
    CurvedSampler(const Volume& volume, const CurvedFrame& frame, const Slab& slab)
        : grid_(volume), places_(volume), bounds_(boundsOf(volume.size())), frame_(frame), slab_(slab) {
        if (!(slab.thicknessMm > 0.0)) return;
        const glm::dvec3 spacingMm = volume.spacingMm();
        const double wanted = std::ceil(slab.thicknessMm / std::min({spacingMm.x, spacingMm.y, spacingMm.z}));
        sideSteps_ = int(std::clamp(wanted, 1.0, double(kMostSlabSteps)));
    }

    void fill(int x, SampledSlice& slice) const {
        const CurvedFrame::Column column = frame_.column(x + 0.5);
        const glm::dvec3 middle = places_.ofPoint(column.place.mm);
        const glm::dvec3 down = places_.ofVector(column.down * frame_.mmPerPixel());
        const glm::dvec3 depth = places_.ofVector(column.depth);
        for (int y = 0; y < slice.sizePx.y; ++y) {
            const glm::dvec3 at = middle + down * (y + 0.5 - column.curvePx);
            slice.values[std::size_t(y) * std::size_t(slice.sizePx.x) + std::size_t(x)] = through(at, depth);
        }
    }

  private:
    double valueAt(const glm::dvec3& at) const {
        return bounds_.contain(at) ? grid_.linear(at) : std::numeric_limits<double>::quiet_NaN();
    }

    // By the trapezoidal rule: the two outermost steps have half the weight.
    float through(const glm::dvec3& at, const glm::dvec3& depth) const {
        if (sideSteps_ == 0) return float(valueAt(at));
        Projected projected(slab_.projection);
        const double stepMm = 0.5 * slab_.thicknessMm / sideSteps_;
        for (int step = -sideSteps_; step <= sideSteps_; ++step)
            projected.add(valueAt(at + depth * (step * stepMm)), std::abs(step) == sideSteps_ ? 0.5 : 1.0);
        return projected.value();
    }

    VoxelGrid<Voxels> grid_;
    VoxelPlaces places_;
    Bounds bounds_;
    const CurvedFrame& frame_;
    Slab slab_;
    int sideSteps_ = 0;
};

template <class Voxels>
SampledSlice sampled(const Volume& volume, const CurvedFrame& frame, const Slab& slab,
                     const std::function<bool()>& cancelled) {
    SampledSlice slice{.sizePx = frame.sizePx(), .values = {}};
    slice.values.assign(std::size_t(slice.sizePx.x) * std::size_t(slice.sizePx.y), kNoValue);
    const CurvedSampler<Voxels> sampler(volume, frame, slab);
    std::atomic<bool> isCancelled{false};
    parallelFor(std::size_t(slice.sizePx.x), [&](std::size_t x) {
        if (isCancelled || (cancelled && cancelled())) {
            isCancelled = true;
            return;
        }
        sampler.fill(int(x), slice);
    });
    return isCancelled ? SampledSlice{} : slice;
}

}  // namespace

CurvedFrame::CurvedFrame(Curve curve, CurvedKind kind, double turnDeg, double heightMm, double mmPerPixel)
    : curve_(std::move(curve)), kind_(kind), turnDeg_(turnDeg), mmPerPixel_(mmPerPixel) {
    double widthMm = curve_.lengthMm();
    double neededMm = heightMm;
    if (kind_ == CurvedKind::stretched) {
        unroll();
        widthMm = acrossMm_.back();
        const auto [low, high] = std::ranges::minmax(heightMm_);
        neededMm += high - low;
    }
    mmPerPixel_ = std::max({mmPerPixel_, widthMm / kMostPixels, neededMm / kMostPixels});
    const auto pixels = [&](double mm) {
        return int(std::clamp(std::ceil(mm / mmPerPixel_ - 1e-9), 1.0, double(kMostPixels)));
    };
    sizePx_ = {pixels(widthMm), pixels(neededMm)};
}

// The line that sweeps is perpendicular to the way from the beginning to the end of the curve.
void CurvedFrame::unroll() {
    const auto places = curve_.places();
    const glm::dvec3 whole = places.back().mm - places.front().mm;
    const CurvePlace& first = places.front();
    const glm::dvec3 axis = glm::length(whole) > 1e-6 ? glm::normalize(whole) : first.along;
    glm::dvec3 across = first.across - axis * glm::dot(first.across, axis);
    if (!(glm::length(across) > 1e-6)) across = first.beside() - axis * glm::dot(first.beside(), axis);
    across = glm::normalize(across);
    sweep_ = turned(across, glm::cross(axis, across), turnDeg_);
    double travelled = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i > 0) {
            const glm::dvec3 step = places[i].mm - places[i - 1].mm;
            travelled += glm::length(step - sweep_ * glm::dot(step, sweep_));
        }
        acrossMm_.push_back(travelled);
        heightMm_.push_back(glm::dot(places[i].mm - first.mm, sweep_));
    }
    const auto [low, high] = std::ranges::minmax(heightMm_);
    const double middle = 0.5 * (low + high);
    for (double& mm : heightMm_) mm -= middle;
}

CurvedFrame::Column CurvedFrame::column(double xPx) const {
    const double xMm = xPx * mmPerPixel_;
    Column column;
    if (kind_ == CurvedKind::straightened) {
        column.place = curve_.at(xMm);
        column.curvePx = 0.5 * sizePx_.y;
        column.down = turned(column.place.across, column.place.beside(), turnDeg_);
        column.depth = glm::cross(column.place.along, column.down);
        return column;
    }
    const auto places = curve_.places();
    const auto after = std::ranges::upper_bound(acrossMm_, xMm);
    const auto high = std::clamp<std::size_t>(std::size_t(after - acrossMm_.begin()), 1, places.size() - 1);
    const double lengthMm = acrossMm_[high] - acrossMm_[high - 1];
    const double share = lengthMm > 0.0 ? std::clamp((xMm - acrossMm_[high - 1]) / lengthMm, 0.0, 1.0) : 0.0;
    column.place = curve_.at(glm::mix(places[high - 1].atMm, places[high].atMm, share));
    column.curvePx = 0.5 * sizePx_.y + glm::mix(heightMm_[high - 1], heightMm_[high], share) / mmPerPixel_;
    column.down = sweep_;
    const glm::dvec3 depth = glm::cross(column.place.along, sweep_);
    column.depth = glm::length(depth) > 1e-9 ? glm::normalize(depth) : column.place.across;
    return column;
}

glm::dvec3 CurvedFrame::worldFromPicture(const glm::dvec2& px) const {
    const Column at = column(px.x);
    return at.place.mm + at.down * ((px.y - at.curvePx) * mmPerPixel_);
}

glm::dvec2 CurvedFrame::pictureFromCurve(double atMm) const {
    if (kind_ == CurvedKind::straightened) return {atMm / mmPerPixel_, 0.5 * sizePx_.y};
    const auto places = curve_.places();
    const auto after = std::ranges::upper_bound(places, atMm, {}, &CurvePlace::atMm);
    const auto high = std::clamp<std::size_t>(std::size_t(after - places.begin()), 1, places.size() - 1);
    const double lengthMm = places[high].atMm - places[high - 1].atMm;
    const double share = std::clamp((atMm - places[high - 1].atMm) / lengthMm, 0.0, 1.0);
    return {glm::mix(acrossMm_[high - 1], acrossMm_[high], share) / mmPerPixel_,
            0.5 * sizePx_.y + glm::mix(heightMm_[high - 1], heightMm_[high], share) / mmPerPixel_};
}

SampledSlice sampleCurved(const Volume& volume, const CurvedFrame& frame, const Slab& slab,
                          const std::function<bool()>& cancelled) {
    return volume.format() == VoxelFormat::float32 ? sampled<FloatVoxels>(volume, frame, slab, cancelled)
                                                   : sampled<StoredVoxels>(volume, frame, slab, cancelled);
}

}  // namespace macula::slices

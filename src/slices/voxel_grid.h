// Values at and between the voxels of a volume, read directly from its memory. Templates over the format of
// voxels, because a picture takes millions of values and a call of Volume::value for each would cost too
// much.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>

#include "base/volume.h"

namespace macula::slices {

// Voxel coordinates that differ by less count as the same: coordinates are rounded, and a picture through the
// centres of voxels must show exactly their values.
inline constexpr double kSamePlace = 1e-6;

// The voxel whose centre is nearest. `at` is at most half a voxel + kSamePlace outside the outer centres.
inline glm::ivec3 nearestVoxel(const glm::dvec3& at, const glm::ivec3& size) {
    return glm::min(glm::ivec3(at + 0.5), size - 1);
}

// VoxelFormat::stored16.
class StoredVoxels {
  public:
    using Voxel = std::uint16_t;

    explicit StoredVoxels(const Volume& volume)
        : voxels_(volume.voxels().data()), units_(volume.unitsFromStored()) {
        if (!volume.padding() || volume.padding()->low > volume.padding()->high) return;
        paddingLow_ = volume.padding()->low;
        paddingSpan_ = static_cast<unsigned>(volume.padding()->high - volume.padding()->low);
    }

    const Voxel* data() const { return voxels_; }
    // One comparison, because lower values wrap around.
    bool isPadding(Voxel voxel) const { return static_cast<unsigned>(voxel - paddingLow_) <= paddingSpan_; }
    double inUnits(double stored) const { return units_(stored); }

  private:
    const Voxel* voxels_;
    UnitsFromStored units_;
    int paddingLow_ = 65536;  // above every voxel: no padding
    unsigned paddingSpan_ = 0;
};

// VoxelFormat::float32.
class FloatVoxels {
  public:
    using Voxel = float;

    explicit FloatVoxels(const Volume& volume)
        : voxels_(volume.floatVoxels().data()),
          padding_(volume.floatPadding().value_or(std::numeric_limits<float>::quiet_NaN())) {}

    const Voxel* data() const { return voxels_; }
    bool isPadding(Voxel voxel) const { return std::isnan(voxel) || voxel == padding_; }
    double inUnits(double value) const { return value; }

  private:
    const Voxel* voxels_;
    float padding_;
};

// Places are voxel coordinates, at most half a voxel + kSamePlace outside the outer voxel centres; beyond
// these centres the value stays constant. NaN means no value: padding.
template <class Voxels>
class VoxelGrid {
  public:
    explicit VoxelGrid(const Volume& volume) : voxels_(volume), size_(volume.size()) {}

    const glm::ivec3& size() const { return size_; }

    double nearest(const glm::dvec3& at) const {
        const Voxel voxel = *place(nearestVoxel(at, size_));
        return voxels_.isPadding(voxel) ? kNoValue : voxels_.inUnits(voxel);
    }

    // Also accepts places farther outside.
    double linear(const glm::dvec3& at) const {
        const glm::dvec3 inside = glm::clamp(at, glm::dvec3(0.0), glm::dvec3(size_ - 1));
        const glm::ivec3 low = glm::min(glm::ivec3(inside), glm::max(size_ - 2, glm::ivec3(0)));
        const glm::ivec3 high = glm::min(low + 1, size_ - 1);
        const std::ptrdiff_t i = high.x - low.x;
        const std::ptrdiff_t j = rows(high.y - low.y);
        const std::ptrdiff_t k = slices(high.z - low.z);
        return between(place(low), i, j, k, inside - glm::dvec3(low));
    }

    // The same, for coordinates of at least 0 and below those of the last voxel's centre.
    double linearInside(const glm::dvec3& at) const {
        const glm::ivec3 low(at);
        return between(place(low), 1, rows(1), slices(1), at - glm::dvec3(low));
    }

  private:
    using Voxel = typename Voxels::Voxel;
    using Corners = std::array<Voxel, 8>;  // bit n of the index is set at the high end of axis n

    static constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

    std::ptrdiff_t rows(int count) const { return std::ptrdiff_t(size_.x) * count; }
    std::ptrdiff_t slices(int count) const { return rows(size_.y) * count; }
    const Voxel* place(const glm::ivec3& voxel) const {
        return voxels_.data() + slices(voxel.z) + rows(voxel.y) + voxel.x;
    }

    static double settled(double share) {
        if (share < kSamePlace) return 0.0;
        return share > 1.0 - kSamePlace ? 1.0 : share;
    }

    // Trilinear between the eight voxels at `first` and at offsets i, j and k from it.
    double between(const Voxel* first, std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t k,
                   const glm::dvec3& share) const {
        const Voxel* behind = first + k;
        const Corners c{first[0],  first[i],  first[j],  first[j + i],
                        behind[0], behind[i], behind[j], behind[j + i]};
        const glm::dvec3 high(settled(share.x), settled(share.y), settled(share.z));
        const auto is = [&](Voxel voxel) { return voxels_.isPadding(voxel) ? 1 : 0; };
        if (is(c[0]) + is(c[1]) + is(c[2]) + is(c[3]) + is(c[4]) + is(c[5]) + is(c[6]) + is(c[7]) != 0)
            return withoutPadding(c, high);
        // Exact at both ends, which a + (b - a) * share is not.
        const glm::dvec3 low = 1.0 - high;
        const double front = (c[0] * low.x + c[1] * high.x) * low.y + (c[2] * low.x + c[3] * high.x) * high.y;
        const double back = (c[4] * low.x + c[5] * high.x) * low.y + (c[6] * low.x + c[7] * high.x) * high.y;
        return voxels_.inUnits(front * low.z + back * high.z);
    }

    double withoutPadding(const Corners& corners, const glm::dvec3& high) const {
        double sum = 0.0;
        double weights = 0.0;
        for (unsigned n = 0; n < corners.size(); ++n) {
            const double weight = (n & 1U ? high.x : 1.0 - high.x) * (n & 2U ? high.y : 1.0 - high.y) *
                                  (n & 4U ? high.z : 1.0 - high.z);
            if (!(weight > 0.0) || voxels_.isPadding(corners[n])) continue;
            sum += weight * corners[n];
            weights += weight;
        }
        return weights > 0.0 ? voxels_.inUnits(sum / weights) : kNoValue;
    }

    Voxels voxels_;
    glm::ivec3 size_;
};

// Voxel coordinates that the volume covers: to half a voxel + kSamePlace beyond the outer centres.
struct Bounds {
    glm::dvec3 low{0.0};
    glm::dvec3 high{0.0};

    bool contain(const glm::dvec3& at) const {
        return glm::all(glm::lessThanEqual(low, at)) && glm::all(glm::lessThanEqual(at, high));
    }
};

inline Bounds boundsOf(const glm::ivec3& size) {
    const double beyond = 0.5 + kSamePlace;
    return {glm::dvec3(-beyond), glm::dvec3(size - 1) + beyond};
}

// Converts patient LPS mm to voxel coordinates. The origin is subtracted before the rotation, so that volumes
// far from the patient's origin lose no digits.
class VoxelPlaces {
  public:
    explicit VoxelPlaces(const Volume& volume)
        : voxelFromMm_(glm::inverse(glm::dmat3(volume.worldFromVoxel()))),
          originMm_(volume.worldFromVoxel()[3]) {}

    glm::dvec3 ofPoint(const glm::dvec3& mm) const { return voxelFromMm_ * (mm - originMm_); }
    glm::dvec3 ofVector(const glm::dvec3& mm) const { return voxelFromMm_ * mm; }

  private:
    glm::dmat3 voxelFromMm_;
    glm::dvec3 originMm_;
};

}  // namespace macula::slices

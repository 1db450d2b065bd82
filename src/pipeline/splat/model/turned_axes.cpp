#include "pipeline/splat/model/turned_axes.h"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include "base/check.h"

namespace macula::splat {

namespace {

constexpr std::size_t kMostCoefficients = shCount(kMaxShDegree);
using Basis = std::array<double, kMostCoefficients>;

// The real spherical harmonics of splats.h, from degree 1 on.
Basis basisAlong(const glm::dvec3& d) {
    const double xx = d.x * d.x;
    const double yy = d.y * d.y;
    const double zz = d.z * d.z;
    const double ring = 4.0 * zz - xx - yy;
    return {-0.48860251190291992 * d.y,
            0.48860251190291992 * d.z,
            -0.48860251190291992 * d.x,
            1.09254843059207907 * d.x * d.y,
            -1.09254843059207907 * d.y * d.z,
            0.31539156525252001 * (2.0 * zz - xx - yy),
            -1.09254843059207907 * d.x * d.z,
            0.54627421529603954 * (xx - yy),
            -0.59004358992664351 * d.y * (3.0 * xx - yy),
            2.89061144264055405 * d.x * d.y * d.z,
            -0.45704579946446573 * d.y * ring,
            0.37317633259011540 * d.z * (2.0 * zz - 3.0 * (xx + yy)),
            -0.45704579946446573 * d.x * ring,
            1.44530572132027702 * d.z * (xx - yy),
            -0.59004358992664351 * d.x * (xx - 3.0 * yy)};
}

using Matrix = std::array<Basis, kMostCoefficients>;

// Each new coefficient is the integral over all directions of its harmonic times the old colours.
// Gauss-Legendre quadrature with four heights and eight longitudes is exact for products of two harmonics of
// degree 3.
Matrix newFromOldCoefficients(const glm::dmat3& newFromOld) {
    constexpr std::array kHeights{-0.86113631159405258, -0.33998104358485626, 0.33998104358485626,
                                  0.86113631159405258};
    constexpr std::array kWeights{0.34785484513745386, 0.65214515486254614, 0.65214515486254614,
                                  0.34785484513745386};
    constexpr int kLongitudes = 8;
    const glm::dmat3 oldFromNew = glm::transpose(newFromOld);
    Matrix matrix{};
    for (std::size_t h = 0; h < kHeights.size(); ++h) {
        const double radius = std::sqrt(1.0 - kHeights[h] * kHeights[h]);
        const double weight = kWeights[h] * 2.0 * glm::pi<double>() / kLongitudes;
        for (int l = 0; l < kLongitudes; ++l) {
            const double longitude = 2.0 * glm::pi<double>() * l / kLongitudes;
            const glm::dvec3 d{radius * std::cos(longitude), radius * std::sin(longitude), kHeights[h]};
            const Basis now = basisAlong(d);
            const Basis before = basisAlong(oldFromNew * d);
            for (std::size_t i = 0; i < now.size(); ++i) {
                for (std::size_t k = 0; k < before.size(); ++k) matrix[i][k] += weight * now[i] * before[k];
            }
        }
    }
    return matrix;
}

}  // namespace

void turnAxes(Splats& splats, const glm::dmat3& newFromOld) {
    const double hand = glm::determinant(newFromOld);
    constexpr double kNearly = 1e-9;
    MACULA_CHECK(std::abs(std::abs(hand) - 1.0) < kNearly);
    for (glm::vec3& p : splats.position) p = glm::vec3(newFromOld * glm::dvec3(p));
    // Mirroring an ellipsoid at its centre does not change it, so a mirror matrix may be negated into a
    // rotation.
    const glm::dquat turn = glm::quat_cast(hand < 0.0 ? -newFromOld : newFromOld);
    for (glm::vec4& rotation : splats.rotation) {
        const glm::dquat turned = turn * glm::dquat(rotation[0], rotation[1], rotation[2], rotation[3]);
        rotation = glm::vec4(turned.w, turned.x, turned.y, turned.z);
    }
    const std::size_t count = shCount(splats.shDegree);
    if (count == 0) return;
    const Matrix matrix = newFromOldCoefficients(newFromOld);
    for (std::size_t first = 0; first < splats.sh.size(); first += count) {
        std::array<glm::dvec3, kMostCoefficients> before{};
        for (std::size_t k = 0; k < count; ++k) before[k] = glm::dvec3(splats.sh[first + k]);
        for (std::size_t i = 0; i < count; ++i) {
            glm::dvec3 now(0.0);
            for (std::size_t k = 0; k < count; ++k) now += matrix[i][k] * before[k];
            splats.sh[first + i] = glm::vec3(now);
        }
    }
}

}  // namespace macula::splat

#include "pipeline/hybrid/model/initial_splats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "pipeline/splat/model/constant_colour.h"

namespace macula::hybrid {

namespace {

// Limits for the radius of a point, in mm, and for its radiance, which is 1 for white.
constexpr double kLeastRadius = 1e-6;
constexpr double kMostRadius = 1e6;
constexpr float kMostRadiance = 1e6f;

// How far the centre of a half-filled ball lies from the middle, in radii.
constexpr double kHalfFilled = 0.375;

// Optical depth through the middle of a splat that stands for its share of matter of extinction 1 / radius:
// radius^3 of it over the area 2 pi s^2 with s = width * radius / sqrt(5).
double depthPerRadius(double width) {
    constexpr double kPi = 3.14159265358979;
    return 5.0 / (2.0 * kPi * width * width);
}

double logit(double opacity) {
    return std::log(opacity / (1.0 - opacity));
}

}  // namespace

PrincipalAxes principalAxes(const glm::dmat3& symmetric) {
    glm::dmat3 a = symmetric;
    glm::dmat3 axes(1.0);
    constexpr int kSweeps = 12;  // ample: convergence is quadratic, and five sweeps suffice for 3 x 3
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        for (const int left : {2, 1, 0}) {
            const int p = left == 0 ? 1 : 0;
            const int q = left == 2 ? 1 : 2;
            if (a[p][q] == 0.0) continue;
            const double theta = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
            const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
            const double c = 1.0 / std::hypot(t, 1.0);
            glm::dmat3 turn(1.0);
            turn[p][p] = turn[q][q] = c;
            turn[q][p] = t * c;
            turn[p][q] = -t * c;
            a = glm::transpose(turn) * a * turn;
            a[p][q] = a[q][p] = 0.0;
            axes = axes * turn;
        }
    }
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int i, int j) { return a[i][i] > a[j][j]; });
    PrincipalAxes result;
    for (int i = 0; i < 3; ++i) {
        result.axes[i] = axes[order[std::size_t(i)]];
        result.variance[i] = std::max(a[order[std::size_t(i)]][order[std::size_t(i)]], 0.0);
    }
    if (glm::determinant(result.axes) < 0.0) result.axes[2] = -result.axes[2];
    return result;
}

splat::Splats initialSplats(const trace::SurfacePoints& points, const InitialSplatOptions& options) {
    splat::Splats splats;
    splats.originMm = points.originMm;
    splats.resize(points.points.size());
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const trace::SurfacePoint& point = points.points[i];
        const double radius = std::clamp(double(point.radiusMm), kLeastRadius, kMostRadius);
        const PrincipalAxes principal = principalAxes(glm::dmat3(point.spreadMm2));
        // The standard deviations of the matter within the radius, which limits them.
        const glm::dvec3 deviation = glm::min(glm::sqrt(principal.variance), glm::dvec3(radius));
        const glm::dvec3 scale = glm::max(options.width * deviation, glm::dvec3(options.thinnest * radius));
        const glm::dquat turn = glm::normalize(glm::quat_cast(principal.axes));
        // The extinction of the matter itself: the mean over the ball includes the air around it.
        const glm::dvec3 centre(point.centreMm);
        const double offset = std::min(glm::length(centre) / (kHalfFilled * radius), 1.0);
        const double extinction = double(point.extinctionPerMm) * (1.0 + offset);
        const double depth = options.denser * depthPerRadius(options.width) * radius * extinction;
        const double opacity = std::clamp(-std::expm1(-depth), 0.005, 0.995);
        const double inwards =
            options.inwards * std::min(1.0, radius / std::max(glm::length(centre), radius));
        splats.position[i] = glm::vec3(glm::dvec3(point.positionMm) + inwards * centre);
        splats.logScale[i] = glm::vec3(glm::log(scale));
        splats.rotation[i] = glm::vec4(turn.w, turn.x, turn.y, turn.z);
        splats.opacityLogit[i] = static_cast<float>(logit(opacity));
        const glm::vec3 radiance = glm::clamp(point.radiance, 0.0f, kMostRadiance);
        splats.dc[i] = splat::dcOfColour(radiance);
    }
    return splats;
}

}  // namespace macula::hybrid

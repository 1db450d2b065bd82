// The first splats, of points that are known.
#include "pipeline/hybrid/model/initial_splats.h"

#include <gtest/gtest.h>

#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <random>

namespace macula::hybrid {
namespace {

glm::dmat3 turned(const glm::dvec3& variance, const glm::dquat& by) {
    const glm::dmat3 r = glm::mat3_cast(glm::normalize(by));
    return r * glm::dmat3(variance.x, 0, 0, 0, variance.y, 0, 0, 0, variance.z) * glm::transpose(r);
}

void expectAxesOf(const glm::dmat3& matrix, const glm::dvec3& variance, double tolerance) {
    const PrincipalAxes found = principalAxes(matrix);
    const double size = std::max(variance.x, 1e-300);
    glm::dmat3 again(0.0);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(found.variance[i], variance[i], tolerance * size);
        again += found.variance[i] * glm::outerProduct(found.axes[i], found.axes[i]);
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(glm::dot(found.axes[i], found.axes[j]), i == j ? 1.0 : 0.0, 1e-12);
    }
    EXPECT_NEAR(glm::determinant(found.axes), 1.0, 1e-12);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) EXPECT_NEAR(again[i][j], matrix[i][j], tolerance * size);
}

TEST(PrincipalAxes, OfKnownMatrices) {
    std::mt19937 engine(5);
    std::normal_distribution<double> normal;
    const std::vector<glm::dvec3> variances{
        {9, 4, 1}, {4, 4, 1},       {4, 1, 1},        {2, 2, 2},         {1, 0, 0},         {1, 1, 0},
        {0, 0, 0}, {1, 1e-8, 1e-8}, {1e8, 1.0, 1e-8}, {1, 1, 1 - 1e-13}, {1e-30, 1e-31, 0}, {1e30, 1e29, 1}};
    for (const glm::dvec3& variance : variances) {
        expectAxesOf(turned(variance, {1, 0, 0, 0}), variance, 1e-14);
        for (int i = 0; i < 20; ++i) {
            const glm::dquat by(normal(engine), normal(engine), normal(engine), normal(engine));
            expectAxesOf(turned(variance, by), variance, 1e-13);
        }
    }
    // Rounding may make a thin one negative by a hair.
    EXPECT_EQ(principalAxes(glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, -1e-17)).variance.z, 0.0);
}

trace::SurfacePoint onAWall() {
    // Half of a ball of 2 mm, behind the plane z = 0: its middle is 3/8 r deep, and its spread r^2 / 5 along
    // the wall and r^2 (1/5 - 9/64) across.
    trace::SurfacePoint point{.positionMm = {10, 20, 30}, .radiance = {0.2f, 0.5f, 0.8f}};
    point.radiusMm = 2.0f;
    point.extinctionPerMm = 0.5f;
    point.centreMm = {0, 0, -0.75f};
    point.spreadMm2 = glm::mat3(0.8f, 0, 0, 0, 0.8f, 0, 0, 0, 0.2375f);
    return point;
}

TEST(InitialSplats, OfAPointOnAWall) {
    trace::SurfacePoints points{.originMm = {1e5, -3, 7}, .areaMm2 = 4.0, .points = {onAWall()}};
    const InitialSplatOptions options{.width = 1.5, .inwards = 0.5, .denser = 1.0, .thinnest = 0.1};
    const splat::Splats splats = initialSplats(points, options);
    ASSERT_TRUE(splats.validate().ok());
    ASSERT_EQ(splats.size(), 1u);
    EXPECT_EQ(splats.originMm, points.originMm);
    EXPECT_EQ(splats.colourSpace, splat::ColourSpace::linear);
    EXPECT_EQ(splats.shDegree, 0);
    EXPECT_LT(glm::distance(splats.position[0], glm::vec3(10, 20, 29.625f)), 1e-5f);
    EXPECT_NEAR(std::exp(splats.logScale[0].x), 1.5 * std::sqrt(0.8), 1e-5);
    EXPECT_NEAR(std::exp(splats.logScale[0].z), 1.5 * std::sqrt(0.2375), 1e-5);
    const glm::vec4 q = splats.rotation[0];
    const glm::vec3 thin = glm::mat3_cast(glm::quat(q[0], q[1], q[2], q[3]))[2];
    EXPECT_NEAR(std::abs(thin.z), 1.0, 1e-6);
    // Extinction of the matter itself is 1 per mm: 8 mm^3 of it over 2 pi (1.5 * 2)^2 / 5.
    const double depth = 8.0 * 5.0 / (2.0 * 3.14159265358979 * 9.0);
    EXPECT_NEAR(1.0 / (1.0 + std::exp(-double(splats.opacityLogit[0]))), 1.0 - std::exp(-depth), 1e-5);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(0.5f + 0.28209479f * splats.dc[0][c], points.points[0].radiance[c], 1e-6f);
}

TEST(InitialSplats, LeftStaysLeft) {
    trace::SurfacePoints points;
    points.points = {onAWall(), onAWall()};
    points.points[1].positionMm.x = -10.0f;
    const splat::Splats splats = initialSplats(points);
    EXPECT_GT(splats.position[0].x, 9.0f);
    EXPECT_LT(splats.position[1].x, -9.0f);
    EXPECT_EQ(initialSplats({}).size(), 0u);
}

// Whatever finite numbers come, the model is valid and can be drawn.
TEST(InitialSplats, AreValidForAnyFinitePoint) {
    constexpr float kMost = std::numeric_limits<float>::max();
    const std::vector<float> values{0.0f, -0.0f, 1.0f, -1.0f, 1e-38f, 1e-44f, 1e5f, -1e20f, kMost, -kMost};
    std::mt19937 engine(7);
    const auto any = [&] { return values[engine() % values.size()]; };
    trace::SurfacePoints points;
    for (int i = 0; i < 4000; ++i) {
        trace::SurfacePoint point = onAWall();
        point.radiusMm = any();
        point.extinctionPerMm = any();
        point.radiance = {any(), any(), any()};
        point.centreMm = {any(), any(), any()};
        glm::mat3& s = point.spreadMm2;
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r <= c; ++r) s[c][r] = s[r][c] = any();
        points.points.push_back(point);
    }
    const splat::Splats splats = initialSplats(points);
    ASSERT_TRUE(splats.validate().ok());
    for (std::size_t i = 0; i < splats.size(); ++i) {
        EXPECT_LE(std::abs(splats.opacityLogit[i]), 5.3f);  // 0.005 to 0.995
        for (int c = 0; c < 3; ++c) {
            EXPECT_LE(std::abs(splats.logScale[i][c]), splat::kMaxLogScale);
            EXPECT_GE(0.5f + 0.28209479f * splats.dc[i][c], -1e-6f);  // no light is negative
        }
    }
}

}  // namespace
}  // namespace macula::hybrid

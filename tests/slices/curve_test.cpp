// Curves against closed forms: a helix, a line, a circle.
#include "slices/curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace macula::slices::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kTau = 2.0 * std::numbers::pi;

struct Helix {
    double radiusMm = 12.0;
    double riseMm = 30.0;  // in a turn
    glm::dvec3 originMm{40.0, -70.0, 900.0};

    glm::dvec3 at(double turns) const {
        const double angle = kTau * turns;
        return originMm + glm::dvec3(radiusMm * std::cos(angle), radiusMm * std::sin(angle), riseMm * turns);
    }
    double lengthMm(double turns) const { return turns * std::hypot(kTau * radiusMm, riseMm); }
    std::vector<glm::dvec3> points(double turns, int inTurn) const {
        std::vector<glm::dvec3> points;
        const int count = int(std::lround(turns * inTurn));
        for (int i = 0; i <= count; ++i) points.push_back(at(double(i) / inTurn));
        return points;
    }
};

// As many points as somebody would set by hand: twelve in a turn.
TEST(Curve, ThroughAHelixHasItsLength) {
    for (const double rise : {5.0, 30.0, 120.0}) {
        const Helix helix{.riseMm = rise};
        const Curve curve(helix.points(2.5, 12));
        ASSERT_TRUE(curve.isUsable());
        EXPECT_NEAR(curve.lengthMm() / helix.lengthMm(2.5), 1.0, 0.005) << rise;
        const Curve fine(helix.points(2.5, 48));
        EXPECT_NEAR(fine.lengthMm() / helix.lengthMm(2.5), 1.0, 0.0005) << rise;
    }
}

TEST(Curve, MeetsItsPointsAndContinuesStraight) {
    const std::vector<glm::dvec3> points = Helix{}.points(1.5, 8);
    const Curve curve(points);
    for (const glm::dvec3& mm : points) EXPECT_LT(glm::distance(curve.at(curve.nearestMm(mm)).mm, mm), 1e-6);
    const CurvePlace end = curve.at(curve.lengthMm());
    const CurvePlace beyond = curve.at(curve.lengthMm() + 7.0);
    EXPECT_LT(glm::distance(beyond.mm, end.mm + 7.0 * end.along), 1e-9);
    EXPECT_LT(glm::distance(curve.at(-3.0).mm, points[0] - 3.0 * curve.at(0.0).along), 1e-9);
    EXPECT_EQ(curve.at(kNan).mm, points[0]);
    EXPECT_EQ(curve.nearestMm({kNan, 0.0, 0.0}), 0.0);
}

TEST(Curve, ThroughTwoPointsIsALine) {
    const Curve line(std::vector{glm::dvec3(1.0, 2.0, 3.0), glm::dvec3(1.0, 2.0, 103.0)});
    EXPECT_NEAR(line.lengthMm(), 100.0, 1e-9);
    const CurvePlace place = line.at(25.0);
    EXPECT_LT(glm::distance(place.mm, glm::dvec3(1.0, 2.0, 28.0)), 1e-9);
    EXPECT_LT(glm::distance(place.across, glm::dvec3(1.0, 0.0, 0.0)), 1e-12) << "the patient's left";
}

TEST(Curve, HasPerpendicularDirectionsEverywhere) {
    const Curve curve(Helix{.riseMm = 3.0}.points(3.0, 16));
    for (const CurvePlace& place : curve.places()) {
        EXPECT_NEAR(glm::length(place.along), 1.0, 1e-12);
        EXPECT_NEAR(glm::length(place.across), 1.0, 1e-12);
        EXPECT_NEAR(glm::dot(place.along, place.across), 0.0, 1e-12);
        ASSERT_LT(glm::distance(place.section().normal(), place.along), 1e-12);
    }
}

// A frame that minimises rotation turns by the solid angle that its tangent encloses: on a helix by
// tau (1 - sin(pitch)) in a turn (Fuller 1978), where sin(pitch) = rise / length.
TEST(Curve, TurnsNoMoreThanItMust) {
    const Helix helix{.radiusMm = 10.0, .riseMm = 40.0};
    const Curve curve(helix.points(1.0, 64));
    const double slope = helix.riseMm / helix.lengthMm(1.0);
    // Away from both ends, where the spline's tangent is not the helix's.
    const Curve longer(helix.points(3.0, 64));
    const CurvePlace from = longer.at(helix.lengthMm(1.0));
    const CurvePlace to = longer.at(helix.lengthMm(2.0));
    ASSERT_LT(glm::distance(from.along, to.along), 1e-4);
    const double turned = std::atan2(glm::dot(glm::cross(from.across, to.across), from.along),
                                     glm::dot(from.across, to.across));
    const double wanted = std::remainder(kTau * (1.0 - slope), kTau);
    EXPECT_NEAR(std::abs(turned), std::abs(wanted), 0.01);
}

TEST(Curve, ExtremePointsAreLeftOutOrHeld) {
    EXPECT_FALSE(Curve({}).isUsable());
    EXPECT_FALSE(Curve(std::vector{glm::dvec3(1.0)}).isUsable());
    EXPECT_FALSE(Curve(std::vector(5, glm::dvec3(1.0))).isUsable());
    EXPECT_FALSE(Curve(std::vector{glm::dvec3(0.0), glm::dvec3(kNan), glm::dvec3(kInfinity)}).isUsable());
    const Curve sparse(std::vector{glm::dvec3(0.0), glm::dvec3(kNan), glm::dvec3(0.0, 0.0, 10.0)});
    EXPECT_NEAR(sparse.lengthMm(), 10.0, 1e-9);
    // Back along its own way.
    const Curve back(std::vector{glm::dvec3(0.0), glm::dvec3(10.0, 0.0, 0.0), glm::dvec3(0.0)});
    ASSERT_TRUE(back.isUsable());
    EXPECT_GE(back.lengthMm(), 20.0 - 1e-9);
    for (const CurvePlace& place : back.places()) EXPECT_NEAR(glm::length(place.along), 1.0, 1e-9);
    // As long as it gets: the number of places is bounded.
    std::vector<glm::dvec3> far;
    for (int i = 0; i < 1000; ++i) far.emplace_back(i % 2 == 0 ? -1e6 : 1e6, 1000.0 * i, 0.0);
    const Curve vast(far);
    EXPECT_LE(vast.places().size(), Curve::kMostPlaces);
    EXPECT_TRUE(std::isfinite(vast.lengthMm()));
}

}  // namespace
}  // namespace macula::slices::test

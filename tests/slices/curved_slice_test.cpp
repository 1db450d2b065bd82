// Curved planes against closed forms: a linear field, and small balls at known places along a helix.
#include "slices/curved_slice.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "made_volumes.h"

namespace macula::slices::test {
namespace {

constexpr double kTau = 2.0 * std::numbers::pi;
constexpr double kSideMm = 0.8;
const glm::ivec3 kSize{90, 80, 70};

glm::dmat4 straight() {
    glm::dmat4 world(kSideMm);
    world[3] = glm::dvec4(-36.0, -32.0, -28.0, 1.0);
    return world;
}

template <class Value>
Volume volumeBy(const Value& valueAtMm) {
    std::vector<float> values;
    const glm::dmat4 world = straight();
    for (int k = 0; k < kSize.z; ++k)
        for (int j = 0; j < kSize.y; ++j)
            for (int i = 0; i < kSize.x; ++i)
                values.push_back(float(valueAtMm(glm::dvec3(world * glm::dvec4(i, j, k, 1.0)))));
    return volumeOf(kSize, world, std::move(values));
}

glm::dvec3 onHelix(double turns) {
    return {15.0 * std::cos(kTau * turns), 15.0 * std::sin(kTau * turns), 30.0 * (turns - 0.5)};
}

Curve helix() {
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= 24; ++i) points.push_back(onHelix(i / 24.0));
    return Curve(points);
}

// A ball with a smooth edge, so that its centre of mass in a plane through its middle is its middle.
Volume ball(const glm::dvec3& middleMm) {
    return volumeBy([&](const glm::dvec3& mm) {
        const double away = glm::distance(mm, middleMm) / 1.6;
        return 1000.0 * std::exp(-away * away);
    });
}

glm::dvec2 centreOfMass(const SampledSlice& slice) {
    glm::dvec2 sum(0.0);
    double mass = 0.0;
    for (int y = 0; y < slice.sizePx.y; ++y) {
        for (int x = 0; x < slice.sizePx.x; ++x) {
            const double value = slice.values[std::size_t(y) * std::size_t(slice.sizePx.x) + std::size_t(x)];
            if (std::isnan(value)) continue;
            sum += value * glm::dvec2(x + 0.5, y + 0.5);
            mass += value;
        }
    }
    return sum / mass;
}

// Interpolation between voxels is exact for a linear field, so each pixel has the value at its place.
TEST(CurvedSlice, HasTheValueOfThePlaceThatItNames) {
    const glm::dvec3 slope(3.0, -2.0, 0.5);
    const Volume volume = volumeBy([&](const glm::dvec3& mm) { return 7.0 + glm::dot(slope, mm); });
    for (const CurvedKind kind : {CurvedKind::straightened, CurvedKind::stretched}) {
        for (const double turn : {0.0, 35.0, 90.0, 270.0}) {
            const CurvedFrame frame(helix(), kind, turn, 20.0, 0.5);
            const SampledSlice slice = sampleCurved(volume, frame, {});
            ASSERT_EQ(slice.sizePx, frame.sizePx());
            double worst = 0.0;
            int values = 0;
            for (int y = 0; y < slice.sizePx.y; y += 3) {
                for (int x = 0; x < slice.sizePx.x; x += 5) {
                    const float value =
                        slice.values[std::size_t(y) * std::size_t(slice.sizePx.x) + std::size_t(x)];
                    if (std::isnan(value)) continue;
                    const glm::dvec3 mm = frame.worldFromPicture({x + 0.5, y + 0.5});
                    // Values stay constant in the outer half of a voxel.
                    const glm::dvec3 voxel = (mm - glm::dvec3(straight()[3])) / kSideMm;
                    if (glm::any(glm::lessThan(voxel, glm::dvec3(0.0))) ||
                        glm::any(glm::greaterThan(voxel, glm::dvec3(kSize - 1))))
                        continue;
                    worst = std::max(worst, std::abs(value - (7.0 + glm::dot(slope, mm))));
                    ++values;
                }
            }
            EXPECT_GT(values, 100);
            EXPECT_LT(worst, 1e-4) << turn;
        }
    }
}

// A marker on the helix lies on the curve's line, at the length of the helix up to it; one beside it lies as
// far from the line as it is from the curve.
TEST(CurvedSlice, ShowsMarkersWhereClosedFormHasThem) {
    const double mmInTurn = std::hypot(kTau * 15.0, 30.0);
    for (const double turns : {0.3, 0.5, 0.68}) {
        const CurvedFrame frame(helix(), CurvedKind::straightened, 40.0, 14.0, 0.4);
        const glm::dvec2 found = centreOfMass(sampleCurved(ball(onHelix(turns)), frame, {}));
        const double voxelPx = kSideMm / frame.mmPerPixel();
        EXPECT_NEAR(found.x, turns * mmInTurn / frame.mmPerPixel(), 0.1 * voxelPx) << turns;
        EXPECT_NEAR(found.y, 0.5 * frame.sizePx().y, 0.1 * voxelPx) << turns;

        const CurvePlace place = frame.curve().at(turns * mmInTurn);
        const glm::dvec3 down = frame.column(turns * mmInTurn / frame.mmPerPixel()).down;
        const glm::dvec2 beside = centreOfMass(sampleCurved(ball(place.mm + 2.0 * down), frame, {}));
        EXPECT_NEAR(beside.y - 0.5 * frame.sizePx().y, 2.0 / frame.mmPerPixel(), 0.3 * voxelPx) << turns;
    }
}

// Double oblique: three planes turned about a marker all show it in their middle; one off the plane's middle
// is where the plane's own axes have it.
TEST(TurnedPlanes, ShowMarkersWhereClosedFormHasThem) {
    const glm::dvec3 about(4.3, -6.1, 2.7);
    const Volume volume = ball(about);
    const glm::dquat turn = glm::angleAxis(0.6, glm::normalize(glm::dvec3(0.3, -1.0, 0.7)));
    for (const Orientation orientation : {Orientation::axial, Orientation::coronal, Orientation::sagittal}) {
        SlicePlane plane = tilted(planeOf(orientation, about), turn);
        const glm::dvec2 away(3.2, -5.4);
        plane.centreMm -= plane.right * away.x + plane.down * away.y;
        const SliceFrame frame{.plane = plane, .mmPerPixel = 0.35, .sizePx = {90, 80}};
        const glm::dvec2 found = centreOfMass(sampleSlice(volume, frame, {}, Filter::linear));
        const double voxelPx = kSideMm / frame.mmPerPixel;
        EXPECT_NEAR(found.x, 45.0 + away.x / 0.35, 0.1 * voxelPx) << int(orientation);
        EXPECT_NEAR(found.y, 40.0 + away.y / 0.35, 0.1 * voxelPx) << int(orientation);
    }
}

// In a stretched picture the length of the curve itself is true: it is drawn as long as it is.
TEST(CurvedSlice, KeepsLengthsInAStretchedPicture) {
    for (const double turn : {0.0, 45.0, 120.0}) {
        const CurvedFrame frame(helix(), CurvedKind::stretched, turn, 20.0, 0.25);
        double drawnPx = 0.0;
        glm::dvec2 last = frame.pictureFromCurve(0.0);
        for (const CurvePlace& place : frame.curve().places()) {
            const glm::dvec2 px = frame.pictureFromCurve(place.atMm);
            drawnPx += glm::distance(last, px);
            last = px;
            EXPECT_LT(glm::distance(frame.worldFromPicture(px), place.mm), 0.01);
        }
        EXPECT_NEAR(drawnPx * frame.mmPerPixel() / std::hypot(kTau * 15.0, 30.0), 1.0, 0.005) << turn;
    }
}

// From the feet up: at 0 degrees the picture goes down to the patient's left, at 90 to posterior.
TEST(CurvedSlice, TurnsAboutTheCurve) {
    const Curve up(std::vector{glm::dvec3(0.0, 0.0, -20.0), glm::dvec3(0.0, 0.0, 20.0)});
    const auto down = [&](double deg) {
        return CurvedFrame(up, CurvedKind::straightened, deg, 10.0, 1.0).column(5.0).down;
    };
    EXPECT_LT(glm::distance(down(0.0), glm::dvec3(1.0, 0.0, 0.0)), 1e-12);
    EXPECT_LT(glm::distance(down(90.0), glm::dvec3(0.0, 1.0, 0.0)), 1e-12);
    EXPECT_LT(glm::distance(up.at(3.0).section().right, glm::dvec3(1.0, 0.0, 0.0)), 1e-12);
    EXPECT_LT(glm::distance(up.at(3.0).section().down, glm::dvec3(0.0, 1.0, 0.0)), 1e-12);
}

TEST(CurvedSlice, ProjectsASlab) {
    const Volume volume = volumeBy([](const glm::dvec3& mm) { return mm.y; });
    const Curve line(std::vector{glm::dvec3(-20.0, 0.0, 0.0), glm::dvec3(20.0, 0.0, 0.0)});
    // The curve runs to the left of the patient, and the picture goes down: the slab is across both.
    const CurvedFrame frame(line, CurvedKind::straightened, 90.0, 8.0, 1.0);
    const bool isAlongY = std::abs(frame.column(5.0).depth.y) > 0.5;
    const CurvedFrame across(line, CurvedKind::straightened, isAlongY ? 90.0 : 0.0, 8.0, 1.0);
    ASSERT_NEAR(std::abs(across.column(5.0).depth.y), 1.0, 1e-9);
    const auto middle = [&](Projection projection) {
        const SampledSlice slice =
            sampleCurved(volume, across, {.thicknessMm = 6.0, .projection = projection});
        return slice.values[std::size_t(4 * slice.sizePx.x + 20)];
    };
    EXPECT_NEAR(middle(Projection::mean), 0.0, 1e-5);
    EXPECT_NEAR(middle(Projection::maximum), 3.0, 1e-5);
    EXPECT_NEAR(middle(Projection::minimum), -3.0, 1e-5);
}

TEST(CurvedSlice, IsBoundedAndCancelled) {
    const Volume volume = storedVolume({4, 4, 4}, straight(), Padding::some);
    const Curve vast(std::vector{glm::dvec3(0.0), glm::dvec3(1e6, 0.0, 0.0)});
    for (const CurvedKind kind : {CurvedKind::straightened, CurvedKind::stretched}) {
        const CurvedFrame frame(vast, kind, std::numeric_limits<double>::quiet_NaN(), 1e9, 1e-9);
        EXPECT_LE(frame.sizePx().x, CurvedFrame::kMostPixels);
        EXPECT_LE(frame.sizePx().y, CurvedFrame::kMostPixels);
        EXPECT_GE(frame.mmPerPixel() * frame.sizePx().x, 1e6 - 1.0);
    }
    const CurvedFrame frame(helix(), CurvedKind::straightened, 0.0, 20.0, 0.5);
    EXPECT_TRUE(sampleCurved(volume, frame, {}, [] { return true; }).values.empty());
    for (const float value : sampleCurved(volume, frame, {.thicknessMm = 1e300}).values)
        EXPECT_FALSE(std::isinf(value));
}

}  // namespace
}  // namespace macula::slices::test

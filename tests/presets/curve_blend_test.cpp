// Midpoint and sharpness as vtkPiecewiseFunction defines them: known values, and properties.

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/volume/transfer_function.h"

namespace macula {
namespace {

TEST(CurveBlend, DefaultsAreALine) {
    for (double u = 0.0; u <= 1.0; u += 0.125) EXPECT_EQ(blendedFraction(u, 0.5, 0.0), u);
}

TEST(CurveBlend, TheHalfValueLiesAtTheMidpoint) {
    for (const double midpoint : {0.1, 0.25, 0.5, 0.8}) {
        for (const double sharpness : {0.0, 0.2, 0.5, 0.9}) {
            EXPECT_NEAR(blendedFraction(midpoint, midpoint, sharpness), 0.5, 1e-12);
            EXPECT_EQ(blendedFraction(0.0, midpoint, sharpness), 0.0);
            EXPECT_EQ(blendedFraction(1.0, midpoint, sharpness), 1.0);
        }
    }
    EXPECT_NEAR(blendedFraction(0.125, 0.25, 0.0), 0.25, 1e-15);
    EXPECT_NEAR(blendedFraction(0.625, 0.25, 0.0), 0.75, 1e-15);
}

// Sharpness 0.5, a quarter of the way: s = 0.5 * 0.5^6 = 1/128, then the Hermite curve with slopes 0.5.
TEST(CurveBlend, KnownValueOnACurve) {
    const double s = 1.0 / 128.0;
    const double h2 = 3 * s * s - 2 * s * s * s;
    const double h3 = s * s * s - 2 * s * s + s;
    const double h4 = s * s * s - s * s;
    EXPECT_NEAR(blendedFraction(0.25, 0.5, 0.5), h2 + 0.5 * (h3 + h4), 1e-15);
    EXPECT_NEAR(blendedFraction(0.75, 0.5, 0.5), 1.0 - (h2 + 0.5 * (h3 + h4)), 1e-15);
    EXPECT_NEAR(warpedFraction(0.25, 0.5, 0.5), s, 1e-15);
}

TEST(CurveBlend, AlmostOneIsAStepAtTheMidpointAndAlmostZeroALine) {
    EXPECT_EQ(blendedFraction(0.2999, 0.3, 1.0), 0.0);
    EXPECT_EQ(blendedFraction(0.3, 0.3, 1.0), 1.0);
    EXPECT_EQ(blendedFraction(0.3, 0.5, 0.009), 0.3);
    EXPECT_NE(blendedFraction(0.3, 0.5, 0.011), 0.3);
}

TEST(CurveBlend, RisesAndStaysBetweenItsEnds) {
    for (const double midpoint : {0.0, 0.3, 1.0}) {
        for (const double sharpness : {0.0, 0.011, 0.4, 0.989, 1.0}) {
            double last = 0.0;
            for (int i = 0; i <= 1000; ++i) {
                const double height = blendedFraction(i / 1000.0, midpoint, sharpness);
                EXPECT_GE(height, last - 1e-15);
                EXPECT_LE(height, 1.0);
                last = height;
            }
        }
    }
}

// A transfer function evaluates its curved pieces exactly, whatever their width.
TEST(CurveBlend, IsWhatATransferFunctionEvaluates) {
    TransferFunction f;
    f.opacity = {{0.0, 0.2, 0.25, 0.5}, {1000.0, 0.8, 0.5, 1.0}, {1000.5, 0.0}};
    f.colour = {{0.0, {0.0, 0.2, 1.0}, 0.3, 0.7}, {10.0, {1.0, 0.4, 0.0}}};
    for (double x = 0.0; x < 1000.0; x += 0.37)
        EXPECT_NEAR(opacityAt(f, x), 0.2 + 0.6 * blendedFraction(x / 1000.0, 0.25, 0.5), 1e-15);
    EXPECT_EQ(opacityAt(f, 1000.24), 0.8);
    EXPECT_EQ(opacityAt(f, 1000.25), 0.0);
    EXPECT_NEAR(colourAt(f, 4.0).g, 0.2 + 0.2 * blendedFraction(0.4, 0.3, 0.7), 1e-15);
    f.gradientOpacity = f.opacity;
    EXPECT_EQ(gradientOpacityAt(f, 123.0), opacityAt(f, 123.0));
}

TEST(CurveBlend, AGradientOpacityCountsOnlyWhereGradientsAre) {
    TransferFunction f;
    f.opacity = {{0.0, 1.0}};
    f.colour = {{0.0, {1.0, 1.0, 1.0}}};
    EXPECT_FALSE(usesGradientOpacity(f));
    f.gradientOpacity = {{-10.0, 0.0}, {-1.0, 1.0}, {20.0, 1.0}};  // as in US-Fetal
    EXPECT_FALSE(usesGradientOpacity(f));
    EXPECT_TRUE(validate(f).ok());
    f.gradientOpacity = {{-10.0, 0.0}, {1.0, 1.0}};
    EXPECT_TRUE(usesGradientOpacity(f));
    f.gradientOpacity = {{0.0, 1.0}, {5.0, 0.5}};
    EXPECT_TRUE(usesGradientOpacity(f));
    EXPECT_TRUE(validate(f).ok());
    f.gradientOpacity[1].opacity = 2.0;
    EXPECT_FALSE(validate(f).ok());
}

}  // namespace
}  // namespace macula

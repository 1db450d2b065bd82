#include "pipeline/volume/transfer_function.h"

#include <gtest/gtest.h>

#include <limits>

#include "trace/scenes.h"

namespace macula {
namespace {

TransferFunction example() {
    TransferFunction f;
    f.name = "example";
    f.opacity = {{-100, 0.0}, {0, 0.5}, {0, 0.8}, {100, 1.0}};
    f.colour = {{-100, {1, 0, 0}}, {100, {0, 1, 0}}};
    return f;
}

TEST(TransferFunction, IsPiecewiseLinearAndConstantBeyondItsEnds) {
    const TransferFunction f = example();
    EXPECT_EQ(opacityAt(f, -1e9), 0.0);
    EXPECT_NEAR(opacityAt(f, -50), 0.25, 1e-12);
    EXPECT_EQ(opacityAt(f, 1e9), 1.0);
    EXPECT_NEAR(colourAt(f, 0).r, 0.5, 1e-12);
}

TEST(TransferFunction, AtAStepTheLaterPointHolds) {
    EXPECT_EQ(opacityAt(example(), 0.0), 0.8);
    EXPECT_NEAR(opacityAt(example(), -1e-9), 0.5, 1e-6);
}

TEST(TransferFunction, ExtinctionFollowsTheFormulaAndIsNeverInfinite) {
    TransferFunction f = example();
    EXPECT_NEAR(extinctionPerMm(f, -50), -std::log(0.75), 1e-12);
    EXPECT_NEAR(extinctionPerMm(f, 100), -std::log(0.001), 1e-9);
    f.unitDistanceMm = 2.0;
    f.density = 3.0;
    EXPECT_NEAR(extinctionPerMm(f, -50), -std::log(0.75) * 1.5, 1e-12);
    EXPECT_EQ(extinctionPerMm(f, -200), 0.0);
}

TEST(TransferFunction, RefusesCurvesThatMeanNothing) {
    EXPECT_TRUE(validate(example()).ok());
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    auto f = example();
    f.opacity.clear();
    EXPECT_FALSE(validate(f).ok());
    f = example();
    f.opacity[1].value = -200;
    EXPECT_FALSE(validate(f).ok());
    f = example();
    f.opacity[1].opacity = 1.5;
    EXPECT_FALSE(validate(f).ok());
    f = example();
    f.colour[0].colour.g = kNan;
    EXPECT_FALSE(validate(f).ok());
    f = example();
    f.colour[0].value = kNan;
    EXPECT_FALSE(validate(f).ok());
    f = example();
    f.unitDistanceMm = 0.0;
    EXPECT_FALSE(validate(f).ok());
    f = example();
    f.anisotropy = 0.995;
    EXPECT_FALSE(validate(f).ok());
    f.anisotropy = -0.99;
    EXPECT_TRUE(validate(f).ok());
    for (const Surface& wrong :
         {Surface{.weight = 1.1}, Surface{.weight = kNan}, Surface{.gradientPerMm = 0.0},
          Surface{.roughness = 0.05}, Surface{.roughness = kNan}, Surface{.reflectance = -0.1}}) {
        f.surface = wrong;
        EXPECT_FALSE(validate(f).ok());
    }
}

TransferFunction steepExample() {
    TransferFunction f = example();
    f.steep = {.opacity = {{0, 0.2}, {50, 0.9}}, .colour = {{0, {0, 0, 1}}}, .gradientPerMm = 80.0};
    return f;
}

TEST(TransferFunction, SteepMatterHasCurvesOfItsOwn) {
    EXPECT_FALSE(usesSteepCurves(example()));
    const TransferFunction f = steepExample();
    EXPECT_TRUE(usesSteepCurves(f));
    const TransferFunction swapped = withCurvesSwapped(f);
    EXPECT_EQ(opacityAt(swapped, 25.0), 0.55);
    EXPECT_EQ(colourAt(swapped, 25.0), glm::dvec3(0, 0, 1));
    EXPECT_EQ(swapped.steep.opacity, f.opacity);
    EXPECT_EQ(swapped.steep.gradientPerMm, 80.0);
    EXPECT_EQ(withCurvesSwapped(swapped), f);
}

TEST(TransferFunction, HalfOfTheMatterIsSteepAtItsGradient) {
    const TransferFunction f = steepExample();
    EXPECT_EQ(steepPartAt(f, 0.0), 0.0);
    EXPECT_EQ(steepPartAt(f, 80.0), 0.5);
    EXPECT_NEAR(steepPartAt(f, 240.0), 0.9, 1e-12);
    // No gradient is too small or too large for doubles.
    EXPECT_EQ(steepPartAt(f, 1e-300), 0.0);
    EXPECT_EQ(steepPartAt(f, 1e300), 1.0);
}

TEST(TransferFunction, RefusesCurvesOfSteepMatterThatMeanNothing) {
    EXPECT_TRUE(validate(steepExample()).ok());
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    const auto isRefused = [](const auto& spoil) {
        TransferFunction f = steepExample();
        spoil(f.steep);
        const auto checked = validate(f);
        return !checked && checked.error().message.english().find("steep") != std::string::npos;
    };
    EXPECT_TRUE(isRefused([](SteepMatter& s) { s.opacity.clear(); })) << "colours alone";
    EXPECT_TRUE(isRefused([](SteepMatter& s) { s.colour.clear(); })) << "opacities alone";
    EXPECT_TRUE(isRefused([](SteepMatter& s) { s.opacity[0].value = 60; })) << "not sorted";
    EXPECT_TRUE(isRefused([](SteepMatter& s) { s.opacity[0].opacity = 1.1; }));
    EXPECT_TRUE(isRefused([](SteepMatter& s) { s.opacity[0].opacity = kNan; }));
    EXPECT_TRUE(isRefused([](SteepMatter& s) { s.colour[0].value = kNan; }));
    EXPECT_TRUE(isRefused([](SteepMatter& s) { s.colour[0].colour.b = -0.1; }));
    for (const double wrong : {0.0, -1.0, kNan, std::numeric_limits<double>::infinity()})
        EXPECT_TRUE(isRefused([&](SteepMatter& s) { s.gradientPerMm = wrong; })) << wrong;
    TransferFunction none = example();
    none.steep.gradientPerMm = 0.0;
    EXPECT_FALSE(validate(none).ok()) << "also where nothing uses it";
}

TEST(TransferFunction, FitsTheForegroundOfTheVolume) {
    // Nine tenths air at 3, the rest spread over 1000 to 1999.
    const auto volume = scenes::volumeOf({100, 100, 1}, glm::dmat4(1.0), [](int i, int j, int) {
        return static_cast<std::uint16_t>(j < 90 ? 3 : 1000 + (i + 100 * (j - 90)));
    });
    auto f = example();
    f.fitToVolume = TransferFunction::Fit{-100, 100};
    const TransferFunction stretched = fitted(f, *volume);
    EXPECT_NEAR(stretched.opacity.front().value, 1020, 2);
    EXPECT_NEAR(stretched.opacity.back().value, 1980, 2);
    EXPECT_NEAR(stretched.opacity[1].value, 1500, 2);
    EXPECT_FALSE(stretched.fitToVolume.has_value());
}

TEST(TransferFunction, FittedCurvesSuitEveryUnitButHounsfield) {
    TransferFunction f = example();
    f.unit = Unit::hounsfield;
    EXPECT_TRUE(suits(f, Unit::hounsfield));
    EXPECT_FALSE(suits(f, Unit::raw));
    EXPECT_FALSE(suits(f, Unit::becquerelsPerMillilitre));
    f.unit = Unit::raw;
    EXPECT_TRUE(suits(f, Unit::raw));
    EXPECT_FALSE(suits(f, Unit::becquerelsPerMillilitre));
    f.fitToVolume = TransferFunction::Fit{0, 100};
    EXPECT_TRUE(suits(f, Unit::becquerelsPerMillilitre));
    EXPECT_TRUE(suits(f, Unit::other));
    EXPECT_FALSE(suits(f, Unit::hounsfield));
}

}  // namespace
}  // namespace macula

#include "scene/transfer/edited_transfer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string_view>

#include "pipeline/volume/transfer_function_json.h"
#include "presets/catalogue.h"
#include "presets/vtk_curve.h"
#include "scene/state/study_state.h"
#include "scene/transfer/same_transfer.h"

namespace macula::scene {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = presets::kLargestValue;

TransferFunction builtIn(std::string_view name) {
    const auto all = presets::builtInPresets();
    return *std::ranges::find_if(*all, [&](const TransferFunction& preset) { return preset.name == name; });
}

// 0 to 400 HU opaque, red to white.
TransferFunction ramp() {
    return {.name = "ramp",
            .title = "Ramp",
            .opacity = {{.value = 0.0, .opacity = 0.0}, {.value = 400.0, .opacity = 1.0}},
            .colour = {{.value = 0.0, .colour = {1.0, 0.0, 0.0}}, {.value = 400.0}},
            .effectiveRange = ValueRange{0.0, 400.0}};
}

bool isWithinRange(const TransferFunction& function) {
    const auto holds = [](const auto& point) { return std::abs(point.value) <= kLargest; };
    return std::ranges::all_of(function.opacity, holds) && std::ranges::all_of(function.colour, holds) &&
           std::ranges::all_of(function.gradientOpacity, holds) &&
           std::ranges::all_of(function.steep.opacity, holds) &&
           std::ranges::all_of(function.steep.colour, holds);
}

// The largest distance of two functions of the same shape, in value.
double farthest(const TransferFunction& a, const TransferFunction& b) {
    EXPECT_EQ(a.opacity.size(), b.opacity.size());
    EXPECT_EQ(a.colour.size(), b.colour.size());
    double most = 0.0;
    for (std::size_t i = 0; i < a.opacity.size(); ++i)
        most = std::max(most, std::abs(a.opacity[i].value - b.opacity[i].value));
    for (std::size_t i = 0; i < a.colour.size(); ++i)
        most = std::max(most, std::abs(a.colour[i].value - b.colour[i].value));
    for (std::size_t i = 0; i < a.gradientOpacity.size(); ++i)
        most = std::max(most, std::abs(a.gradientOpacity[i].value - b.gradientOpacity[i].value));
    return most;
}

class RandomEdits {
  public:
    explicit RandomEdits(unsigned seed) : random_(seed) {}

    TransferFunction edit(TransferFunction f) {
        const double value = number();
        const double other = number();
        const std::size_t opacity = below(f.opacity.size());
        const std::size_t colour = below(f.colour.size());
        switch (below(13)) {
            case 0:
                return movedOpacityPoint(std::move(f), opacity, value, other);
            case 1:
                return movedColourPoint(std::move(f), colour, value);
            case 2:
                return recoloured(std::move(f), colour, {value, other, number()});
            case 3:
                return withOpacityPoint(std::move(f), value, other).function;
            case 4:
                return withColourPoint(std::move(f), value, {other, number(), 0.5}).function;
            case 5:
                return withoutOpacityPoint(std::move(f), opacity);
            case 6:
                return withoutColourPoint(std::move(f), colour);
            case 7:
                return shifted(std::move(f), value);
            case 8:
                return widened(std::move(f), value, other);
            case 9:
                return withSteepCurves(std::move(f));
            case 10:
                return below(4) == 0 ? withoutSteepCurves(std::move(f)) : f;
            case 11:
                return usesSteepCurves(f) ? withCurvesSwapped(std::move(f)) : f;
            default:
                return withOpacityScaled(std::move(f), value);
        }
    }

  private:
    std::size_t below(std::size_t end) { return std::size_t(random_() % end); }
    double number() {
        static const std::array kOdd{0.0,    -0.0,   1.0, kNaN, kInfinity, -kInfinity, 1e300,
                                     -1e300, 1e-300, 1e9, -1e9, 5e-324,    0.5,        1e-7};
        if (below(3) == 0) return kOdd.at(below(kOdd.size()));
        return std::uniform_real_distribution(-2000.0, 2000.0)(random_);
    }

    std::mt19937 random_;
};

TEST(EditedTransfer, IsValidAfterAnyEdits) {
    const auto all = presets::builtInPresets();
    ASSERT_TRUE(all);
    unsigned seed = 0;
    for (const TransferFunction& preset : *all) {
        RandomEdits edits(++seed);
        TransferFunction function = preset;
        for (int i = 0; i < 200; ++i) {
            function = edits.edit(std::move(function));
            ASSERT_TRUE(validate(function)) << preset.name << " after " << i;
            ASSERT_TRUE(isWithinRange(function)) << preset.name << " after " << i;
            if (function.effectiveRange) {
                ASSERT_LT(function.effectiveRange->low, function.effectiveRange->high) << preset.name;
            }
            EXPECT_EQ(function.fitToVolume, preset.fitToVolume);
            EXPECT_TRUE(std::isfinite(extinctionPerMm(function, 1e12)));
        }
        // What a file says is checked more strictly than what is drawn.
        const auto again = transferFunctionFromJson(toJson(function), "edited");
        ASSERT_TRUE(again) << preset.name << ": " << again.error().message;
        EXPECT_TRUE(isSame(*again, function)) << preset.name;
    }
}

TEST(EditedTransfer, ShiftedAndBackIsTheSame) {
    const auto all = presets::builtInPresets();
    ASSERT_TRUE(all);
    for (const TransferFunction& preset : *all) {
        for (const double by : {1.0, 37.25, -512.1, 12345.6}) {
            const TransferFunction there = shifted(preset, by);
            EXPECT_NEAR(there.opacity.front().value, preset.opacity.front().value + by, 1e-9);
            EXPECT_LT(farthest(shifted(there, -by), preset), 1e-9) << preset.name;
            EXPECT_EQ(there.gradientOpacity, preset.gradientOpacity);
        }
    }
}

TEST(EditedTransfer, ShiftsWhatIsSeen) {
    const TransferFunction before = builtIn("ct-bone");
    const TransferFunction after = shifted(before, 128.0);
    for (double value = -3500.0; value < 3500.0; value += 61.0) {
        EXPECT_NEAR(opacityAt(after, value + 128.0), opacityAt(before, value), 1e-12);
        EXPECT_LT(glm::length(colourAt(after, value + 128.0) - colourAt(before, value)), 1e-9);
    }
    EXPECT_EQ(shifted(ramp(), 100.0).effectiveRange, (ValueRange{100.0, 500.0}));
}

TEST(EditedTransfer, WidensAboutAValue) {
    const TransferFunction before = builtIn("uct-skull");
    ASSERT_TRUE(usesGradientOpacity(before));
    const TransferFunction after = widened(before, 2.5, 300.0);
    for (double value = -3500.0; value < 3500.0; value += 61.0)
        EXPECT_NEAR(opacityAt(after, 300.0 + 2.5 * (value - 300.0)), opacityAt(before, value), 1e-9);
    for (double gradient = 0.0; gradient < 500.0; gradient += 13.0)
        EXPECT_NEAR(gradientOpacityAt(after, 2.5 * gradient), gradientOpacityAt(before, gradient), 1e-9);
    EXPECT_LT(farthest(widened(after, 1.0 / 2.5, 300.0), before), 1e-8);
    EXPECT_EQ(widened(builtIn("cinematic-bone"), 2.5, 300.0).surface.gradientPerMm,
              2.5 * builtIn("cinematic-bone").surface.gradientPerMm);
    EXPECT_EQ(widened(ramp(), 0.5, 400.0).effectiveRange, (ValueRange{200.0, 400.0}));
    EXPECT_EQ(widened(before, 1.0, 123.4), before);
}

TEST(EditedTransfer, AddsCurvesOfSteepMatterThatChangeNothingAndRemovesThem) {
    const TransferFunction before = builtIn("ct-bone");
    ASSERT_FALSE(usesSteepCurves(before));
    const TransferFunction split = withSteepCurves(before);
    EXPECT_EQ(split.steep.opacity, before.opacity);
    EXPECT_EQ(split.steep.colour, before.colour);
    EXPECT_EQ(withoutSteepCurves(split), before);

    // All curves move together, and the gradient is as much wider as values are.
    TransferFunction other = split;
    other.steep.opacity = {{.value = 300.0, .opacity = 0.1}, {.value = 700.0, .opacity = 0.9}};
    EXPECT_EQ(withSteepCurves(other), other) << "those that are there stay";
    EXPECT_EQ(shifted(other, 50.0).steep.opacity[1].value, 750.0);
    EXPECT_EQ(shifted(other, 50.0).steep.colour[0].value, before.colour[0].value + 50.0);
    const TransferFunction wide = widened(other, 2.0, 300.0);
    EXPECT_EQ(wide.steep.opacity[0].value, 300.0);
    EXPECT_EQ(wide.steep.opacity[1].value, 1100.0);
    EXPECT_EQ(wide.steep.gradientPerMm, 2.0 * other.steep.gradientPerMm);
    EXPECT_EQ(withOpacityScaled(other, 0.5).steep.opacity[1].opacity, 0.45);
    // What reaches furthest is held at the end of the range, whichever curve it is of.
    other.steep.opacity.back().value = kLargest - 10.0;
    EXPECT_EQ(shifted(other, 1e300).steep.opacity.back().value, kLargest);
    EXPECT_EQ(shifted(other, 1e300).opacity.back().value, other.opacity.back().value + 10.0);
}

// Opaque stays opaque, however far a hand pulls; and a shape stays a shape.
TEST(EditedTransfer, IsHeldAtTheEndsOfTheRange) {
    const TransferFunction right = shifted(ramp(), 1e300);
    EXPECT_EQ(right.opacity.back().value, kLargest);
    EXPECT_NEAR(right.opacity.front().value, kLargest - 400.0, 1e-6);
    EXPECT_EQ(opacityAt(right, 2.0 * kLargest), 1.0);
    EXPECT_EQ(opacityAt(right, 0.0), 0.0);
    EXPECT_EQ(shifted(ramp(), -1e300).opacity.front().value, -kLargest);

    const TransferFunction wide = widened(ramp(), 1e300, 100.0);
    EXPECT_LE(wide.opacity.back().value, kLargest);
    EXPECT_EQ(opacityAt(wide, 2.0 * kLargest), 1.0);
    const TransferFunction narrow = widened(ramp(), 1e-300, 100.0);
    EXPECT_GT(narrow.opacity.back().value - narrow.opacity.front().value, 0.5 * kNarrowestCurve);
    EXPECT_EQ(opacityAt(narrow, 101.0), 1.0);
    EXPECT_EQ(opacityAt(narrow, 99.0), 0.0);
    EXPECT_EQ(widened(ramp(), 0.0, 0.0), ramp());
    EXPECT_EQ(widened(ramp(), -2.0, 0.0), ramp());
}

// Else each shift would be undone when it is drawn.
TEST(EditedTransfer, LeavesWhatAPresetIsFittedBy) {
    const TransferFunction before = builtIn("cinematic-mr");
    ASSERT_TRUE(before.fitToVolume);
    for (const TransferFunction& after : {shifted(before, 50.0), widened(before, 2.0, 500.0)}) {
        EXPECT_EQ(after.fitToVolume, before.fitToVolume);
        EXPECT_EQ(after.effectiveRange, before.effectiveRange);
        EXPECT_GT(farthest(after, before), 1.0);
    }
}

TEST(EditedTransfer, APointStaysBetweenItsNeighbours) {
    const TransferFunction before = builtIn("ct-bone");
    ASSERT_EQ(before.opacity.size(), 4u);
    EXPECT_EQ(movedOpacityPoint(before, 1, -9000.0, 0.25).opacity[1],
              (OpacityPoint{.value = before.opacity[0].value, .opacity = 0.25}));
    EXPECT_EQ(movedOpacityPoint(before, 1, 9000.0, 2.0).opacity[1],
              (OpacityPoint{.value = before.opacity[2].value, .opacity = 1.0}));
    EXPECT_EQ(movedOpacityPoint(before, 3, 1e12, -2.0).opacity[3],
              (OpacityPoint{.value = kLargest, .opacity = 0.0}));
    EXPECT_EQ(movedColourPoint(before, 2, -9000.0).colour[2].value, before.colour[1].value);
    EXPECT_EQ(movedColourPoint(before, 0, -1e12).colour[0].value, -kLargest);
    EXPECT_EQ(recoloured(before, 1, {0.25, -1.0, 7.0}).colour[1].colour, glm::dvec3(0.25, 0.0, 1.0));
}

TEST(EditedTransfer, APointOnTheCurveChangesNoPicture) {
    const TransferFunction before = builtIn("ct-bone");
    for (const double value : {-4000.0, -100.0, 300.0, 641.385, 2000.0, 4000.0}) {
        const Added opacity = withOpacityPoint(before, value, opacityAt(before, value));
        const Added both = withColourPoint(opacity.function, value, colourAt(before, value));
        ASSERT_TRUE(opacity.index && both.index);
        EXPECT_EQ(both.function.opacity[*opacity.index].value, value);
        EXPECT_EQ(both.function.colour[*both.index].value, value);
        EXPECT_EQ(both.function.opacity.size(), before.opacity.size() + 1);
        for (double at = -4500.0; at < 4500.0; at += 37.0) {
            EXPECT_NEAR(opacityAt(both.function, at), opacityAt(before, at), 1e-12);
            EXPECT_LT(glm::length(colourAt(both.function, at) - colourAt(before, at)), 1e-9);
        }
        EXPECT_EQ(withoutOpacityPoint(opacity.function, *opacity.index), before);
    }
}

TEST(EditedTransfer, ACurvedPieceBecomesTwoStraightOnes) {
    TransferFunction curved = ramp();
    curved.opacity[0].sharpness = 1.0;  // a step at 200
    ASSERT_EQ(opacityAt(curved, 150.0), 0.0);
    const Added added = withOpacityPoint(curved, 200.0, 0.8);
    ASSERT_EQ(added.index, 1u);
    EXPECT_NEAR(opacityAt(added.function, 100.0), 0.4, 1e-12);
    EXPECT_NEAR(opacityAt(added.function, 300.0), 0.9, 1e-12);
}

TEST(EditedTransfer, ACurveIsNeverEmptyAndNeverTooLong) {
    TransferFunction function = withoutOpacityPoint(withoutColourPoint(ramp(), 1), 0);
    EXPECT_EQ(function.opacity.size(), 1u);
    EXPECT_EQ(withoutOpacityPoint(function, 0), function);
    EXPECT_EQ(withoutColourPoint(function, 0), function);

    function.opacity.assign(presets::kMostPoints, OpacityPoint{.value = 5.0, .opacity = 0.5});
    const Added added = withOpacityPoint(function, 6.0, 0.5);
    EXPECT_FALSE(added.index);
    EXPECT_EQ(added.function, function);
}

TEST(EditedTransfer, ScalesOpacity) {
    const TransferFunction half = withOpacityScaled(builtIn("ct-bone"), 0.5);
    EXPECT_NEAR(half.opacity[2].opacity, 0.5 * 0.715686, 1e-12);
    EXPECT_EQ(withOpacityScaled(half, 1e300).opacity[2].opacity, 1.0);
    EXPECT_EQ(withOpacityScaled(half, 1e300).opacity[1].opacity, 0.0);
    EXPECT_EQ(withOpacityScaled(half, 0.0).opacity[2].opacity, 0.0);
    EXPECT_EQ(withOpacityScaled(half, -1.0), half);
}

TEST(EditedTransfer, WhatIsNoNumberChangesNothing) {
    const TransferFunction f = ramp();
    for (const double none : {kNaN, kInfinity, -kInfinity}) {
        EXPECT_EQ(movedOpacityPoint(f, 0, none, none), f);
        EXPECT_EQ(movedOpacityPoint(f, 0, 5.0, none).opacity[0].value, 5.0);
        EXPECT_EQ(movedColourPoint(f, 0, none), f);
        EXPECT_EQ(recoloured(f, 0, glm::dvec3(none)), f);
        EXPECT_EQ(withOpacityPoint(f, none, 0.5).function, f);
        EXPECT_EQ(withOpacityPoint(f, 5.0, none).function, f);
        EXPECT_EQ(withColourPoint(f, none, glm::dvec3(0.5)).function, f);
        EXPECT_EQ(withColourPoint(f, 5.0, glm::dvec3(none)).function, f);
        EXPECT_EQ(shifted(f, none), f);
        EXPECT_EQ(widened(f, none, 0.0), f);
        EXPECT_EQ(widened(f, 2.0, none), f);
        EXPECT_EQ(withOpacityScaled(f, none), f);
    }
}

}  // namespace
}  // namespace macula::scene

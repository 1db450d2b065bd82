// ParaView's and VolView's colour maps.
#include "presets/imported.h"

namespace macula::presets {
namespace {

const std::string kPoints = R"("RGBPoints": [0, 0, 0, 1, 10, 1, 0, 0])";

TEST(Paraview, AMapIsStretchedOverTheValuesOfAVolume) {
    const ImportedPreset preset = only(
        R"(// made by hand
           [{"Name": "Mine", "ColorSpace": "Lab", )" +
        kPoints + R"(, "Points": [0, 0, 0.25, 0, 10, 0.5, 0.5, 0], "NanColor": [1, 1, 0]}])");
    const TransferFunction& f = preset.function;
    EXPECT_EQ(f.title, "Mine");
    EXPECT_EQ(f.unit, Unit::raw);
    EXPECT_EQ(f.colourSpace, ColourSpace::lab);
    EXPECT_EQ(f.fitToVolume, (TransferFunction::Fit{0.0, 10.0, TransferFunction::Fit::To::valueRange}));
    EXPECT_TRUE(suits(f, Unit::hounsfield));
    EXPECT_NEAR(opacityAt(f, 2.5), 0.25, 1e-12) << "half of the way lies at a quarter";
    EXPECT_TRUE(preset.notes.empty());
    EXPECT_TRUE(validate(f).ok());
}

TEST(Paraview, VolViewsValuesAreThoseOfTheVolume) {
    const ImportedPreset preset = only(
        R"([{"Name": "CT-Bone", "ColorSpace": "RGB", "AbsoluteRange": true, "OpacityPoints": [-16, 0, 641, 0.7],
                  "EffectiveRange": [-16, 641], )" +
        kPoints + "}]");
    EXPECT_EQ(preset.function.unit, Unit::hounsfield);
    EXPECT_FALSE(preset.function.fitToVolume.has_value());
    EXPECT_EQ(preset.function.effectiveRange, (ValueRange{-16.0, 641.0}));
    EXPECT_EQ(preset.function.source, "VolView");
    EXPECT_TRUE(preset.notes.empty());
}

TEST(Paraview, WithoutOpacitiesARampIsTakenAndSaid) {
    const ImportedPreset preset = only(R"({"Name": "a", )" + kPoints + "}");
    EXPECT_EQ(preset.function.opacity, (std::vector<OpacityPoint>{{0, 0}, {10, 1}}));
    EXPECT_EQ(preset.notes.size(), 1u);
}

TEST(Paraview, ColourSpaces) {
    const auto space = [](const std::string& words) {
        return only(R"([{"Name": "a", "ColorSpace": )" + words + ", " + kPoints + "}]").function.colourSpace;
    };
    EXPECT_EQ(space(R"("RGB")"), ColourSpace::rgb);
    EXPECT_EQ(space(R"("HSV")"), ColourSpace::hsv);
    EXPECT_EQ(space(R"("HSV", "HSVWrap": true)"), ColourSpace::hsvWrap);
    EXPECT_EQ(space(R"("CIELAB")"), ColourSpace::lab);
    EXPECT_EQ(space(R"("Diverging")"), ColourSpace::diverging);
    EXPECT_EQ(space(R"("Step")"), ColourSpace::step);
    expectRefused(R"([{"Name": "a", "ColorSpace": "Lab/CIEDE2000", )" + kPoints + "}]", "ColorSpace");
}

TEST(Paraview, PointsAreSortedAndStepsStay) {
    const ImportedPreset preset = only(
        R"([{"Name": "a", "RGBPoints": [10, 1, 1, 1, 0, 0, 0, 0, 5, 0, 0, 0, 5, 1, 1, 1], "OpacityPoints": [0, 1]}])");
    ASSERT_EQ(preset.function.colour.size(), 4u);
    EXPECT_EQ(colourAt(preset.function, 5.0).r, 0.0);
    EXPECT_EQ(colourAt(preset.function, 5.000001).r, 1.0);
}

TEST(Paraview, RefusesWhatWouldBeDrawnAsSomethingElse) {
    expectRefused(R"([{"Name": "a", "IndexedColors": [1, 0, 0]}])", "continuous");
    expectRefused(R"([{"Name": "a", "UseLogScale": 1, )" + kPoints + "}]", "linear scale");
    expectRefused(R"([{"Name": "a", "RGBPoints": [0, 1, 1, 1]}])", "two values");
    expectRefused(R"([{"Name": "a", "RGBPoints": [0, 1, 1]}])", "RGBPoints");
    expectRefused(R"([{"Name": "a", "RGBPoints": [0, 1, 1, 1, 2]}])", "groups of 4");
    expectRefused(R"([{"Name": "a", "RGBPoints": [0, 1, 1, 2, 1, 1, 1, 1]}])", "0 to 1");
    expectRefused(R"([{"Name": "a", "RGBPoints": [0, 1, 1, null, 1, 1, 1, 1]}])", "RGBPoints[3]");
    expectRefused(R"([{"Name": "a", "RGBPoints": [0, 1, 1, 1e999, 1, 1, 1, 1]}])", "JSON");
    expectRefused(R"([{"Name": "a", "RGBPoints": [-1e300, 1, 1, 1, 1e300, 1, 1, 1]}])", "RGBPoints[0]");
    expectRefused("[{" + kPoints + "}]", "Name is missing");
    expectRefused("[]", "list");
    expectRefused("[1]", "object");
}

}  // namespace
}  // namespace macula::presets

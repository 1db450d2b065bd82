// Presets stretched to a volume: explicit, said, and never a change of the preset.
#include <gtest/gtest.h>

#include <vector>

#include "pipeline/volume/volume_fit.h"
#include "trace/scenes.h"

namespace macula {
namespace {

TransferFunction preset() {
    TransferFunction f;
    f.name = "mr";
    f.unit = Unit::raw;
    f.opacity = {{0, 0.0}, {100, 0.5, 0.3, 0.4}, {200, 1.0}};
    f.colour = {{0, {1, 0, 0}}, {200, {0, 1, 0}}};
    f.gradientOpacity = {{0, 1.0}, {10, 0.5}};
    f.steep = {.opacity = {{50, 0.1}, {150, 0.9}}, .colour = {{75, {0, 0, 1}}}, .gradientPerMm = 25.0};
    f.effectiveRange = ValueRange{0.0, 200.0};
    return f;
}

// Nine tenths air at 3, the rest spread over 1000 to 1999.
std::shared_ptr<const Volume> volume() {
    return scenes::volumeOf({100, 100, 1}, glm::dmat4(1.0), [](int i, int j, int) {
        return static_cast<std::uint16_t>(j < 90 ? 3 : 1000 + (i + 100 * (j - 90)));
    });
}

TEST(Fit, IsAskedForAndOtherwiseDoesNothing) {
    const TransferFunction f = preset();
    EXPECT_FALSE(fitOf(f, *volume()).has_value());
    EXPECT_EQ(fitted(f, *volume()).opacity, f.opacity);
}

TEST(Fit, PutsTheEffectiveRangeOnTheForeground) {
    const auto asking = withFit(preset());
    ASSERT_TRUE(asking.ok());
    EXPECT_EQ(asking->opacity, preset().opacity) << "asking changes no number";
    const auto fit = fitOf(*asking, *volume());
    ASSERT_TRUE(fit.has_value());
    EXPECT_NEAR(fit->volume.low, 1020, 2);
    EXPECT_NEAR(fit->volume.high, 1980, 2);
    const TransferFunction done = fitted(*asking, *volume());
    for (std::size_t i = 0; i < done.opacity.size(); ++i) {
        EXPECT_EQ(done.opacity[i].value, (*fit)(preset().opacity[i].value));
        EXPECT_EQ(done.opacity[i].opacity, preset().opacity[i].opacity);
        EXPECT_EQ(done.opacity[i].sharpness, preset().opacity[i].sharpness);
    }
    // The same matter has the same opacity, half way up as well.
    EXPECT_NEAR(opacityAt(done, (*fit)(137.0)), opacityAt(preset(), 137.0), 1e-12);
    // Values are stretched by 4.8, and so are differences of them per mm.
    EXPECT_NEAR(done.gradientOpacity[1].value, 10.0 * fit->scale(), 1e-12);
    EXPECT_NEAR(done.steep.gradientPerMm, 25.0 * fit->scale(), 1e-12);
    EXPECT_EQ(done.steep.opacity[1].value, (*fit)(150.0));
    EXPECT_EQ(done.steep.colour[0].value, (*fit)(75.0));
    EXPECT_FALSE(done.fitToVolume.has_value());
}

// Masks of any two values are seen with the end of the curve, and so is the highest of a few labels; those
// between are where the curve has them.
TEST(Fit, MasksBeginAtTheirBackground) {
    const auto asking = withFit(preset());
    ASSERT_TRUE(asking.ok());
    using Values = std::vector<std::uint16_t>;
    for (const Values& values : {Values{0, 1}, Values{0, 2}, Values{0, 255}, Values{0, 1000}, Values{1, 2},
                                 Values{7, 65535}, Values{0, 100, 255}, Values{0, 50, 100, 200}}) {
        for (const int background : {5, 60, 95}) {  // of a hundred rows
            const auto mask = scenes::volumeOf({100, 100, 1}, glm::dmat4(1.0), [&](int, int j, int) {
                if (j < background) return values.front();
                return values[1 + static_cast<std::size_t>(j) % (values.size() - 1)];
            });
            const TransferFunction done = fitted(*asking, *mask);
            EXPECT_EQ(opacityAt(done, values.front()), 0.0) << values.back();
            EXPECT_EQ(opacityAt(done, values.back()), 1.0) << values.back() << " with " << background;
        }
    }
    const auto mask = scenes::volumeOf({10, 10, 1}, glm::dmat4(1.0), [](int, int j, int) {
        return static_cast<std::uint16_t>(j < 8 ? 0 : 255);
    });
    const auto fit = fitOf(*asking, *mask);
    ASSERT_TRUE(fit.has_value());
    EXPECT_EQ(fit->volume, (ValueRange{0.0, 255.0}));
    EXPECT_NE(fitMessage(*fit).sentence.english().find("the background and the 98th"), std::string::npos);
}

TEST(Fit, ToTheWholeRangeOfValues) {
    TransferFunction f = preset();
    f.fitToVolume = TransferFunction::Fit{0.0, 200.0, TransferFunction::Fit::To::valueRange};
    const auto fit = fitOf(f, *volume());
    ASSERT_TRUE(fit.has_value());
    EXPECT_EQ(fit->volume, (ValueRange{3.0, 1999.0}));
    EXPECT_TRUE(suits(f, Unit::hounsfield));
}

TEST(Fit, IsSaid) {
    const VolumeFit fit{{0, 200}, {1020, 1980}};
    const Message message = fitMessage(fit);
    EXPECT_EQ(message.key, "preset.fitted");
    EXPECT_NE(message.sentence.english().find("0 to 200 are drawn at 1020 to 1980"), std::string::npos)
        << message.sentence;
    EXPECT_FALSE(message.action.empty());
    EXPECT_EQ(message.arguments.size(), 5u);
}

TEST(Fit, NeedsARange) {
    TransferFunction f = preset();
    f.effectiveRange.reset();
    const auto asking = withFit(f);
    ASSERT_FALSE(asking.ok());
    EXPECT_FALSE(asking.error().hint.empty());
}

TEST(Fit, OfAVolumeOfOneValueIsFinite) {
    const auto flat = scenes::volumeOf({4, 4, 4}, glm::dmat4(1.0), [](int, int, int) { return 7; });
    const auto asking = withFit(preset());
    ASSERT_TRUE(asking.ok());
    const TransferFunction done = fitted(*asking, *flat);
    EXPECT_EQ(done.opacity.front().value, 7.0);
    EXPECT_EQ(done.opacity.back().value, 8.0);
}

}  // namespace
}  // namespace macula

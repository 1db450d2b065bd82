#include "scene/drawing/projection_windows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/volume/window.h"

namespace macula::scene {
namespace {

using trace::Look;

Volume volumeWith(std::vector<DisplayWindow> windows) {
    auto volume = Volume::create({.size = glm::ivec3(2),
                                  .unitsFromStored = {.slope = 1.0, .intercept = -1000.0},
                                  .unit = Unit::hounsfield,
                                  .modality = "CT",
                                  .windows = std::move(windows)},
                                 {0, 100, 200, 300, 400, 500, 600, 2000});
    return *std::move(volume);
}

TEST(SeriesWindows, AreThoseOfTheSeriesAndForMipOneThatIsNotMostlyWhite) {
    const Volume plain = volumeWith({});
    const Volume named = volumeWith({{.center = 40.0, .width = 400.0, .explanation = {}, .function = {}}});
    SeriesWindows windows;
    EXPECT_EQ(windowText(windows.of(Look::average, plain), "HU"), "W 2000 L 0 HU");
    EXPECT_EQ(windows.of(Look::mip, plain), maximumWindow(plain));
    EXPECT_NE(windows.of(Look::mip, plain), windows.of(Look::average, plain));
    windows.forget();
    EXPECT_EQ(windowText(windows.of(Look::mip, named), "HU"), "W 400 L 40 HU");
    EXPECT_EQ(windowText(windows.of(Look::average, named), "HU"), "W 400 L 40 HU");
}

TEST(DraggedWindow, ThereAndBackIsTheSameWindowAndNoneIsEverEmpty) {
    const Volume volume = volumeWith({});
    const auto dragged = [&](const DisplayWindow& from, glm::dvec2 by) {
        return scene::dragged(from, by, volume);
    };
    const DisplayWindow first{.center = 40.0, .width = 400.0, .explanation = {}, .function = {}};
    EXPECT_DOUBLE_EQ(dragged(first, {0.0, -0.1}).center, 0.0);  // up: brighter
    EXPECT_DOUBLE_EQ(dragged(first, {0.0, -0.1}).width, 400.0);
    const DisplayWindow wide = dragged(first, {0.5, 0.0});
    EXPECT_GT(wide.width, 1000.0);
    EXPECT_NEAR(dragged(wide, {-0.5, 0.0}).width, 400.0, 1e-9);
    EXPECT_GT(dragged(first, {-1000.0, 0.0}).width, 0.0);
    EXPECT_TRUE(std::isfinite(dragged(first, {1000.0, 1000.0}).width));
}

// Of values from -1000 to 1000, as far as a hand may go.
TEST(DraggedWindow, AsFarAsThereAreValuesAndNoFarther) {
    const Volume volume = volumeWith({});
    const DisplayWindow first{.center = 40.0, .width = 400.0, .explanation = {}, .function = {}};
    EXPECT_DOUBLE_EQ(dragged(first, {1000.0, 0.0}, volume).width, 4000.0);
    EXPECT_DOUBLE_EQ(dragged(first, {0.0, 1000.0}, volume).center, 1000.0);
    EXPECT_DOUBLE_EQ(dragged(first, {0.0, -1000.0}, volume).center, -1000.0);
    const DisplayWindow far{.center = 3000.0, .width = 9000.0, .explanation = {}, .function = {}};
    EXPECT_DOUBLE_EQ(dragged(far, {1.0, 1.0}, volume).width, 9000.0) << "what is there does not jump";
    EXPECT_DOUBLE_EQ(dragged(far, {0.0, 1.0}, volume).center, 3000.0);
    EXPECT_DOUBLE_EQ(dragged(first, {1000.0, 0.0}, volumeWith({far})).width, 9000.0) << "of the series";
}

TEST(WindowText, NumbersAreAsExactAsTheWindowIsWide) {
    const auto text = [](double width, double center) {
        return windowText({.center = center, .width = width, .explanation = {}, .function = {}}, "HU");
    };
    EXPECT_EQ(text(1500.4, -600.2), "W 1500 L -600 HU");
    EXPECT_EQ(text(8.26, -0.04), "W 8.3 L 0 HU");
    EXPECT_EQ(text(0.25, 0.125), "W 0.2500 L 0.1250 HU");
}

}  // namespace
}  // namespace macula::scene

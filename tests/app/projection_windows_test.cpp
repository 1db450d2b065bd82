#include "app/frame/projection_windows.h"

#include <gtest/gtest.h>

#include "pipeline/volume/window.h"

namespace macula::app {
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

TEST(ProjectionWindows, WhatWasSetInALookComesBeforeTheSeriesAndIsOfThatLookAlone) {
    const Volume plain = volumeWith({});
    const Volume named = volumeWith({{.center = 40.0, .width = 400.0, .explanation = {}, .function = {}}});
    ProjectionWindows windows;
    EXPECT_EQ(windowText(windows.of(Look::average, plain), "HU"), "W 2000 L 0 HU");
    // Of MIP one that is not mostly white.
    EXPECT_EQ(windows.of(Look::mip, plain), maximumWindow(plain));
    EXPECT_NE(windows.of(Look::mip, plain), windows.of(Look::average, plain));
    windows.forgetAll();
    EXPECT_EQ(windowText(windows.of(Look::mip, named), "HU"), "W 400 L 40 HU");
    windows.set(Look::mip,
                DisplayWindow{.center = 825.0, .width = 1350.0, .explanation = {}, .function = {}});
    EXPECT_EQ(windowText(windows.of(Look::mip, named), {}), "W 1350 L 825");
    EXPECT_EQ(windowText(windows.of(Look::average, named), "HU"), "W 400 L 40 HU");

    windows.drag(Look::mip, windows.of(Look::mip, named), {0.0, -0.1});
    EXPECT_DOUBLE_EQ(windows.of(Look::mip, named).center, 825.0 - 135.0);  // up: brighter
    EXPECT_DOUBLE_EQ(windows.of(Look::mip, named).width, 1350.0);
    windows.forget(Look::mip);
    EXPECT_DOUBLE_EQ(windows.of(Look::mip, named).center, 40.0);
}

TEST(ProjectionWindows, DraggingThereAndBackIsTheSameWindowAndNoneIsEverEmpty) {
    const DisplayWindow first{.center = 40.0, .width = 400.0, .explanation = {}, .function = {}};
    const Volume volume = volumeWith({first});
    ProjectionWindows windows;
    windows.drag(Look::minip, first, {0.5, 0.0});
    EXPECT_GT(windows.of(Look::minip, volume).width, 1000.0);
    windows.drag(Look::minip, windows.of(Look::minip, volume), {-0.5, 0.0});
    EXPECT_NEAR(windows.of(Look::minip, volume).width, 400.0, 1e-9);
    windows.drag(Look::minip, first, {-1000.0, 0.0});
    EXPECT_GT(windows.of(Look::minip, volume).width, 0.0);
    windows.drag(Look::minip, first, {1000.0, 1000.0});
    EXPECT_TRUE(std::isfinite(windows.of(Look::minip, volume).width));
    windows.forgetAll();
    EXPECT_EQ(windows.of(Look::minip, volume), first);
}

TEST(ProjectionWindows, NumbersAreAsExactAsTheWindowIsWide) {
    const auto text = [](double width, double center) {
        return windowText({.center = center, .width = width, .explanation = {}, .function = {}}, "HU");
    };
    EXPECT_EQ(text(1500.4, -600.2), "W 1500 L -600 HU");
    EXPECT_EQ(text(8.26, -0.04), "W 8.3 L 0 HU");
    EXPECT_EQ(text(0.25, 0.125), "W 0.2500 L 0.1250 HU");
}

}  // namespace
}  // namespace macula::app

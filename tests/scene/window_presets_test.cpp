#include "scene/slices/window_presets.h"

#include <gtest/gtest.h>

#include <set>

#include "pipeline/volume/window.h"

namespace macula::scene {
namespace {

Volume volumeOf(Unit unit, std::vector<DisplayWindow> windows) {
    auto volume =
        Volume::create({.size = glm::ivec3(2), .unit = unit, .modality = "CT", .windows = std::move(windows)},
                       {0, 100, 200, 300, 400, 500, 600, 800});
    return *std::move(volume);
}

DisplayWindow named(const char* explanation, double center) {
    return {.center = center, .width = 100.0, .explanation = explanation, .function = {}};
}

TEST(WindowPresets, OfCtAreTheCustomaryOnes) {
    const Volume volume = volumeOf(Unit::hounsfield, {named("OWN", 7.0), named("OTHER", 8.0)});
    std::set<int> digits;
    for (const WindowPreset& preset : windowPresets(volume)) EXPECT_TRUE(digits.insert(preset.digit).second);
    EXPECT_EQ(digits, (std::set{1, 2, 3, 4, 5, 6, 7, 8, 9}));
    EXPECT_FALSE(windowPreset(volume, 1)->window) << "that of the series, whichever it is";
    EXPECT_DOUBLE_EQ(windowPreset(volume, 2)->window->width, 400.0);
    EXPECT_DOUBLE_EQ(windowPreset(volume, 3)->window->center, -600.0);
    EXPECT_DOUBLE_EQ(windowPreset(volume, 5)->window->width, 80.0);
    EXPECT_EQ(windowPreset(volume, 9)->window, windowOver({0.0, 800.0}));
    for (const int none : {0, -1, 10}) EXPECT_FALSE(windowPreset(volume, none));
}

// The usual window of PET is none of the file's, so that all of those are to be had.
TEST(WindowPresets, OfPet) {
    const auto pet = [](Unit unit) {
        auto volume = Volume::create({.size = glm::ivec3(2),
                                      .unit = unit,
                                      .modality = "PT",
                                      .windows = {named("OWN", 7.0), named("", 8.0)}},
                                     {0, 1, 2, 3, 4, 5, 6, 8});
        return *std::move(volume);
    };
    const Volume suv = pet(Unit::suvBodyWeight);
    EXPECT_EQ(windowPreset(suv, 1)->name, "Usual for PET");
    EXPECT_FALSE(windowPreset(suv, 1)->window);
    EXPECT_EQ(windowPreset(suv, 2)->window, windowOver({0.0, 5.0}));
    EXPECT_EQ(windowPreset(suv, 4)->window, windowOver({0.0, 15.0}));
    EXPECT_EQ(windowPreset(suv, 9)->window, windowOver({0.0, 8.0}));
    const Volume becquerels = pet(Unit::becquerelsPerMillilitre);
    EXPECT_EQ(windowPreset(becquerels, 2)->name, "OWN");
    EXPECT_EQ(windowPreset(becquerels, 3)->name, "Window 2");
}

TEST(WindowPresets, OfAnythingElseAreThoseOfTheSeries) {
    const Volume volume = volumeOf(Unit::raw, {named("OWN", 7.0), named("", 8.0), named("BONE", 9.0)});
    EXPECT_FALSE(windowPreset(volume, 1)->window);
    EXPECT_EQ(windowPreset(volume, 2)->name, "Window 2");
    EXPECT_EQ(windowPreset(volume, 3)->name, "BONE");
    EXPECT_DOUBLE_EQ(windowPreset(volume, 3)->window->center, 9.0);
    EXPECT_FALSE(windowPreset(volume, 4));
    EXPECT_EQ(windowPreset(volume, 9)->window, windowOver({0.0, 800.0}));
    const Volume many = volumeOf(Unit::raw, std::vector<DisplayWindow>(30, named("SAME", 1.0)));
    EXPECT_EQ(windowPresets(many).size(), 9u);
}

}  // namespace
}  // namespace macula::scene

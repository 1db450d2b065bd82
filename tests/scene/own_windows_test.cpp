// Windows of one's own: names, units, and what may be wrong with them.
#include "scene/slices/own_windows.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace macula::scene {
namespace {

OwnWindow window(const std::string& name, double center = 60.0, const std::string& unit = "HU") {
    return {.name = name,
            .window = {.center = center, .width = 300.0, .explanation = {}, .function = {}},
            .unit = unit};
}

TEST(OwnWindows, AreTextAndBack) {
    std::vector<OwnWindow> all{window("Kidney"), window("Ä, \"B\"", -1e-3, "mm²/s")};
    all[1].window.function = "SIGMOID";
    const auto back = ownWindowsFromJson(toJson(all));
    ASSERT_TRUE(back.ok()) << back.error().message;
    EXPECT_EQ(*back, all);
    EXPECT_TRUE(ownWindowsFromJson(toJson(std::vector<OwnWindow>()))->empty());
}

TEST(OwnWindows, WhatCouldNotBeReadIsNotWritten) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<OwnWindow> all{window("Good"), window("Bad", nan), window(""), window(std::string(61, 'x'))};
    const auto back = ownWindowsFromJson(toJson(all));
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(*back, std::vector<OwnWindow>{window("Good")});
    for (const char* bad :
         {"", "[]", "{}", R"({"windows": 1})",
          R"({"windows": [{"name": "", "center": 1, "width": 1, "unit": ""}]})",
          R"({"windows": [{"name": "a", "center": 1, "width": 0, "unit": ""}]})",
          R"({"windows": [{"name": "a", "center": 1, "width": 1, "unit": "", "function": "CUBIC"}]})"})
        EXPECT_EQ(ownWindowsFromJson(bad).error().code, ErrorCode::inputNotUsable) << bad;
}

TEST(OwnWindows, OneTakesThePlaceOfItsName) {
    auto all = withOwnWindow({window("Kidney"), window("Liver")}, window("  Kidney\n", 80.0));
    ASSERT_TRUE(all.ok());
    EXPECT_EQ(*all, (std::vector<OwnWindow>{window("Liver"), window("Kidney", 80.0)}));
    all = withOwnWindow(*all, window("Kidney", 1.0, ""));
    EXPECT_EQ(all->size(), 3u) << "of another unit it is another";
    EXPECT_EQ(withOwnWindow(*all, window("  ")).error().code, ErrorCode::usage);
    EXPECT_EQ(withOwnWindow({}, window(std::string(59, 'x') + "ä"))->front().name, std::string(59, 'x'))
        << "no half letters";
    std::vector<OwnWindow> full;
    for (std::size_t i = 0; i < kMostOwnWindows; ++i) full.push_back(window(std::to_string(i)));
    EXPECT_EQ(withOwnWindow(full, window("more")).error().code, ErrorCode::usage);
    EXPECT_TRUE(withOwnWindow(full, window("3", 5.0)).ok());
}

// SUV was called by its unit of mass and volume once, and without saying of what: those windows are still
// there, and for nothing else.
TEST(OwnWindows, OfSuvAreFoundByEitherName) {
    const auto volumeIn = [](Unit unit, const std::string& name) {
        VolumeOptions options{.size = glm::ivec3(2), .unit = unit, .modality = "PT"};
        options.unitName = name;
        return Volume::create(std::move(options), std::vector<std::uint16_t>(8, 1000)).value();
    };
    const std::vector<OwnWindow> all{window("old", 5.0, "g/mL"), window("new", 5.0, "SUV bw"),
                                     window("later", 5.0, "SUV"), window("CT")};
    EXPECT_EQ(ownWindowsFor(all, volumeIn(Unit::suvBodyWeight, "")),
              (std::vector<OwnWindow>{all[0], all[1], all[2]}));
    EXPECT_EQ(ownWindowsFor(all, volumeIn(Unit::other, "g/mL")), (std::vector<OwnWindow>{all[0]}));
    EXPECT_TRUE(ownWindowsFor(all, volumeIn(Unit::becquerelsPerMillilitre, "")).empty());
}

TEST(OwnWindows, AreForValuesOfTheirUnit) {
    const auto volume = Volume::create({.size = glm::ivec3(2), .unit = Unit::hounsfield, .modality = "CT"},
                                       std::vector<std::uint16_t>(8, 1000));
    ASSERT_TRUE(volume.ok());
    EXPECT_EQ(ownWindowsFor({window("a"), window("b", 1.0, ""), window("c")}, *volume),
              (std::vector<OwnWindow>{window("a"), window("c")}));
}

}  // namespace
}  // namespace macula::scene

// What nobody chose, and yet shows something.
#include "presets/default_preset.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "presets/catalogue.h"
#include "presets/seen_values.h"

namespace macula::presets {
namespace {

// Three quarters of air, the rest of values from `low` on, evenly.
Volume volumeOf(Unit unit, const char* modality, int air, int low, int high) {
    std::vector<std::uint16_t> voxels(32'768);
    for (std::size_t n = 0; n < voxels.size(); ++n)
        voxels[n] = std::uint16_t(1024 + (n % 4 != 0 ? air : low + int(n / 4) % (high - low + 1)));
    auto made = Volume::create({.size = glm::ivec3(32),
                                .unitsFromStored = {.slope = 1.0, .intercept = -1024.0},
                                .unit = unit,
                                .modality = modality},
                               std::move(voxels));
    return *std::move(made);
}

bool isSeen(const Volume& volume, const std::string& name) {
    const auto all = *builtInPresets();
    const auto found = std::ranges::find(all, name, &TransferFunction::name);
    EXPECT_NE(found, all.end()) << name;
    return found != all.end() && SeenValues(volume).areSeenWith(*found);
}

TEST(DefaultTransfer, IsThatOfTheKindOfImages) {
    EXPECT_EQ(defaultTransfer(volumeOf(Unit::hounsfield, "CT", -1000, 0, 1200)), "cinematic-bone");
    EXPECT_EQ(defaultTransfer(volumeOf(Unit::raw, "MR", 0, 200, 900)), "cinematic-mr");
    for (const Unit unit : {Unit::suvBodyWeight, Unit::becquerelsPerMillilitre, Unit::raw})
        EXPECT_EQ(defaultTransfer(volumeOf(unit, "PT", 0, 200, 900)), "cinematic-pet");
    EXPECT_EQ(defaultTransfer(volumeOf(Unit::raw, "NM", 0, 200, 900)), "cinematic-pet");
}

// A knee in fat and water has no bone above the threshold when it is a phantom, a specimen or a soft part.
TEST(DefaultTransfer, NeverShowsNothingWhereAnotherShowsSomething) {
    struct Case {
        const char* what;
        Volume volume;
    };
    for (const Case& each : {Case{"soft tissue", volumeOf(Unit::hounsfield, "CT", -1000, 20, 60)},
                             Case{"fat", volumeOf(Unit::hounsfield, "CT", -1000, -120, -80)},
                             Case{"lung alone", volumeOf(Unit::hounsfield, "CT", -1000, -860, -800)}}) {
        const std::string name = defaultTransfer(each.volume);
        EXPECT_FALSE(isSeen(each.volume, "cinematic-bone")) << each.what;
        EXPECT_TRUE(isSeen(each.volume, name)) << each.what << ": " << name;
    }
}

TEST(DefaultTransfer, OfPaddingAloneIsSome) {
    auto made = Volume::create(
        {.size = glm::ivec3(2), .unit = Unit::hounsfield, .modality = "CT", .padding = StoredRange{0, 0}},
        std::vector<std::uint16_t>(8, 0));
    EXPECT_EQ(defaultTransfer(*made), "cinematic-bone");
    EXPECT_FALSE(isSeen(*made, "cinematic-bone"));
}

// Uptake is no skin: what is dark is blue, what is hot is yellow, and the background is not there.
TEST(CinematicPet, IsHotWhereUptakeIs) {
    const auto all = *builtInPresets();
    const auto pet = std::ranges::find(all, std::string("cinematic-pet"), &TransferFunction::name);
    ASSERT_NE(pet, all.end());
    EXPECT_EQ(opacityAt(*pet, 100.0), 0.0);
    EXPECT_LT(opacityAt(*pet, 300.0), 0.02);
    EXPECT_GT(opacityAt(*pet, 1000.0), 0.7);
    EXPECT_GT(colourAt(*pet, 250.0).b, colourAt(*pet, 250.0).r);
    EXPECT_GT(colourAt(*pet, 900.0).r, 2.0 * colourAt(*pet, 900.0).b);
}

}  // namespace
}  // namespace macula::presets

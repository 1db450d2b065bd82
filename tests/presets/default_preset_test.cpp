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

// Cubes of 96 mm in air: each of the values with a grain as of noise, or of trabeculae.
struct Part {
    int hu;
    int grainHu = 10;
};

Volume scanOf(const std::string& bodyPart, std::vector<Part> parts, const char* modality = "CT") {
    constexpr int kCube = 24;
    const int wide = kCube * std::max(int(parts.size()), 2);
    std::vector<std::uint16_t> voxels(std::size_t(wide) * kCube * kCube);
    for (std::size_t n = 0; n < voxels.size(); ++n) {
        const std::size_t part = n % std::size_t(wide) / kCube;
        const int grain = (n * 2654435761U >> 13 & 1U) != 0 ? 1 : -1;  // in step with no axis
        const int hu = part < parts.size() ? parts[part].hu + grain * parts[part].grainHu : -1000;
        voxels[n] = std::uint16_t(1024 + hu);
    }
    glm::dmat4 worldFromVoxel(4.0);
    worldFromVoxel[3][3] = 1.0;
    const bool isMr = std::string_view(modality) == "MR";
    auto made = Volume::create({.size = {wide, kCube, kCube},
                                .worldFromVoxel = worldFromVoxel,
                                .unitsFromStored = {.slope = 1.0, .intercept = -1024.0},
                                .unit = isMr ? Unit::raw : Unit::hounsfield,
                                .modality = modality,
                                .bodyPart = bodyPart},
                               std::move(voxels));
    return *std::move(made);
}

constexpr Part kAir{-1000, 0};
constexpr Part kLung{-800};
constexpr Part kMuscle{60};
constexpr Part kLiverWithAgent{115};
constexpr Part kBloodWithAgent{320};
constexpr Part kTrabeculae{260, 90};
constexpr Part kCortex{1100, 200};

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

TEST(DefaultTransfer, IsThatOfTheBodyPart) {
    struct Case {
        std::vector<const char*> said;
        std::vector<Part> parts;
        std::string expected;
    };
    const std::vector<Case> cases{
        {{"HEAD", "Brain", "SKULL", "HEADNECK", "HEAD_NECK", "PARANASAL SINUS", "EAR", "FACIAL BONES"},
         {kAir, kMuscle, kCortex},
         "cinematic-head"},
        {{"JAW", "MANDIBLE", "DENTAL"}, {kAir, kMuscle, kCortex}, "cinematic-dental"},
        {{"HEART", "CORONARY", "Coronaries", "CARDIAC"},
         {kLung, kMuscle, kBloodWithAgent, kCortex},
         "cinematic-heart"},
        {{"NECK", "CTA", "AORTA", "CAROTID", "ANGIO LEG"},
         {kAir, kMuscle, kBloodWithAgent, kCortex},
         "cinematic-vessels"},
        {{"ABDOMEN", "LIVER", "ABDOMEN_PELVIS", "AbdomenPelvis", "KIDNEY"},
         {kAir, kMuscle, kLiverWithAgent, kCortex},
         "cinematic-abdomen"},
        {{"EXTREMITY", "KNEE", "foot", "HAND", "HIP", "LSPINE", "C SPINE", "PELVIS", "SHOULDER"},
         {kAir, kMuscle, kBloodWithAgent, kCortex},
         "cinematic-bone"},
        {{"CHEST", "THORAX", "CHEST_ABD_PELVIS", "WHOLEBODY", "", "?", "TSHIRT"},
         {kLung, kMuscle, kBloodWithAgent, kCortex},
         "cinematic-chest"},
    };
    for (const Case& each : cases)
        for (const char* said : each.said)
            EXPECT_EQ(defaultTransfer(scanOf(said, each.parts)), each.expected) << said;
    const std::vector<Part> head{{-1000, 0}, {200}, {500}, {800}};
    EXPECT_EQ(defaultTransfer(scanOf("KNEE", head, "MR")), "cinematic-mr-knee");
    for (const char* said : {"", "HEAD", "BRAIN", "ABDOMEN", "FOOT"})
        EXPECT_EQ(defaultTransfer(scanOf(said, head, "MR")), "cinematic-mr") << said;
}

// What the tag says is of the protocol: what is there comes before it.
TEST(DefaultTransfer, DoesNotTrustTheBodyPart) {
    const std::vector<Part> chest{kLung, kMuscle, kTrabeculae, kCortex};
    for (const char* said :
         {"HEAD", "JAW", "HEART", "NECK", "ABDOMEN", "PELVIS", "KNEE", "ARM", "INCIDENTAL"})
        EXPECT_EQ(defaultTransfer(scanOf(said, chest)), "cinematic-chest") << said;
    EXPECT_EQ(defaultTransfer(scanOf("TSPINE", chest)), "cinematic-bone");
    const std::vector<Part> withoutAgent{kAir, kMuscle, kTrabeculae, kCortex};
    for (const char* said : {"HEART", "NECK", "ABDOMEN", "CTA"})
        EXPECT_EQ(defaultTransfer(scanOf(said, withoutAgent)), "cinematic-bone") << said;
    for (const char* said : {"HEAD", "JAW", "SPINE", "KNEE", "LIVER"}) {
        const Volume soft = scanOf(said, {kAir, kMuscle, {-100}});
        const std::string name = defaultTransfer(soft);
        EXPECT_TRUE(isSeen(soft, name)) << said << ": " << name;
    }
}

// CT whose numbers are no Hounsfield units.
TEST(DefaultTransfer, OfMicroCtIsItsOwn) {
    EXPECT_EQ(defaultTransfer(volumeOf(Unit::raw, "CT", 0, 200, 20'000)), "cinematic-micro-ct");
    EXPECT_EQ(defaultTransfer(volumeOf(Unit::raw, "", 0, 200, 900)), "cinematic-mr");
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

// Small pictures of a volume under a preset, on the host.
#include "pictures/preset_thumbnail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "base/phantom.h"
#include "scene/choice/catalogue.h"

namespace macula::pictures {
namespace {

std::shared_ptr<const Volume> volumeOf(const glm::ivec3& size, const glm::dvec3& spacingMm,
                                       const std::function<std::uint16_t(int, int, int)>& stored) {
    std::vector<std::uint16_t> voxels;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) voxels.push_back(stored(i, j, k));
    auto volume = Volume::create({.size = size,
                                  .worldFromVoxel = affine({spacingMm.x, 0, 0}, {0, spacingMm.y, 0},
                                                           {0, 0, spacingMm.z}, glm::dvec3(0.0)),
                                  .unitsFromStored = {.slope = 1.0, .intercept = -1000.0},
                                  .unit = Unit::hounsfield,
                                  .modality = "CT"},
                                 std::move(voxels));
    EXPECT_TRUE(volume.ok());
    return std::make_shared<const Volume>(*std::move(volume));
}

// Opaque and of one colour above a value, without shading.
TransferFunction dense(double fromHu, const glm::dvec3& colour) {
    TransferFunction function{.name = "dense", .title = "Dense"};
    function.opacity = {{.value = fromHu, .opacity = 0.0}, {.value = fromHu + 1.0, .opacity = 1.0}};
    function.colour = {{.value = 0.0, .colour = colour}};
    function.lighting.shade = false;
    return function;
}

std::shared_ptr<const CoarseVolume> coarseOf(std::shared_ptr<const Volume> volume) {
    auto coarse = CoarseVolume::of(std::move(volume));
    EXPECT_TRUE(coarse.ok()) << (coarse ? "" : coarse.error().message.english());
    return *coarse;
}

// The sum of all channels of a quarter of the picture.
long brightness(const PresetThumbnail& picture, bool right, bool low) {
    long sum = 0;
    const int half = picture.sizePx / 2;
    for (int y = low ? half : 0; y < (low ? picture.sizePx : half); ++y)
        for (int x = right ? half : 0; x < (right ? picture.sizePx : half); ++x)
            for (int c = 0; c < 3; ++c) sum += picture.rgba[std::size_t(4 * (y * picture.sizePx + x) + c)];
    return sum;
}
long brightness(const PresetThumbnail& picture) {
    return brightness(picture, false, false) + brightness(picture, true, false) +
           brightness(picture, false, true) + brightness(picture, true, true);
}

TEST(PresetThumbnail, ThePatientsLeftIsAtTheRightAndSuperiorIsUp) {
    // A block at the patient's left (+x) and superior (+z).
    const auto volume = volumeOf({32, 32, 32}, glm::dvec3(2.0), [](int i, int j, int k) {
        return std::uint16_t(i > 20 && j > 8 && j < 24 && k > 20 ? 2000 : 0);
    });
    const auto made = presetThumbnail(*coarseOf(volume), dense(500.0, {1.0, 1.0, 1.0}));
    ASSERT_TRUE(made.ok()) << made.error().message;
    ASSERT_EQ(made->sizePx, kPresetThumbnailPx);
    ASSERT_EQ(made->rgba.size(), std::size_t(4 * made->sizePx * made->sizePx));
    EXPECT_GT(brightness(*made, true, false), 10'000);
    EXPECT_EQ(brightness(*made, false, false), 0);
    EXPECT_EQ(brightness(*made, false, true), 0);
    EXPECT_EQ(brightness(*made, true, true), 0);
}

// From the front a slab of an eighth of its width would be a band of an eighth of the rows.
TEST(PresetThumbnail, AShortScanIsNoBand) {
    const auto slab = volumeOf({32, 32, 4}, glm::dvec3(2.0), [](int, int, int) { return 2000; });
    const auto made = presetThumbnail(*coarseOf(slab), dense(500.0, {1.0, 1.0, 1.0}));
    ASSERT_TRUE(made.ok()) << made.error().message;
    int rows = 0;
    for (int y = 0; y < made->sizePx; ++y) {
        bool isSeen = false;
        for (int x = 0; x < made->sizePx; ++x)
            isSeen |= made->rgba[std::size_t(4 * (y * made->sizePx + x))] > 128;
        rows += isSeen ? 1 : 0;
    }
    EXPECT_GT(rows, 2 * made->sizePx / 5);
}

TEST(PresetThumbnail, ColourIsThatOfThePresetAndOpaque) {
    const auto volume = volumeOf({24, 24, 24}, glm::dvec3(5.0), [](int, int, int) { return 2000; });
    const auto made = presetThumbnail(*coarseOf(volume), dense(500.0, {0.8, 0.4, 0.2}));
    ASSERT_TRUE(made.ok());
    const std::size_t middle = std::size_t(4 * (made->sizePx / 2 * made->sizePx + made->sizePx / 2));
    // An opacity of 1 is 0.999 for each mm: of 120 mm nothing comes through.
    EXPECT_NEAR(made->rgba[middle], 0.8 * 255, 2);
    EXPECT_NEAR(made->rgba[middle + 1], 0.4 * 255, 2);
    EXPECT_NEAR(made->rgba[middle + 2], 0.2 * 255, 2);
    EXPECT_EQ(made->rgba[middle + 3], 255);
}

// A block that ends within a cell: it is steep from outside. A mist that is the same everywhere never is.
TEST(PresetThumbnail, SteepMatterHasItsOwnColour) {
    TransferFunction function = dense(500.0, {1.0, 0.0, 0.0});
    function.steep = {.opacity = function.opacity,
                      .colour = {{.value = 0.0, .colour = {0.0, 0.0, 1.0}}},
                      .gradientPerMm = 100.0};
    const auto middleOf = [&](const std::shared_ptr<const Volume>& volume) {
        const auto made = presetThumbnail(*coarseOf(volume), function);
        EXPECT_TRUE(made.ok());
        const std::size_t middle = std::size_t(4 * (made->sizePx / 2 * made->sizePx + made->sizePx / 2));
        return glm::ivec3(made->rgba[middle], made->rgba[middle + 1], made->rgba[middle + 2]);
    };
    const auto block = volumeOf({32, 32, 32}, glm::dvec3(2.0), [](int i, int j, int k) {
        const bool isInside = std::min({i, j, k}) > 8 && std::max({i, j, k}) < 24;
        return std::uint16_t(isInside ? 3000 : 0);
    });
    const glm::ivec3 edge = middleOf(block);
    EXPECT_GT(edge.z, 200);
    EXPECT_LT(edge.x, 100);
    const auto even = volumeOf({24, 24, 24}, glm::dvec3(5.0), [](int, int, int) { return 2000; });
    EXPECT_EQ(middleOf(even), glm::ivec3(255, 0, 0));
}

TEST(PresetThumbnail, AbsorbsAsItsLayerSays) {
    // Half of the light goes through 1 mm, and the slab is 1 mm thick along the view and much larger across.
    const auto volume = volumeOf({200, 1, 200}, glm::dvec3(1.0), [](int, int, int) { return 2000; });
    TransferFunction half = dense(500.0, {1.0, 1.0, 1.0});
    half.opacity = {{.value = 0.0, .opacity = 0.5}};
    const auto made = presetThumbnail(*coarseOf(volume), half);
    ASSERT_TRUE(made.ok());
    const std::size_t middle = std::size_t(4 * (made->sizePx / 2 * made->sizePx + made->sizePx / 2));
    const auto encoded = [](double linear) { return 255.0 * (1.055 * std::pow(linear, 1.0 / 2.4) - 0.055); };
    EXPECT_NEAR(made->rgba[middle], encoded(0.5), 2.0);
}

TEST(PresetThumbnail, ShadingDarkensWhatIsSeenAtAnAngle) {
    const auto ball = volumeOf({48, 48, 48}, glm::dvec3(4.0), [](int i, int j, int k) {
        return std::uint16_t(glm::distance(glm::dvec3(i, j, k), glm::dvec3(23.5)) < 20.0 ? 2000 : 0);
    });
    TransferFunction plain = dense(500.0, {1.0, 1.0, 1.0});
    TransferFunction lit = plain;
    lit.lighting = {.shade = true, .ambient = 0.1, .diffuse = 0.9};
    const auto coarse = coarseOf(ball);
    const auto without = presetThumbnail(*coarse, plain);
    const auto with = presetThumbnail(*coarse, lit);
    ASSERT_TRUE(without.ok() && with.ok());
    EXPECT_LT(brightness(*with), 0.97 * double(brightness(*without)));
    const std::size_t middle = std::size_t(4 * (with->sizePx / 2 * with->sizePx + with->sizePx / 2));
    EXPECT_GT(with->rgba[middle], 235) << "the middle of the ball looks at the eye";
}

TEST(PresetThumbnail, AClipHidesItsPart) {
    const auto volume = volumeOf({32, 32, 32}, glm::dvec3(2.0), [](int, int, int) { return 2000; });
    const auto coarse = coarseOf(volume);
    Clip left;  // keeps the patient's left
    left.planes = {{.normal = {1.0, 0.0, 0.0}, .offsetMm = 31.0}};
    const auto made = presetThumbnail(*coarse, dense(500.0, {1.0, 1.0, 1.0}), &left);
    ASSERT_TRUE(made.ok());
    EXPECT_GT(brightness(*made, true, true), 100'000);
    EXPECT_LT(brightness(*made, false, true), brightness(*made, true, true) / 10);
}

TEST(PresetThumbnail, APresetThatIsFittedIsStretchedToTheVolume) {
    const scene::Catalogue catalogue = *scene::builtInCatalogue();
    const TransferFunction& mr = **scene::findPreset(catalogue, "cinematic-mr");
    // Two scanners: one has values 100 times those of the other.
    const auto picture = [&](double slope) {
        std::vector<std::uint16_t> voxels;
        for (int k = 0; k < 20; ++k)
            for (int j = 0; j < 20; ++j)
                for (int i = 0; i < 20; ++i)
                    voxels.push_back(std::uint16_t(
                        i > 3 && i < 16 && j > 3 && j < 16 && k > 3 && k < 16 ? 400 + 10 * i : 2));
        auto volume = Volume::create({.size = glm::ivec3(20),
                                      .unitsFromStored = {.slope = slope},
                                      .unit = Unit::raw,
                                      .modality = "MR"},
                                     std::move(voxels));
        return presetThumbnail(*coarseOf(std::make_shared<const Volume>(*std::move(volume))), mr)->rgba;
    };
    const auto one = picture(1.0);
    EXPECT_GT(std::ranges::count_if(one, [](int byte) { return byte > 20 && byte < 255; }), 1000);
    const auto other = picture(100.0);
    double difference = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i) difference += std::abs(int(one[i]) - int(other[i]));
    EXPECT_LT(difference / double(one.size()), 1.0);
}

TEST(PresetThumbnail, EveryBuiltInPresetDrawsAndTheyDiffer) {
    const auto coarse = coarseOf(
        std::make_shared<const Volume>(phantom::make({.size = {48, 42, 30}, .spacingMm = {6.4, 6.4, 10.0}})));
    const scene::Catalogue catalogue = *scene::builtInCatalogue();
    std::set<std::vector<std::uint8_t>> different;
    for (const auto& preset : catalogue.presets) {
        const auto made = presetThumbnail(*coarse, *preset, nullptr, {}, 24);
        ASSERT_TRUE(made.ok()) << preset->name << ": " << made.error().message;
        different.insert(made->rgba);
    }
    EXPECT_GT(different.size(), catalogue.presets.size() / 2);
}

TEST(PresetThumbnail, TheCoarseVolumeHasTheShapeAndMeanOfTheFineOne) {
    const auto volume = volumeOf({192, 96, 7}, {1.0, 1.0, 20.0},
                                 [](int i, int, int) { return std::uint16_t(i < 96 ? 1000 : 3000); });
    const auto coarse = coarseOf(volume);
    EXPECT_LE(std::max({coarse->size().x, coarse->size().y, coarse->size().z}), kLongestCoarseSide);
    EXPECT_EQ(coarse->size().z, 7) << "there are no more cells than voxels";
    const auto at = [&](const glm::dvec3& mm) {
        return coarse->valueAt(transformPoint(coarse->cellFromWorld(), mm));
    };
    EXPECT_NEAR(at({40.0, 50.0, 60.0}), 0.0, 1e-3);
    EXPECT_NEAR(at({160.0, 50.0, 60.0}), 2000.0, 1e-3);
    EXPECT_NEAR(at({95.5, 50.0, 60.0}), 1000.0, 1e-3) << "the border stays where it is";
    EXPECT_NEAR(at({1e6, 50.0, 60.0}), 2000.0, 1e-3);
}

TEST(PresetThumbnail, OneVoxelAndNoVoxelAtAll) {
    const auto one = volumeOf(glm::ivec3(1), glm::dvec3(3.0), [](int, int, int) { return 2000; });
    const auto made = presetThumbnail(*coarseOf(one), dense(500.0, {1.0, 1.0, 1.0}));
    ASSERT_TRUE(made.ok());
    EXPECT_GT(brightness(*made), 0);

    auto padding = Volume::create({.size = glm::ivec3(4), .padding = StoredRange{5, 5}},
                                  std::vector<std::uint16_t>(64, 5));
    const auto nothing = CoarseVolume::of(std::make_shared<const Volume>(*std::move(padding)));
    ASSERT_FALSE(nothing.ok());
    EXPECT_EQ(nothing.error().code, ErrorCode::inputNotUsable);
}

TEST(PresetThumbnail, NotANumberIsPaddingAndStaysClear) {
    std::vector<float> voxels(1000, std::numeric_limits<float>::quiet_NaN());
    voxels[555] = 1e20f;
    voxels[556] = -3.0f;
    auto volume = Volume::createFloat({.size = glm::ivec3(10), .unit = Unit::raw, .modality = "MR"}, voxels);
    ASSERT_TRUE(volume.ok());
    const auto coarse = coarseOf(std::make_shared<const Volume>(*std::move(volume)));
    const auto made = presetThumbnail(*coarse, dense(1e19, {1.0, 1.0, 1.0}));
    ASSERT_TRUE(made.ok());
    EXPECT_GT(brightness(*made), 0);
    EXPECT_EQ(brightness(*presetThumbnail(*coarse, dense(2e20, {1.0, 1.0, 1.0}))), 0);
}

TEST(PresetThumbnail, WhatCannotBeDrawnIsAnErrorAndCancellingStops) {
    const auto volume = volumeOf(glm::ivec3(8), glm::dvec3(1.0), [](int, int, int) { return 2000; });
    const auto coarse = coarseOf(volume);
    TransferFunction empty;
    EXPECT_EQ(presetThumbnail(*coarse, empty).error().code, ErrorCode::inputNotUsable);
    CancelToken token;
    token.cancel();
    EXPECT_EQ(presetThumbnail(*coarse, dense(0.0, {1, 1, 1}), nullptr, token).error().code,
              ErrorCode::cancelled);
    EXPECT_EQ(CoarseVolume::of(volume, token).error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace macula::pictures

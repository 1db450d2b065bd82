// What is pointed at: found where it is, and not behind what hides it.
#include "scene/drawing/first_matter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace macula::scene {
namespace {

constexpr int kSide = 40;
constexpr double kVoxelMm = 2.0;

// Air, with a ball of 1000 HU of 10 voxels' radius in the middle, and a grain of 3000 HU behind it.
std::shared_ptr<const Volume> ball() {
    std::vector<std::uint16_t> voxels;
    for (int k = 0; k < kSide; ++k) {
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i) {
                const glm::dvec3 from = glm::dvec3(i, j, k) - 19.5;
                const bool isGrain = i >= 19 && i <= 20 && k >= 19 && k <= 20 && j >= 34 && j <= 36;
                voxels.push_back(isGrain ? 4024 : glm::length(from) < 10.0 ? 2024 : 24);
            }
        }
    }
    glm::dmat4 worldFromVoxel =
        affine({kVoxelMm, 0, 0}, {0, kVoxelMm, 0}, {0, 0, kVoxelMm}, glm::dvec3(-39.0));
    return std::make_shared<const Volume>(*Volume::create({.size = glm::ivec3(kSide),
                                                           .worldFromVoxel = worldFromVoxel,
                                                           .unitsFromStored = {1.0, -1024.0},
                                                           .unit = Unit::hounsfield,
                                                           .modality = "CT"},
                                                          std::move(voxels)));
}

Drawing drawing(trace::Look look = trace::Look::cinematic, double opacity = 0.9) {
    Drawing drawn;
    drawn.transferFunction = std::make_shared<const TransferFunction>(TransferFunction{
        .name = "bone", .opacity = {{200, 0.0}, {400, opacity}}, .colour = {{0, glm::dvec3(1.0)}}});
    drawn.settings.look = look;
    return drawn;
}

const Camera kFront{
    .positionMm = {0, -500, 0}, .targetMm = {0, 0, 0}, .up = {0, 0, 1}, .verticalFovDeg = 30.0};

// The ball ends within a voxel, 250 HU per mm and more; inside nothing is steep.
TEST(FirstMatter, IsSteepMatterWhereThatAloneIsSeenAndFlatMatterWhereThatIs) {
    const auto volume = ball();
    Drawing drawn = drawing();
    TransferFunction function = *drawn.transferFunction;
    function.steep = {.opacity = {{0, 0.0}}, .colour = function.colour, .gradientPerMm = 10.0};
    drawn.transferFunction = std::make_shared<const TransferFunction>(function);
    const auto flat = firstMatterMm(*volume, drawn, kFront, {0, 0}, 1.0);
    ASSERT_TRUE(flat);
    EXPECT_GT(flat->y, -19.5);
    EXPECT_LT(flat->y, -15.0) << "beyond the shell, which cannot be seen";
    drawn.transferFunction = std::make_shared<const TransferFunction>(withCurvesSwapped(function));
    const auto steep = firstMatterMm(*volume, drawn, kFront, {0, 0}, 1.0);
    ASSERT_TRUE(steep);
    EXPECT_NEAR(steep->y, -20.0, kVoxelMm);
    EXPECT_LT(steep->y, flat->y);
}

TEST(FirstMatter, IsTheSurfaceThatTheEyeMeets) {
    const auto volume = ball();
    const auto found = firstMatterMm(*volume, drawing(), kFront, {0, 0}, 1.0);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->x, 0.0, 1e-6);
    EXPECT_NEAR(found->y, -20.0, kVoxelMm);
    EXPECT_NEAR(found->z, 0.0, 1e-6);
    // From the other side the grain lies before the ball.
    Camera behind = kFront;
    behind.positionMm.y = 500;
    const auto grain = firstMatterMm(*volume, drawing(), behind, {0, 0}, 1.0);
    ASSERT_TRUE(grain);
    EXPECT_NEAR(grain->y, 2.0 * 36.5 - 39.0, kVoxelMm);
}

// However voxels are kept, it is the same place; and padding, NaN or what the file calls so, is no matter.
TEST(FirstMatter, IsTheSameInVoxelsOfFloats) {
    const auto stored = ball();
    std::vector<float> values;
    for (int k = 0; k < kSide; ++k) {
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i) values.push_back(float(stored->value(i, j, k)));
        }
    }
    for (int i = 0; i < kSide; ++i) values[std::size_t(i)] = std::numeric_limits<float>::quiet_NaN();
    const auto floats = Volume::createFloat({.size = glm::ivec3(kSide),
                                             .worldFromVoxel = stored->worldFromVoxel(),
                                             .unit = Unit::hounsfield,
                                             .modality = "CT"},
                                            std::move(values));
    ASSERT_TRUE(floats.ok());
    const auto found = firstMatterMm(*stored, drawing(), kFront, {0.01, 0.02}, 1.0);
    const auto same = firstMatterMm(*floats, drawing(), kFront, {0.01, 0.02}, 1.0);
    ASSERT_TRUE(found && same);
    EXPECT_LT(glm::distance(*found, *same), 1e-9);
    // From below the ray goes in through the row of padding.
    Camera low = kFront;
    low.positionMm = {0, -39, -500};
    low.targetMm = {0, -39, 0};
    low.up = {0, 1, 0};
    EXPECT_FALSE(firstMatterMm(*floats, drawing(), low, {0, 0}, 1.0));
}

// A second volume in the picture is matter too: here the same ball, 12 mm nearer to the eye by a
// registration.
TEST(FirstMatter, IsOfTheSecondVolumeWhereThatIsMetFirst) {
    const auto volume = ball();
    Additions added;
    added.second.emplace();
    added.second->volume = volume;
    added.second->function = drawing().transferFunction;
    added.second->secondFromVolumeMm[3].y = 12.0;
    Drawing both = drawing();
    both.additions = std::make_shared<const Additions>(added);
    const auto found = firstMatterMm(*volume, both, kFront, {0, 0}, 1.0);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->y, -32.0, kVoxelMm);
    // Of a segment that is thinned to nothing nothing is left to be pointed at.
    auto box = std::make_shared<TintBox>();
    box->volumeSize = box->size = volume->size();
    box->voxels.assign(volume->voxelCount(), 1);
    Additions hidden;
    hidden.tints = SegmentTints{box, {{.rgb = {1.0f, 0.0f, 0.0f}, .opacity = 0.0f}}};
    both.additions = std::make_shared<const Additions>(hidden);
    EXPECT_FALSE(firstMatterMm(*volume, both, kFront, {0, 0}, 1.0));
}

// The patient's left is right in a picture from the front, and up is the head.
TEST(FirstMatter, RightAndUpAreThoseOfThePicture) {
    const auto volume = ball();
    const double place = 15.0 / (480.0 * std::tan(glm::radians(15.0)));
    const auto found = firstMatterMm(*volume, drawing(), kFront, {place, 0.5 * place}, 1.0);
    ASSERT_TRUE(found);
    EXPECT_GT(found->x, 12.0);
    EXPECT_NEAR(found->z, 0.5 * found->x, 0.5);
}

// The ray of a parallel picture through a place is straight: so many mm beside the middle, at every depth.
TEST(FirstMatter, OfParallelRaysIsStraightAhead) {
    const auto volume = ball();
    Camera parallel = kFront;
    parallel.parallelHeightMm = 60;
    const auto found = firstMatterMm(*volume, drawing(), parallel, {0.2, 0.2}, 1.5);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->x, 0.2 * 45, 1e-6);
    EXPECT_NEAR(found->z, 0.2 * 30, 1e-6);
    EXPECT_NEAR(found->y, -std::sqrt(400.0 - 81.0 - 36.0), 2.0 * kVoxelMm);
    // Rays begin before all of the volume, wherever the camera stands.
    parallel.positionMm = {0, 35, 0};
    parallel.targetMm = {0, 36, 0};
    const auto again = firstMatterMm(*volume, drawing(), parallel, {0.2, 0.2}, 1.5);
    ASSERT_TRUE(again);
    EXPECT_NEAR(again->y, found->y, 1.0);
    EXPECT_FALSE(firstMatterMm(*volume, drawing(), parallel, {0.99, 0.99}, 1.5));
}

TEST(FirstMatter, NothingIsFoundWhereNothingIsSeen) {
    const auto volume = ball();
    EXPECT_FALSE(firstMatterMm(*volume, drawing(), kFront, {0.9, 0.9}, 1.0));
    EXPECT_FALSE(firstMatterMm(*volume, drawing(trace::Look::cinematic, 1e-5), kFront, {0, 0}, 1.0));
    EXPECT_FALSE(firstMatterMm(*volume, drawing(trace::Look::average), kFront, {0, 0}, 1.0));
    Camera away = kFront;
    away.targetMm = {0, -1000, 0};
    EXPECT_FALSE(firstMatterMm(*volume, drawing(), away, {0, 0}, 1.0));
}

TEST(FirstMatter, WhatAClipHidesIsNotPointedAt) {
    const auto volume = ball();
    Drawing cut = drawing();
    Clip clip;
    clip.planes = {{.normal = {0, 1, 0}, .offsetMm = 0.0}};  // the front half goes
    cut.clip = std::make_shared<const Clip>(clip);
    const auto found = firstMatterMm(*volume, cut, kFront, {0, 0}, 1.0);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->y, 0.0, kVoxelMm);
    clip.ball = Ball{.centreMm = glm::dvec3(0.0), .radiusMm = 30.0};
    clip.ofBall = Keep::outside;
    cut.clip = std::make_shared<const Clip>(clip);
    const auto grain = firstMatterMm(*volume, cut, kFront, {0, 0}, 1.0);
    ASSERT_TRUE(grain);
    EXPECT_NEAR(grain->y, 30.0, kVoxelMm) << "where the ball ends, within the grain";
}

TEST(FirstMatter, AProjectionShowsTheLargestOrTheSmallestValue) {
    const auto volume = ball();
    const auto largest = firstMatterMm(*volume, drawing(trace::Look::mip), kFront, {0, 0}, 1.0);
    ASSERT_TRUE(largest);
    EXPECT_NEAR(largest->y, 2.0 * 35.0 - 39.0, 2.0 * kVoxelMm);  // the grain, behind the ball
    const auto smallest = firstMatterMm(*volume, drawing(trace::Look::minip), kFront, {0, 0}, 1.0);
    ASSERT_TRUE(smallest);
    EXPECT_LT(smallest->y, -20.0 + kVoxelMm);
}

TEST(FirstMatter, ACameraThatIsNoneFindsNothing) {
    const auto volume = ball();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Camera wrong = kFront;
    wrong.positionMm.x = nan;
    EXPECT_FALSE(firstMatterMm(*volume, drawing(), wrong, {0, 0}, 1.0));
    EXPECT_FALSE(firstMatterMm(*volume, drawing(), kFront, {nan, 0}, 1.0));
    EXPECT_FALSE(firstMatterMm(*volume, drawing(), kFront, {0, 0}, nan));
    Drawing nothing;
    EXPECT_FALSE(firstMatterMm(*volume, nothing, kFront, {0, 0}, 1.0));
    // From within: what is behind the eye is not in its way.
    Camera within = kFront;
    within.positionMm = {0, 25, 0};
    within.targetMm = {0, 30, 0};
    const auto found = firstMatterMm(*volume, drawing(), within, {0, 0}, 1.0);
    ASSERT_TRUE(found);
    EXPECT_GT(found->y, 25.0);
}

}  // namespace
}  // namespace macula::scene

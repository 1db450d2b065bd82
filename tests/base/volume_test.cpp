#include <gtest/gtest.h>

#include <limits>

#include "base/volume.h"

namespace macula {
namespace {

VolumeOptions ctOptions(glm::ivec3 size) {
    return {.size = size,
            .worldFromVoxel = affine({2, 0, 0}, {0, 3, 0}, {0, 1, 4}, {10, 20, 30}),
            .unitsFromStored = {.slope = 1.0, .intercept = -1024.0},
            .unit = Unit::hounsfield,
            .modality = "CT",
            .padding = StoredRange{0, 5},
            .provenance = {}};
}

TEST(Volume, RangeLeavesPaddingOut) {
    const auto volume = Volume::create(ctOptions({2, 2, 1}), {0, 24, 5, 2000});
    ASSERT_TRUE(volume.ok());
    EXPECT_EQ(volume->storedRange().low, 24);
    EXPECT_EQ(volume->storedRange().high, 2000);
    EXPECT_EQ(volume->value(1, 0, 0), -1000.0);
    EXPECT_EQ(volume->airStored(), 24);
}

TEST(Volume, AllPaddingHasAnEmptyRange) {
    const auto volume = Volume::create(ctOptions({2, 1, 1}), {1, 2});
    ASSERT_TRUE(volume.ok());
    EXPECT_EQ(volume->storedRange().high, 0);
}

TEST(Volume, WorldBoxOfAShearedGridReachesHalfAVoxelBeyondTheCentres) {
    const auto volume = Volume::create(ctOptions({1, 1, 2}), {100, 100});
    ASSERT_TRUE(volume.ok());
    const Box box = volume->worldBox();
    EXPECT_EQ(box.low, glm::dvec3(9.0, 20 - 1.5 - 0.5, 28));
    EXPECT_EQ(box.high, glm::dvec3(11.0, 20 + 1.5 + 1.5, 36));
}

TEST(Volume, RefusesWhatIsNoVolume) {
    EXPECT_FALSE(Volume::create(ctOptions({0, 1, 1}), {}).ok());
    EXPECT_FALSE(Volume::create(ctOptions({2, 2, 2}), {1, 2, 3}).ok());
    auto flat = ctOptions({1, 1, 1});
    flat.worldFromVoxel = affine({1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, 0});
    EXPECT_FALSE(Volume::create(flat, {1}).ok());
    auto notFinite = ctOptions({1, 1, 1});
    notFinite.worldFromVoxel[3][0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(Volume::create(notFinite, {1}).ok());
    auto slope = ctOptions({1, 1, 1});
    slope.unitsFromStored.slope = 0.0;
    EXPECT_FALSE(Volume::create(slope, {1}).ok());
}

TEST(Frames, LettersAreThoseOfThePatientDirection) {
    EXPECT_EQ(orientationLetters({1, 0, 0}), "L");
    EXPECT_EQ(orientationLetters({0, -0.9, 0.4}), "AS");
    EXPECT_EQ(orientationLetters({-0.2, 0.1, -0.97}), "IRP");
}

TEST(Frames, TinyButProperVoxelsAreInvertible) {
    EXPECT_TRUE(isInvertibleAffine(affine({1e-5, 0, 0}, {0, 1e-5, 0}, {0, 0, 50}, {1e5, 1e5, 1e5})));
}

}  // namespace
}  // namespace macula

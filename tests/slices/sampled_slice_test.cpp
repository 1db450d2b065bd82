// Pictures against values taken the plain way, voxels against themselves, and the sides of the patient.
#include "slices/sampled_slice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/worst.h"
#include "made_volumes.h"

namespace macula::slices::test {
namespace {

using macula::test::worse;

std::vector<Volume> volumesOf(const glm::ivec3& size, const glm::dmat4& worldFromVoxel) {
    std::vector<Volume> volumes;
    for (const Padding padding : {Padding::none, Padding::some}) {
        volumes.push_back(storedVolume(size, worldFromVoxel, padding));
        volumes.push_back(floatVolume(size, worldFromVoxel, padding));
    }
    return volumes;
}

float pixel(const SampledSlice& slice, int x, int y) {
    return slice.values[std::size_t(y) * std::size_t(slice.sizePx.x) + std::size_t(x)];
}

// A picture of which every pixel is compared, but for those where rounding decides.
struct Comparison {
    double worst = 0.0;
    int values = 0;
    int nothing = 0;
    int different = 0;  // a value on one side, none on the other

    template <class Expected>
    void add(const Volume& volume, const SliceFrame& frame, const SampledSlice& slice,
             const Expected& expected) {
        ASSERT_EQ(slice.sizePx, frame.sizePx);
        for (int y = 0; y < frame.sizePx.y; ++y) {
            for (int x = 0; x < frame.sizePx.x; ++x) {
                const glm::dvec3 mm = frame.worldFromPicture({x + 0.5, y + 0.5});
                if (isAtJump(volume, mm)) continue;
                const double wanted = expected(mm);
                const double found = pixel(slice, x, y);
                if (std::isnan(wanted) != std::isnan(found)) {
                    ++different;
                } else if (std::isnan(wanted)) {
                    ++nothing;
                } else {
                    ++values;
                    worst = worse(worst, std::abs(wanted - found));
                }
            }
        }
    }
};

SliceFrame randomFrame(const Volume& volume, Random& random) {
    const glm::ivec2 size{61, 47};
    const double scale = volume.worldBox().diagonal() / size.x * uniform(random, 0.5, 1.2);
    return {.plane = randomPlane(randomPointMm(volume, random), random), .mmPerPixel = scale, .sizePx = size};
}

TEST(SampledSlice, IsLinearBetweenVoxelsAndLeavesPaddingOut) {
    Random random(1);
    for (const Pose& pose : poses()) {
        SCOPED_TRACE(pose.name);
        for (const Volume& volume : volumesOf({9, 11, 7}, pose.worldFromVoxel)) {
            Comparison compared;
            for (int n = 0; n < 5; ++n) {
                const SliceFrame frame = randomFrame(volume, random);
                compared.add(volume, frame, sampleSlice(volume, frame, {}, Filter::linear),
                             [&](const glm::dvec3& mm) { return valueAt(volume, mm); });
            }
            EXPECT_LT(compared.worst, 0.02);
            EXPECT_EQ(compared.different, 0);
            EXPECT_GT(compared.values, 200);
            EXPECT_GT(compared.nothing, 100);
        }
    }
}

TEST(SampledSlice, NearestIsWhatTheProbeSays) {
    Random random(2);
    for (const Pose& pose : poses()) {
        SCOPED_TRACE(pose.name);
        for (const Volume& volume : volumesOf({9, 11, 7}, pose.worldFromVoxel)) {
            Comparison compared;
            for (int n = 0; n < 5; ++n) {
                const SliceFrame frame = randomFrame(volume, random);
                compared.add(volume, frame, sampleSlice(volume, frame, {}, Filter::nearest),
                             [&](const glm::dvec3& mm) {
                                 const auto found = probe(volume, mm);
                                 return found && !found->isPadding ? double(float(found->value))
                                                                   : std::nan("");
                             });
            }
            EXPECT_EQ(compared.worst, 0.0);
            EXPECT_EQ(compared.different, 0);
            EXPECT_GT(compared.values, 200);
            EXPECT_GT(compared.nothing, 100);
        }
    }
}

// Not nearly: a person reads these numbers.
TEST(SampledSlice, TheMiddleOfAVoxelHasItsValue) {
    Random random(3);
    std::vector<Pose> all = poses();
    all.push_back({"a million to one", affine({1, 0, 0}, {0, 1e-6, 0}, {0, 0, 1}, {-90.1, 30.3, 200.7})});
    for (const Pose& pose : all) {
        SCOPED_TRACE(pose.name);
        for (const Volume& volume : volumesOf({9, 11, 7}, pose.worldFromVoxel)) {
            for (int n = 0; n < 50; ++n) {
                const glm::ivec3 voxel = randomVoxel(volume, random);
                const glm::dvec3 mm = transformPoint(volume.worldFromVoxel(), glm::dvec3(voxel));
                const bool isPadding = volume.isPadding(voxel.x, voxel.y, voxel.z);
                const auto value = static_cast<float>(volume.value(voxel.x, voxel.y, voxel.z));
                for (const SlicePlane& plane :
                     {acquiredPlane(volume, mm), planeOf(Orientation::axial, mm),
                      planeOf(Orientation::coronal, mm), planeOf(Orientation::sagittal, mm),
                      randomPlane(mm, random)}) {
                    for (const Filter filter : {Filter::nearest, Filter::linear}) {
                        const SliceFrame frame{.plane = plane, .mmPerPixel = 0.3, .sizePx = {5, 1}};
                        const float found = pixel(sampleSlice(volume, frame, {}, filter), 2, 0);
                        if (isPadding)
                            ASSERT_TRUE(std::isnan(found));
                        else
                            ASSERT_EQ(found, value);
                    }
                }
                const auto probed = probe(volume, mm);
                ASSERT_TRUE(probed);
                ASSERT_EQ(probed->voxel, voxel);
                ASSERT_EQ(probed->isPadding, isPadding);
                const double kept = volume.value(voxel.x, voxel.y, voxel.z);
                ASSERT_TRUE(probed->value == kept || (std::isnan(probed->value) && std::isnan(kept)));
            }
        }
    }
}

// With pixels as large as voxels the picture is the slice, row by row, up to its last row and column.
TEST(SampledSlice, OfASliceIsTheSlice) {
    const glm::ivec3 size{23, 17, 5};
    for (const double toLeft : {1.0, -1.0}) {
        const Volume volume = storedVolume(
            size, affine({0.7 * toLeft, 0, 0}, {0, 0.7, 0}, {0, 0, 3}, {-7.7, 12.9, 640.3}), Padding::none);
        for (int k = 0; k < size.z; ++k) {
            const glm::dvec3 centre =
                transformPoint(volume.worldFromVoxel(), {0.5 * (size.x - 1), 0.5 * (size.y - 1), k});
            const SliceFrame frame{
                .plane = planeOf(Orientation::axial, centre), .mmPerPixel = 0.7, .sizePx = {size.x, size.y}};
            for (const Filter filter : {Filter::nearest, Filter::linear}) {
                const SampledSlice slice = sampleSlice(volume, frame, {}, filter);
                for (int j = 0; j < size.y; ++j) {
                    for (int i = 0; i < size.x; ++i) {
                        const int x = toLeft > 0.0 ? i : size.x - 1 - i;
                        ASSERT_EQ(pixel(slice, x, j), static_cast<float>(volume.value(i, j, k)));
                    }
                }
            }
        }
    }
}

// The signed unit vectors that i, j and k can run along: 48 ways to store one and the same patient.
std::vector<glm::dmat3> allStorages() {
    std::vector<glm::dmat3> storages;
    std::array<int, 3> axes{0, 1, 2};
    do {
        for (unsigned signs = 0; signs < 8; ++signs) {
            glm::dmat3 storage(0.0);
            for (int n = 0; n < 3; ++n)
                storage[n][axes[std::size_t(n)]] = (signs >> unsigned(n) & 1U) != 0 ? -1.0 : 1.0;
            storages.push_back(storage);
        }
    } while (std::next_permutation(axes.begin(), axes.end()));
    return storages;
}

// Where the brightest pixel is, from -1 (left, top) to 1 (right, bottom).
glm::dvec2 brightest(const SampledSlice& slice) {
    const auto at = std::max_element(slice.values.begin(), slice.values.end()) - slice.values.begin();
    const auto width = static_cast<std::ptrdiff_t>(slice.sizePx.x);
    const glm::dvec2 px{double(at % width) + 0.5, double(at / width) + 0.5};
    return 2.0 * px / glm::dvec2(slice.sizePx) - 1.0;
}

TEST(SampledSlice, ThePatientsRightIsAtTheLeftHoweverItIsStored) {
    const glm::dvec3 right{-1, 0, 0};
    const glm::dvec3 anterior{0, -1, 0};
    const glm::dvec3 head{0, 0, 1};
    struct Case {
        Orientation orientation;
        glm::dvec3 bright;  // direction in the patient
        glm::dvec2 where;   // in the picture
    };
    const std::vector<Case> cases{
        {Orientation::axial, right, {-1, 0}},       {Orientation::axial, anterior, {0, -1}},
        {Orientation::coronal, right, {-1, 0}},     {Orientation::coronal, head, {0, -1}},
        {Orientation::sagittal, anterior, {-1, 0}}, {Orientation::sagittal, head, {0, -1}}};
    const glm::ivec3 size(9);
    for (const glm::dmat3& storage : allStorages()) {
        const glm::dmat4 worldFromVoxel =
            affine(storage[0] * 2.0, storage[1] * 2.0, storage[2] * 2.0, {31.0, -17.0, 80.0});
        for (const Case& c : cases) {
            const glm::ivec3 voxel(glm::round(glm::transpose(storage) * c.bright * 3.0 + 4.0));
            std::vector<float> values(9 * 9 * 9);
            values[std::size_t((voxel.z * 9 + voxel.y) * 9 + voxel.x)] = 1000.0F;
            const Volume volume = volumeOf(size, worldFromVoxel, std::move(values));
            const glm::dvec3 middle = middleMm(volume);
            SliceFrame frame{.plane = planeOf(c.orientation, middle), .mmPerPixel = 0.2, .sizePx = {89, 89}};
            // Three of four and a half voxels from the middle.
            const auto found = brightest(sampleSlice(volume, frame, {}, Filter::linear));
            EXPECT_LT(glm::length(found - c.where * (3.0 / 4.45)), 0.05);
            if (acquiredOrientation(volume) != c.orientation) continue;
            frame.plane = acquiredPlane(volume, middle);
            const auto asAcquired = brightest(sampleSlice(volume, frame, {}, Filter::linear));
            EXPECT_LT(glm::length(asAcquired - c.where * (3.0 / 4.45)), 0.05);
        }
    }
}

TEST(Probe, ReachesHalfAVoxelBeyondTheOuterMiddles) {
    const Volume volume =
        volumeOf({2, 1, 1}, affine({2, 0, 0}, {0, 3, 0}, {0, 0, 4}, {10, 20, 30}), {5.0F, std::nanf("")});
    ASSERT_TRUE(probe(volume, {9.1, 21.4, 31.9}));
    EXPECT_EQ(probe(volume, {9.1, 21.4, 31.9})->value, 5.0);
    EXPECT_EQ(probe(volume, {10.9, 20, 30})->voxel, glm::ivec3(0));
    ASSERT_TRUE(probe(volume, {11.1, 20, 30}));
    EXPECT_EQ(probe(volume, {11.1, 20, 30})->voxel, glm::ivec3(1, 0, 0));
    EXPECT_TRUE(probe(volume, {11.1, 20, 30})->isPadding);
    EXPECT_FALSE(probe(volume, {8.9, 20, 30}));
    EXPECT_FALSE(probe(volume, {13.1, 20, 30}));
    EXPECT_FALSE(probe(volume, {10, 21.6, 30}));
    EXPECT_FALSE(probe(volume, {10, 20, 27.9}));
    EXPECT_FALSE(probe(volume, {std::nan(""), 20, 30}));
    EXPECT_FALSE(probe(volume, {10, std::numeric_limits<double>::infinity(), 30}));
}

}  // namespace
}  // namespace macula::slices::test

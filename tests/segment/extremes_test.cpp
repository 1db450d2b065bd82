// Volumes with nothing to find in them, and volumes that are hardly volumes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scene.h"
#include "segment/messages.h"

namespace macula::segment::test {
namespace {

Volume even(glm::ivec3 size, double hu, Unit unit = Unit::hounsfield) {
    const std::size_t count = std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    auto volume = Volume::create({.size = size,
                                  .worldFromVoxel = glm::dmat4(1.0),
                                  .unitsFromStored = {1.0, -1024.0},
                                  .unit = unit,
                                  .modality = "CT",
                                  .padding = {},
                                  .provenance = {}},
                                 std::vector<std::uint16_t>(count, std::uint16_t(hu + 1024.0)));
    return std::move(*volume);
}

void expectAllKept(const Volume& volume, std::string_view key) {
    const PatientMask found = find(volume);
    for (const std::uint16_t label : found.map.labels()) ASSERT_EQ(label, PatientMask::kPatient);
    ASSERT_EQ(found.messages.size(), 1u);
    EXPECT_EQ(found.messages[0].key, key);
    EXPECT_EQ(found.removedMl, 0.0);
}

TEST(Extremes, NobodyThere) {
    expectAllKept(even({60, 50, 40}, -1000), key::kNoPatient);
    expectAllKept(even({1, 1, 1}, -1000), key::kNoPatient);
    expectAllKept(even({1, 1, 1}, 1000), key::kNoPatient);
    expectAllKept(even({100, 1, 1}, 1000), key::kNoPatient);
}

TEST(Extremes, NothingButBone) {
    expectAllKept(even({60, 50, 40}, 1500), key::kNothingToRemove);
}

TEST(Extremes, NothingButTable) {
    Made made = make({});
    std::vector<std::uint16_t> voxels(made.volume.voxels().begin(), made.volume.voxels().end());
    for (std::size_t n = 0; n < voxels.size(); ++n) {
        if (made.person[n] != 0) voxels[n] = 24;
    }
    auto volume = Volume::create({.size = made.volume.size(),
                                  .worldFromVoxel = made.volume.worldFromVoxel(),
                                  .unitsFromStored = {1.0, -1024.0},
                                  .unit = Unit::hounsfield,
                                  .modality = "CT",
                                  .padding = {},
                                  .provenance = {}},
                                 std::move(voxels));
    expectAllKept(*volume, key::kNoPatient);
}

TEST(Extremes, OneSlice) {
    const Made made = make({.size = {330, 280, 1}});
    const PatientMask found = find(made.volume);
    EXPECT_GT(dice(made, found), 0.99);
}

TEST(Extremes, OtherUnitsAreRefused) {
    for (const Unit unit : {Unit::raw, Unit::suvBodyWeight, Unit::becquerelsPerMillilitre, Unit::other}) {
        Progress progress;
        const auto found = findPatient(even({8, 8, 8}, 0, unit), progress);
        ASSERT_FALSE(found.ok());
        EXPECT_EQ(found.error().code, ErrorCode::usage);
        EXPECT_FALSE(found.error().hint.empty());
    }
}

// A round field of view in a square of NaN, as float and brought to 16 bits.
TEST(Extremes, NanAroundTheFieldOfView) {
    const Made made = make({.gapMm = 4.0});
    const glm::ivec3 size = made.volume.size();
    std::vector<float> values(made.volume.voxelCount());
    std::size_t n = 0;
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i, ++n) {
                const double fromMiddle = std::hypot(i - 0.5 * size.x, j - 0.5 * size.y);
                values[n] = fromMiddle > 140.0 ? std::numeric_limits<float>::quiet_NaN()
                                               : float(made.volume.value(i, j, k));
            }
        }
    }
    auto made32 = Volume::createFloat({.size = size,
                                       .worldFromVoxel = made.volume.worldFromVoxel(),
                                       .unitsFromStored = {},
                                       .unit = Unit::hounsfield,
                                       .modality = "CT",
                                       .padding = {},
                                       .provenance = {}},
                                      std::move(values));
    const auto volume = std::make_shared<const Volume>(std::move(*made32));
    const PatientMask found = find(*volume);
    const PatientMask found16 = find(*in16Bits(volume));
    ASSERT_TRUE(
        std::equal(found.map.labels().begin(), found.map.labels().end(), found16.map.labels().begin()));
    EXPECT_TRUE(found.tableFound);
    std::size_t lost = 0;
    std::size_t table = 0;
    std::size_t left = 0;
    for (std::size_t at = 0; at < volume->voxelCount(); ++at) {
        if (std::isnan(volume->floatVoxels()[at])) continue;
        lost += made.person[at] != 0 && found.map.labels()[at] == 0 ? 1 : 0;
        table += made.table[at];
        left += made.table[at] != 0 && found.map.labels()[at] != 0 ? 1 : 0;
    }
    EXPECT_EQ(lost, 0u);
    EXPECT_LT(double(left), 0.05 * double(table));
}

TEST(Extremes, CanBeCancelled) {
    const Made made = make({});
    const CancelToken token;
    int calls = 0;
    Progress progress(
        [&](const ProgressUpdate& update) {
            ++calls;
            if (update.fraction > 0.0) token.cancel();
        },
        token);
    token.cancel();
    const auto found = findPatient(made.volume, progress);
    ASSERT_FALSE(found.ok());
    EXPECT_EQ(found.error().code, ErrorCode::cancelled);
    EXPECT_GT(calls, 0);
}

}  // namespace
}  // namespace macula::segment::test

// Real series, which are not part of the repository (../shared/data/README.md): at the middle of a voxel a
// picture of it has its value, whichever way the slices lie.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include "base/paths.h"
#include "dicom/loader.h"
#include "dicom/scan.h"
#include "made_volumes.h"
#include "slices/sampled_slice.h"

namespace macula::slices::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::shared_ptr<const Volume>> volumesIn(const fs::path& path) {
    Progress progress;
    std::vector<std::shared_ptr<const Volume>> volumes;
    const auto scan = dicom::scanFolder(path, progress);
    if (!scan) return volumes;
    for (const dicom::Study& study : scan->studies) {
        for (const dicom::Series& series : study.series) {
            for (const dicom::Stack& stack : series.stacks) {
                if (!stack.canBeVolume()) continue;
                const auto volume = dicom::loadVolume(series, stack, progress);
                if (volume) volumes.push_back(*volume);
            }
        }
    }
    return volumes;
}

void expectValuesOfVoxels(const Volume& volume, Random& random) {
    for (int n = 0; n < 100; ++n) {
        const glm::ivec3 voxel = randomVoxel(volume, random);
        const glm::dvec3 mm = transformPoint(volume.worldFromVoxel(), glm::dvec3(voxel));
        const double value = volume.value(voxel.x, voxel.y, voxel.z);
        const bool isPadding = volume.isPadding(voxel.x, voxel.y, voxel.z);
        const auto probed = probe(volume, mm);
        ASSERT_TRUE(probed);
        ASSERT_EQ(probed->voxel, voxel);
        ASSERT_EQ(probed->isPadding, isPadding);
        ASSERT_TRUE(probed->value == value || (std::isnan(probed->value) && std::isnan(value)));
        for (const SlicePlane& plane :
             {acquiredPlane(volume, mm), planeOf(Orientation::axial, mm), planeOf(Orientation::coronal, mm),
              planeOf(Orientation::sagittal, mm), randomPlane(mm, random)}) {
            for (const Filter filter : {Filter::nearest, Filter::linear}) {
                const SliceFrame frame{.plane = plane, .mmPerPixel = 0.4, .sizePx = {3, 1}};
                const float found = sampleSlice(volume, frame, {}, filter).values[1];
                if (isPadding)
                    ASSERT_TRUE(std::isnan(found));
                else
                    ASSERT_EQ(found, static_cast<float>(value));
            }
        }
    }
}

// A whole slice as it was acquired: where the picture says that a voxel is, it shows that voxel, or the next
// one where the middle of the pixel is nearer to it.
void expectAcquiredSlice(const Volume& volume) {
    const glm::ivec3 count = volume.size();
    const int k = count.z / 2;
    const glm::dvec3 middle =
        transformPoint(volume.worldFromVoxel(), {0.5 * (count.x - 1), 0.5 * (count.y - 1), k});
    const SlicePlane plane = acquiredPlane(volume, middle);
    const glm::ivec2 size{700, 600};
    const SliceFrame frame{
        .plane = plane, .mmPerPixel = fittedMmPerPixel(volume, plane, size), .sizePx = size};
    const SampledSlice slice = sampleSlice(volume, frame, {}, Filter::nearest);
    ASSERT_EQ(slice.values.size(), std::size_t(700 * 600));
    const glm::dmat4 voxelFromWorld = glm::inverse(volume.worldFromVoxel());
    const auto isTie = [](double at) { return std::abs(at - std::floor(at) - 0.5) < 1e-4; };
    std::size_t compared = 0;
    for (int j = 0; j < count.y; j += 3) {
        for (int i = 0; i < count.x; i += 3) {
            const glm::dvec3 mm = transformPoint(volume.worldFromVoxel(), glm::dvec3(i, j, k));
            ASSERT_LT(std::abs(frame.distanceMm(mm)), 1e-3);
            const glm::ivec2 px(glm::floor(frame.pictureFromWorld(mm)));
            ASSERT_TRUE(px.x >= 0 && px.y >= 0 && px.x < size.x && px.y < size.y);
            const glm::dvec3 shown = frame.worldFromPicture(glm::dvec2(px) + 0.5);
            const glm::dvec3 at = transformPoint(voxelFromWorld, shown);
            if (isTie(at.x) || isTie(at.y)) continue;
            const auto there = probe(volume, shown);
            ASSERT_TRUE(there);
            ASSERT_LE(glm::length(glm::dvec3(there->voxel - glm::ivec3(i, j, k))), 1.5);
            const float found = slice.values[std::size_t(px.y * size.x + px.x)];
            if (there->isPadding)
                ASSERT_TRUE(std::isnan(found));
            else
                ASSERT_EQ(found, static_cast<float>(there->value));
            ++compared;
        }
    }
    EXPECT_GT(compared, std::size_t(count.x * count.y) / 20);
}

struct Source {
    const char* name;
    const char* path;
    std::size_t volumes;  // that can be opened, or more
};

class RealSeries : public testing::TestWithParam<Source> {};

TEST_P(RealSeries, HasTheValuesOfItsVoxels) {
    const fs::path path = macula::test::sharedFolder() / "data" / GetParam().path;
    if (!fs::exists(path)) GTEST_SKIP() << "the real test data are not on this machine: " << path;
    const auto volumes = volumesIn(path);
    ASSERT_GE(volumes.size(), GetParam().volumes);
    Random random(31);
    for (const auto& volume : volumes) {
        ASSERT_NO_FATAL_FAILURE(expectValuesOfVoxels(*volume, random));
        ASSERT_NO_FATAL_FAILURE(expectAcquiredSlice(*volume));
    }
}

INSTANTIATE_TEST_SUITE_P(, RealSeries,
                         testing::Values(Source{"ct", "ct_cta_rider", 1},
                                         Source{"mrSagittal", "mr_head_sag_hfs", 1},
                                         Source{"tiltedGantry", "odd/gantry_tilt_4slices", 1},
                                         Source{"oblique", "odd/nonisotropic_perslice_slope", 1},
                                         Source{"signedStored", "odd/signed12bit_hitachi", 1},
                                         Source{"multiFrame", "odd/enhanced_ct_2frame.dcm", 1},
                                         Source{"petAndMr", "odd/mixed_flat_folder", 2}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace macula::slices::test

// Real series, which are not part of the repository (../shared/data/README.md), as if the patient had lain
// otherwise: the same voxels in another place, with noise of another scan.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "base/paths.h"
#include "dicom/best_volume.h"
#include "dicom/loader.h"
#include "dicom/scan.h"
#include "moved_volumes.h"
#include "registration/rigid_registration.h"

namespace macula::registration::test {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<const Volume> bestVolumeIn(const char* folder) {
    const fs::path path = macula::test::projectFolder() / "../shared/data" / folder;
    if (!fs::exists(path)) return nullptr;
    Progress progress;
    const auto scan = dicom::scanFolder(path, progress);
    if (!scan) return nullptr;
    const dicom::ChosenStack choice = dicom::bestVolume(*scan);
    if (choice.series == nullptr || choice.stack == nullptr) return nullptr;
    const auto volume = dicom::loadVolume(*choice.series, *choice.stack, progress);
    return volume ? *volume : nullptr;
}

// Every other slice, so that it is not the same grid, and a little other in each voxel.
std::shared_ptr<const Volume> laidOtherwise(const Volume& volume, const glm::dmat4& movingFromFixed) {
    const glm::ivec3 size = volume.size();
    std::vector<float> voxels;
    const int slices = (size.z + 1) / 2;
    std::uint32_t noise = 1;
    for (int k = 0; k < slices; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                noise = noise * 1664525U + 1013904223U;
                voxels.push_back(volume.isPadding(i, j, 2 * k)
                                     ? std::nanf("")
                                     : float(volume.value(i, j, 2 * k) + double(noise >> 27U) - 15.5));
            }
    const glm::dmat4& from = volume.worldFromVoxel();
    const glm::dmat4 everyOther(from[0], from[1], 2.0 * from[2], from[3]);
    auto made = Volume::createFloat({.size = {size.x, size.y, slices},
                                     .worldFromVoxel = movingFromFixed * everyOther,
                                     .unit = volume.unit(),
                                     .modality = volume.modality()},
                                    std::move(voxels));
    return std::make_shared<const Volume>(*std::move(made));
}

void expectFound(const char* folder, double toleranceMm) {
    const auto volume = bestVolumeIn(folder);
    if (!volume) GTEST_SKIP() << "no " << folder;
    const glm::dvec3 middle = volume->worldBox().centre();
    const glm::dmat4 toMiddle = affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, -middle);
    const glm::dmat4 truth = glm::inverse(toMiddle) * rigid(7.0, {7.0, -6.0, 7.6}) * toMiddle;
    Progress progress;
    const auto found = registerRigid(*volume, *laidOtherwise(*volume, truth), progress);
    ASSERT_TRUE(found.ok()) << found.error().message;
    double errorMm = 0.0;
    const Box box = volume->worldBox();
    for (const glm::dvec3& mm : {box.low, box.high, middle})
        errorMm = std::max(
            errorMm, glm::length(transformPoint(found->movingFromFixed, mm) - transformPoint(truth, mm)));
    EXPECT_LT(errorMm, toleranceMm);
    EXPECT_FALSE(found->isDoubtful());
}

TEST(RealSeries, AChestCtIsFoundToAMillimetre) {
    expectFound("ct_cta_rider", 1.0);
}

TEST(RealSeries, AHeadMrOf5MmSlicesIsFoundToHalfASlice) {
    expectFound("mr_head_sag_hfs", 2.4);
}

}  // namespace
}  // namespace macula::registration::test

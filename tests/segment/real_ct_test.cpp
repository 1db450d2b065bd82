// Two real CTs, which are not part of the repository: ../shared/data/README.md.
#include <gtest/gtest.h>

#include <filesystem>

#include "base/paths.h"
#include "dicom/best_volume.h"
#include "dicom/loader.h"
#include "dicom/scan.h"
#include "scene.h"
#include "segment/components.h"

namespace macula::segment::test {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<const Volume> load(const fs::path& folder) {
    Progress progress;
    const auto scan = dicom::scanFolder(folder, progress);
    if (!scan) return nullptr;
    const dicom::Series& series = scan->studies.front().series.front();
    const auto volume = dicom::loadVolume(series, series.stacks.front(), progress);
    return volume ? *volume : nullptr;
}

struct Study {
    const char* folder;
    int tableFirst;  // rows of the middle slice between which there is nothing but table
    int tableLast;
    double leastRemovedMl;
};

class RealCt : public testing::TestWithParam<Study> {};

TEST_P(RealCt, TableGoesAndEveryBoneStays) {
    const fs::path folder = macula::test::sharedFolder() / "data" / GetParam().folder;
    if (!fs::is_directory(folder)) GTEST_SKIP() << "the real test data are not on this machine: " << folder;
    const auto volume = load(folder);
    ASSERT_NE(volume, nullptr);
    const PatientMask found = find(*volume);
    EXPECT_TRUE(found.tableFound);
    EXPECT_GT(found.removedMl, GetParam().leastRemovedMl);

    // Bone: what is denser than 150 HU, of the part that holds the spine, which is the largest one.
    const glm::ivec3 size = volume->size();
    const Grid grid{.size = size, .spacingMm = volume->spacingMm()};
    Mask dense(grid.count());
    std::size_t n = 0;
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i, ++n) dense[n] = volume->value(i, j, k) > 150.0 ? 1 : 0;
        }
    }
    const auto parts = partsOf(grid, dense, false, {});
    ASSERT_TRUE(parts.ok());
    std::size_t largest = 0;
    for (std::size_t part = 0; part < parts->parts.size(); ++part) {
        if (parts->parts[part].blocks > parts->parts[largest].blocks) largest = part;
    }
    std::size_t lost = 0;
    for (n = 0; n < dense.size(); ++n)
        lost += parts->labels[n] == largest + 1 && found.map.labels()[n] == 0 ? 1 : 0;
    EXPECT_EQ(lost, 0u) << "of " << parts->parts[largest].blocks;

    std::size_t table = 0;
    for (int j = GetParam().tableFirst; j < GetParam().tableLast; ++j) {
        for (int i = 0; i < size.x; ++i) table += found.map.label(i, j, size.z / 2) != 0 ? 1 : 0;
    }
    EXPECT_EQ(table, 0u);
}

INSTANTIATE_TEST_SUITE_P(, RealCt,
                         testing::Values(Study{"ct_chest_ricord", 425, 512, 500.0},
                                         Study{"ct_cta_rider", 425, 512, 30.0}),
                         [](const auto& test) { return std::string(test.param.folder); });

}  // namespace
}  // namespace macula::segment::test

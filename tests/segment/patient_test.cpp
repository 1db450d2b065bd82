// People of whom it is known where they end, on tables of which it is known where they begin.
#include "segment/patient.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "base/paths.h"
#include "base/phantom.h"
#include "scene.h"
#include "segment/messages.h"

namespace macula::segment::test {
namespace {

struct Case {
    const char* name;
    Scene scene;
};

void PrintTo(const Case& one, std::ostream* out) {
    *out << one.name;
}

class OnTable : public testing::TestWithParam<Case> {};

TEST_P(OnTable, PatientStaysAndTableGoes) {
    const Made made = make(GetParam().scene);
    const PatientMask found = find(made.volume);
    const double body = dice(made, found);
    const double table = tableRemoved(made, found);
    RecordProperty("dice", std::to_string(body));
    RecordProperty("tableRemoved", std::to_string(table));
    EXPECT_GT(body, 0.99);
    EXPECT_GT(table, 0.95);
    EXPECT_TRUE(found.tableFound);
    EXPECT_GT(found.removedMl, 50.0);
    EXPECT_NE(found.confidence, Confidence::none);
    ASSERT_FALSE(found.messages.empty());
    EXPECT_EQ(found.messages[0].key, key::kTableRemoved);
    EXPECT_NE(found.messages[0].sentence.english().find(" mL (confidence"), std::string::npos);
}

// What was taken away has a volume, which is only as good as the size of a voxel.
TEST(Patient, TheVolumeThatIsLeftOutSaysThatItIsNotCalibrated) {
    const Made made = make({});
    VolumeOptions options{.size = made.volume.size(), .worldFromVoxel = made.volume.worldFromVoxel()};
    options.unitsFromStored = made.volume.unitsFromStored();
    options.unit = made.volume.unit();
    options.modality = made.volume.modality();
    options.padding = made.volume.padding();
    options.provenance.isCalibrated = false;
    const auto voxels = made.volume.voxels();
    const auto volume = Volume::create(options, {voxels.begin(), voxels.end()});
    ASSERT_TRUE(volume.ok());
    const PatientMask found = find(*volume);
    ASSERT_FALSE(found.messages.empty());
    ASSERT_EQ(found.messages[0].key, key::kTableRemoved);
    EXPECT_NE(found.messages[0].sentence.english().find("mL, not calibrated (confidence"), std::string::npos)
        << found.messages[0].sentence;
}

// Columns of a tilted gantry: each slice a little higher than the one before.
glm::dmat4 tilted() {
    return affine({1.3, 0, 0}, {0, 1.3 * 0.9703, 1.3 * 0.2419}, {0, 0, 2.5}, {-214, -176, -103});
}
// Taken along the patient, front to back.
glm::dmat4 coronal() {
    return affine({1.3, 0, 0}, {0, 0, -1.5}, {0, 1.3, 0}, {-214, -181, 90});
}

// Turned against the table across it, as no scanner does and a resampled volume may be.
glm::dmat4 turned() {
    return affine({1.293, 0.136, 0}, {-0.136, 1.293, 0}, {0, 0, 2.5}, {-194, -203, -59});
}

INSTANTIATE_TEST_SUITE_P(
    , OnTable,
    testing::Values(
        Case{"apart", {}}, Case{"nearly", {.gapMm = 2.0}}, Case{"touching", {.gapMm = 0.0}},
        Case{"flattened", {.gapMm = 0.0, .sunkMm = 8.0}},
        Case{"bowl", {.gapMm = 0.0, .sunkMm = 8.0, .bowlMm = 30.0}},
        Case{"foam", {.gapMm = 0.0, .sunkMm = 6.0, .foamHu = -700.0}},
        Case{"denseFoam", {.gapMm = 0.0, .sunkMm = 6.0, .foamHu = -280.0}},
        Case{"prone", {.lying = Lying::prone, .gapMm = 0.0, .sunkMm = 5.0}},
        Case{"onTheSide", {.lying = Lying::onTheSide, .gapMm = 0.0, .sunkMm = 5.0}},
        Case{"arms", {.body = Body::trunkWithArms, .gapMm = 0.0, .sunkMm = 5.0}},
        Case{"armsApart", {.body = Body::trunkWithArms}}, Case{"legs", {.body = Body::legs}},
        Case{"legsTouching", {.body = Body::legs, .gapMm = 0.0, .sunkMm = 4.0}},
        Case{"turned", {.gapMm = 0.0, .sunkMm = 5.0, .worldFromVoxel = turned()}},
        Case{"tilted", {.worldFromVoxel = tilted()}},
        Case{"coronal", {.gapMm = 0.0, .sunkMm = 5.0, .size = {330, 120, 280}, .worldFromVoxel = coronal()}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Patient, WithoutTableNothingGoes) {
    for (const Body body : {Body::trunk, Body::trunkWithArms, Body::legs}) {
        const Made made = make({.body = body, .table = false});
        const PatientMask found = find(made.volume);
        EXPECT_FALSE(found.tableFound);
        EXPECT_EQ(found.removedParts, 0);
        EXPECT_EQ(dice(made, found), 1.0);
    }
}

// The phantom's ribs, spine and marker, and the lungs that they enclose.
TEST(Patient, PhantomIsUnharmed) {
    const Volume volume = phantom::make();
    const PatientMask found = find(volume);
    EXPECT_FALSE(found.tableFound);
    std::size_t lost = 0;
    for (std::size_t n = 0; n < volume.voxelCount(); ++n)
        lost += found.map.labels()[n] == 0 && volume.voxels()[n] > 24 ? 1 : 0;
    EXPECT_EQ(lost, 0u);
}

// What the mask takes away is not lost: it lies on the volume's own grid, and the volume is as it was.
TEST(Patient, MaskIsOnTheVolumesGrid) {
    const Made made = make({});
    const PatientMask found = find(made.volume);
    EXPECT_EQ(found.map.size(), made.volume.size());
    EXPECT_EQ(found.map.worldFromVoxel(), made.volume.worldFromVoxel());
    ASSERT_NE(found.map.segment(PatientMask::kPatient), nullptr);
    EXPECT_EQ(found.map.segment(PatientMask::kPatient)->algorithm, "AUTOMATIC");
    ASSERT_EQ(found.map.messages().size(), found.messages.size());
    EXPECT_EQ(found.map.messages()[0], found.messages[0]);
}

TEST(Patient, AirAroundTheSkinStays) {
    const Made made = make({});
    const PatientMask found = find(made.volume);
    const glm::ivec3 size = made.volume.size();
    // The front of the belly: from the first voxel of the person two more, into the air.
    const int i = size.x / 2;
    const int k = size.z / 2;
    int j = 0;
    while (made.volume.value(i, j, k) < -500.0) ++j;
    EXPECT_EQ(found.map.label(i, j - 2, k), PatientMask::kPatient);
    EXPECT_EQ(found.map.label(i, j - 8, k), 0);
}

TEST(Patient, EachMessageIsDocumented) {
    std::ifstream file(macula::test::projectFolder() / "docs/table-removal.md");
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    for (const CatalogueEntry& entry : catalogue()) {
        const std::string severity = entry.severity == Severity::warning ? "warning" : "info";
        EXPECT_NE(text.find(fmt::format("| `{}` | {} |", entry.key, severity)), std::string::npos)
            << entry.key;
    }
}

TEST(Patient, TouchingIsReported) {
    const PatientMask found = find(make({.gapMm = 0.0, .sunkMm = 8.0}).volume);
    ASSERT_EQ(found.messages.size(), 2u);
    EXPECT_EQ(found.messages[1].key, key::kTableTouchesPatient);
    EXPECT_EQ(found.confidence, Confidence::moderate);
}

}  // namespace
}  // namespace macula::segment::test

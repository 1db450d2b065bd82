// Exports beside those of dcm2niix, which reads DICOM with code of its own. Runs when it is installed
// (packaging/bootstrap does that) and the data are there.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "formats/volume_file.h"
#include "nifti_bytes.h"
#include "support.h"

namespace macula::formats::test {

using namespace dicom;
using namespace dicom::test;
namespace {

namespace fs = std::filesystem;
using namespace dicom;
using namespace dicom::test;

#define SKIP_WITHOUT_DCM2NIIX() \
    if (std::system("command -v dcm2niix >/dev/null 2>&1") != 0) GTEST_SKIP() << "dcm2niix is not installed"

// Each series of `data` to a file of its UID.
void runDcm2niix(const fs::path& data, const fs::path& folder) {
    const std::string command =
        fmt::format("dcm2niix -b n -z n -f %j -o '{}' '{}' >/dev/null 2>&1", folder.string(), data.string());
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

// Their voxel for ours: axes stay what they are, dcm2niix turns some around.
struct Turns {
    glm::ivec3 step{1};
    glm::ivec3 start{0};

    glm::ivec3 operator()(const glm::ivec3& voxel) const { return start + step * voxel; }
};

Turns turnsOf(const NiftiBytes& ours, const NiftiBytes& theirs) {
    Turns turns;
    for (int axis = 0; axis < 3; ++axis) {
        if (glm::dot(glm::dvec3(ours.sform()[axis]), glm::dvec3(theirs.sform()[axis])) > 0.0) continue;
        turns.step[axis] = -1;
        turns.start[axis] = ours.size()[axis] - 1;
    }
    return turns;
}

double largestDifference(const NiftiBytes& ours, const NiftiBytes& theirs, const Turns& turns) {
    double largest = 0.0;
    const glm::ivec3 size = ours.size();
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                const glm::ivec3 n = turns({i, j, k});
                const double difference = std::abs(ours.value(i, j, k) - theirs.value(n.x, n.y, n.z));
                if (!(difference <= largest)) largest = difference;  // a NaN stays
            }
        }
    }
    return largest;
}

class Dcm2niix : public ::testing::Test {
  protected:
    // Of the series with this UID.
    void exportBoth(const fs::path& data, const std::string& seriesUid) {
        ASSERT_NO_FATAL_FAILURE(runDcm2niix(data, folder_.path()));
        const auto found = scan(data);
        ASSERT_TRUE(found);
        const Series* series = findSeries(*found, seriesUid);
        ASSERT_NE(series, nullptr);
        const auto volume = load(*series);
        ASSERT_NE(volume, nullptr);
        Progress progress;
        const auto written = writeVolumeFile(*volume, folder_ / "ours.nii.gz", progress);
        ASSERT_TRUE(written.ok()) << written.error().message;
        ours_ = readNiftiBytes(folder_ / "ours.nii.gz");
        theirs_ = readNiftiBytes(folder_ / (seriesUid + ".nii"));
        ASSERT_FALSE(theirs_.bytes.empty()) << "dcm2niix wrote no " << seriesUid;
    }
    std::string onlySeriesOf(const fs::path& data) {
        const auto found = scan(data);
        return found && found->studies.size() == 1 ? found->studies[0].series.at(0).seriesInstanceUid : "";
    }
    // All voxels within `tolerance`, all entries of the affine within 0.0001 mm, those of the position of the
    // first voxel within `originMm`.
    void expectSame(double tolerance, double originMm = 1e-4) {
        ASSERT_EQ(ours_.size(), theirs_.size());
        const Turns turns = turnsOf(ours_, theirs_);
        EXPECT_LE(largestDifference(ours_, theirs_, turns), tolerance);
        const glm::dmat4 theirAffine = theirs_.sform();
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec4 column = theirAffine[axis] * double(turns.step[axis]);
            EXPECT_LT(glm::length(ours_.sform()[axis] - column), 1e-4) << axis;
        }
        const glm::dvec3 first = transformPoint(theirAffine, glm::dvec3(turns({0, 0, 0})));
        EXPECT_LT(glm::length(glm::dvec3(ours_.sform()[3]) - first), originMm);
    }
    // Against what the headers say, from ../shared/data/truth, at the corners: who is right where the two
    // differ.
    void expectTrue(const std::string& name, std::size_t index = 0) {
        std::ifstream stream(sharedData() / "truth" / (name + ".json"));
        const auto rows = nlohmann::json::parse(stream)["series"][index]["affine_lps_col_row_slice"];
        glm::dmat4 truth(1.0);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 4; ++column) truth[column][row] = rows[row][column].get<double>();
        }
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 voxel(glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2) * (ours_.size() - 1));
            EXPECT_LT(glm::length(transformPoint(ours_.sform(), voxel) - transformPoint(truth, voxel)), 1e-4);
        }
    }

    TemporaryFolder folder_;
    NiftiBytes ours_;
    NiftiBytes theirs_;
};

TEST_F(Dcm2niix, CtChest) {
    SKIP_WITHOUT_SHARED_DATA();
    SKIP_WITHOUT_DCM2NIIX();
    const fs::path data = sharedData() / "ct_chest_ricord";
    ASSERT_NO_FATAL_FAILURE(exportBoth(data, onlySeriesOf(data)));
    expectSame(0.0);
    expectTrue("ct_chest_ricord");
}

TEST_F(Dcm2niix, CtFeetFirst) {
    SKIP_WITHOUT_SHARED_DATA();
    SKIP_WITHOUT_DCM2NIIX();
    const fs::path data = sharedData() / "ct_cta_rider";
    ASSERT_NO_FATAL_FAILURE(exportBoth(data, onlySeriesOf(data)));
    expectSame(0.0);
    expectTrue("ct_cta_rider");
}

TEST_F(Dcm2niix, MrSagittal) {
    SKIP_WITHOUT_SHARED_DATA();
    SKIP_WITHOUT_DCM2NIIX();
    const fs::path data = sharedData() / "mr_head_sag_hfs";
    ASSERT_NO_FATAL_FAILURE(exportBoth(data, onlySeriesOf(data)));
    expectSame(0.0, 2e-4);  // dcm2niix turns the slices around in float32, and is 0.00015 mm off the header
    expectTrue("mr_head_sag_hfs");
}

TEST_F(Dcm2niix, MrOfAFlatFolder) {
    SKIP_WITHOUT_SHARED_DATA();
    SKIP_WITHOUT_DCM2NIIX();
    ASSERT_NO_FATAL_FAILURE(exportBoth(sharedData() / "odd/mixed_flat_folder",
                                       "1.3.6.1.4.1.14519.5.2.1.5168.1900.255616124643796471881589754666"));
    expectSame(0.0);
    expectTrue("odd_mixed_flat_folder", 0);
}

TEST_F(Dcm2niix, PetWithASlopePerSlice) {
    SKIP_WITHOUT_SHARED_DATA();
    SKIP_WITHOUT_DCM2NIIX();
    ASSERT_NO_FATAL_FAILURE(exportBoth(sharedData() / "odd/mixed_flat_folder",
                                       "1.3.6.1.4.1.14519.5.2.1.5168.1900.475429996794833172294137667411"));
    // Both are float32; dcm2niix multiplies in it, and we round once at the end.
    double largest = 0.0;
    for (int k = 0; k < ours_.size().z; ++k) {
        for (int j = 0; j < ours_.size().y; ++j) {
            for (int i = 0; i < ours_.size().x; ++i)
                largest = std::max(largest, std::abs(ours_.value(i, j, k)));
        }
    }
    expectSame(largest * std::pow(2.0, -23));
    expectTrue("odd_mixed_flat_folder", 1);
}

// dcm2niix writes the slices of a tilted gantry as they are to this file, with an sform that makes them
// perpendicular and is wrong (rows 0.4308 mm apart, where the header has 0.4180), and resampled ones to
// another.
TEST_F(Dcm2niix, GantryTilt) {
    SKIP_WITHOUT_SHARED_DATA();
    SKIP_WITHOUT_DCM2NIIX();
    const fs::path data = sharedData() / "odd/gantry_tilt_4slices";
    ASSERT_NO_FATAL_FAILURE(exportBoth(data, onlySeriesOf(data)));
    ASSERT_EQ(ours_.size(), theirs_.size());
    EXPECT_EQ(largestDifference(ours_, theirs_, turnsOf(ours_, theirs_)), 0.0);
    expectTrue("odd_gantry_tilt_4slices");
    EXPECT_EQ(ours_.qformCode(), 0);
}

}  // namespace
}  // namespace macula::formats::test

// Real series against reference values that were made without DCMTK and without this code:
// ../shared/data/README.md.
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/sha256.h"
#include "support.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// The reference of one series of a folder in ../shared/data.
Json truthOf(const std::string& name, std::size_t index = 0) {
    std::ifstream stream(sharedData() / "truth" / (name + ".json"));
    return Json::parse(stream)["series"][index];
}

glm::dmat4 affineOf(const Json& rows) {
    glm::dmat4 m(1.0);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) m[column][row] = rows[row][column].get<double>();
    }
    return m;
}

void expectMatchesTruth(const Volume& volume, const Series& series, const Json& truth) {
    EXPECT_EQ(series.seriesInstanceUid, truth["series_uid"].get<std::string>());
    EXPECT_EQ(series.modality, truth["modality"].get<std::string>());
    EXPECT_EQ(series.patientPosition, truth["patient_position"].get<std::string>());
    EXPECT_EQ(volume.size(),
              glm::ivec3(truth["columns"].get<int>(), truth["rows"].get<int>(), truth["files"].get<int>()));
    EXPECT_LT(affineError(volume.worldFromVoxel(), affineOf(truth["affine_lps_col_row_slice"])), 1e-9);

    double sum = 0.0;
    double least = 1e300;
    double most = -1e300;
    std::vector<std::int16_t> integers;
    std::vector<float> reals;
    const glm::ivec3 size = volume.size();
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                const double value = volume.value(i, j, k);
                sum += value;
                least = std::min(least, value);
                most = std::max(most, value);
                integers.push_back(static_cast<std::int16_t>(std::lround(value)));
                reals.push_back(static_cast<float>(value));
            }
        }
    }
    // The reference's are those before they were rounded to float.
    const double tolerance =
        volume.format() == VoxelFormat::float32 ? 1e-7 * std::max(std::abs(least), most) : 0.0;
    EXPECT_NEAR(least, truth["min"].get<double>(), tolerance);
    EXPECT_NEAR(most, truth["max"].get<double>(), tolerance);
    const double mean = truth["mean"].get<double>();
    EXPECT_NEAR(sum / static_cast<double>(reals.size()), mean, tolerance + 1e-10 * std::abs(mean));
    if (truth.contains("sha256_int16le_kji")) {
        EXPECT_EQ(volume.format(), VoxelFormat::stored16);
        EXPECT_EQ(sha256Hex(std::as_bytes(std::span(integers))),
                  truth["sha256_int16le_kji"].get<std::string>());
    }
    if (truth.contains("sha256_float32le_kji")) {
        EXPECT_EQ(sha256Hex(std::as_bytes(std::span(reals))),
                  truth["sha256_float32le_kji"].get<std::string>());
    }

    ASSERT_EQ(truth["probes"].size(), 48u);
    for (const Json& probe : truth["probes"]) {
        const glm::ivec3 voxel{probe["col_row_slice"][0], probe["col_row_slice"][1],
                               probe["col_row_slice"][2]};
        EXPECT_NEAR(volume.value(voxel.x, voxel.y, voxel.z), probe["value"].get<double>(), tolerance);
        const glm::dvec3 world = transformPoint(volume.worldFromVoxel(), glm::dvec3(voxel));
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(world[axis], probe["lps_mm"][axis].get<double>(), 1e-3);
        EXPECT_EQ(series.stacks[0].frames[static_cast<std::size_t>(voxel.z)].instance->sopInstanceUid,
                  probe["sop_instance_uid"].get<std::string>());
    }
}

void checkFolder(const std::string& folder, const std::string& truthName) {
    const Json truth = truthOf(truthName);
    const auto found = scan(sharedData() / folder);
    ASSERT_TRUE(found);
    const Series* series = findSeries(*found, truth["series_uid"].get<std::string>());
    ASSERT_NE(series, nullptr);
    const auto volume = load(*series);
    ASSERT_NE(volume, nullptr);
    expectMatchesTruth(*volume, *series, truth);
}

TEST(Truth, CtChest) {
    SKIP_WITHOUT_SHARED_DATA();
    checkFolder("ct_chest_ricord", "ct_chest_ricord");
}

TEST(Truth, CtChestPaddingIsMarkedAndKeepsItsValue) {
    SKIP_WITHOUT_SHARED_DATA();
    const auto volume = loadFolder(sharedData() / "ct_chest_ricord");
    ASSERT_NE(volume, nullptr);
    ASSERT_TRUE(volume->padding());
    EXPECT_EQ(volume->unitsFromStored()(volume->padding()->low), -3024.0);
    EXPECT_EQ(volume->value(0, 0, 0), -3024.0);  // the corner outside the round field of view
    EXPECT_GE(volume->unitsFromStored()(volume->storedRange().low), -1024.0);
    EXPECT_EQ(volume->unit(), Unit::hounsfield);
}

TEST(Truth, CtPulmonaryAngiographyFeetFirst) {
    SKIP_WITHOUT_SHARED_DATA();
    checkFolder("ct_cta_rider", "ct_cta_rider");
}

TEST(Truth, MrSagittal) {
    SKIP_WITHOUT_SHARED_DATA();
    checkFolder("mr_head_sag_hfs", "mr_head_sag_hfs");
}

TEST(Truth, SignedTwelveBits) {
    SKIP_WITHOUT_SHARED_DATA();
    checkFolder("odd/signed12bit_hitachi", "odd_signed12bit_hitachi");
}

TEST(Truth, TiltedGantryIsAShearedAffine) {
    SKIP_WITHOUT_SHARED_DATA();
    checkFolder("odd/gantry_tilt_4slices", "odd_gantry_tilt_4slices");
}

TEST(Truth, SingleFramesOfLegacyPair) {
    SKIP_WITHOUT_SHARED_DATA();
    checkFolder("odd/legacy_enhanced_pair", "odd_legacy_enhanced_pair");
}

// Each slice has its own slope.
TEST(Truth, SlopePerSliceAnisotropicOblique) {
    SKIP_WITHOUT_SHARED_DATA();
    checkFolder("odd/nonisotropic_perslice_slope", "odd_nonisotropic_perslice_slope");
}

TEST(Truth, FlatFolderOfMrPetAndStructures) {
    SKIP_WITHOUT_SHARED_DATA();
    const auto found = scan(sharedData() / "odd/mixed_flat_folder");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->objectCount(), 1u);
    for (const std::size_t index : {std::size_t{0}, std::size_t{1}}) {
        const Json truth = truthOf("odd_mixed_flat_folder", index);
        const Series* series = findSeries(*found, truth["series_uid"].get<std::string>());
        ASSERT_NE(series, nullptr);
        const auto volume = load(*series);
        ASSERT_NE(volume, nullptr);
        const bool perSlice = truth["modality"] == "PT";
        EXPECT_EQ(hasMessage(*series, key::kPerSliceRescale), perSlice);
        EXPECT_EQ(volume->format(), perSlice ? VoxelFormat::float32 : VoxelFormat::stored16);
        EXPECT_TRUE(volume->provenance().assumptions.empty());
        expectMatchesTruth(*volume, *series, truth);
    }
}

TEST(Truth, SevenTransferSyntaxesGiveOneImage) {
    SKIP_WITHOUT_SHARED_DATA();
    const Json truth = truthOf("odd_transfer_syntaxes");
    // One slice is no volume, so each is given a geometry of its own before it is loaded.
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(sharedData() / "odd/transfer_syntaxes")) {
        SCOPED_TRACE(entry.path().filename());
        const auto found = scan(entry.path());
        ASSERT_TRUE(found);
        const Series series = found->studies.at(0).series.at(0);
        EXPECT_TRUE(hasMessage(series, key::kSingleSlice));
        Stack stack = series.stacks.at(0);
        ASSERT_EQ(series.instances, 1u);
        stack.messages.clear();
        stack.slices = {{0, 0, 0.0}};
        stack.worldFromVoxel = glm::dmat4(1.0);
        const auto volume = load(series, stack);
        ASSERT_NE(volume, nullptr);
        for (const Json& probe : truth["probes"]) {
            EXPECT_EQ(volume->value(probe["col_row_slice"][0], probe["col_row_slice"][1], 0),
                      probe["value"].get<double>());
        }
        std::vector<std::int16_t> whole;
        // The reference hashes the seven images one after another.
        for (int copy = 0; copy < 7; ++copy) {
            for (const std::uint16_t stored : volume->voxels()) {
                whole.push_back(static_cast<std::int16_t>(volume->unitsFromStored()(stored)));
            }
        }
        EXPECT_EQ(sha256Hex(std::as_bytes(std::span(whole))), truth["sha256_int16le_kji"].get<std::string>());
        ++count;
    }
    EXPECT_EQ(count, 7u);
}

}  // namespace
}  // namespace macula::dicom::test

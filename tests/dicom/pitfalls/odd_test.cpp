// Every file and folder of ../shared/data/odd: the volume its truth file states, or the right message. What
// the truth files cover by their hashes is in ../truth_test.cpp too; here each is read in the company it has.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/sha256.h"
#include "opened.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

fs::path odd(const std::string& name) {
    return sharedData() / "odd" / name;
}

Json truthOf(const std::string& name, std::size_t index = 0) {
    std::ifstream stream(sharedData() / "truth" / ("odd_" + name + ".json"));
    return Json::parse(stream)["series"][index];
}

void expectTruth(const Volume& volume, const Json& truth) {
    const int slices = truth["files"].get<int>();
    EXPECT_EQ(volume.size(), glm::ivec3(truth["columns"].get<int>(), truth["rows"].get<int>(), slices));
    glm::dmat4 m(1.0);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column)
            m[column][row] = truth["affine_lps_col_row_slice"][row][column].get<double>();
    }
    EXPECT_LT(affineError(volume.worldFromVoxel(), m), 1e-6);
    ASSERT_EQ(truth["probes"].size(), 48u);
    for (const Json& probe : truth["probes"]) {
        const double expected = probe["value"].get<double>();
        EXPECT_NEAR(
            volume.value(probe["col_row_slice"][0], probe["col_row_slice"][1], probe["col_row_slice"][2]),
            expected, 1e-6 * std::abs(expected));
    }
    if (!truth.contains("sha256_int16le_kji")) return;
    std::vector<std::int16_t> whole;
    for (int k = 0; k < volume.size().z; ++k) {
        for (int j = 0; j < volume.size().y; ++j) {
            for (int i = 0; i < volume.size().x; ++i)
                whole.push_back(static_cast<std::int16_t>(std::lround(volume.value(i, j, k))));
        }
    }
    EXPECT_EQ(sha256Hex(std::as_bytes(std::span(whole))), truth["sha256_int16le_kji"].get<std::string>());
}

const Series* seriesOf(const Opened& opened, const std::string& uid) {
    for (const Series* series : opened.series()) {
        if (series->seriesInstanceUid == uid) return series;
    }
    ADD_FAILURE() << "no series " << uid;
    return nullptr;
}

// The whole folder in one go: 35 series lie side by side in the same scan, and none disturbs another.
const Opened& everything() {
    static const Opened opened(sharedData() / "odd");
    return opened;
}

TEST(Odd, FoldersWithATruthFile) {
    SKIP_WITHOUT_SHARED_DATA();
    for (const char* name : {"gantry_tilt_4slices", "nonisotropic_perslice_slope", "signed12bit_hitachi"}) {
        SCOPED_TRACE(name);
        const Json truth = truthOf(name);
        const Opened alone(odd(name));
        const auto volume = alone.onlyVolume();
        ASSERT_NE(volume, nullptr);
        expectTruth(*volume, truth);
        const Series* amongAll = seriesOf(everything(), truth["series_uid"]);
        ASSERT_NE(amongAll, nullptr);
        ASSERT_EQ(amongAll->stacks.size(), 1u);
        const auto again = everything().load(amongAll->stacks[0]);
        ASSERT_NE(again, nullptr);
        expectTruth(*again, truth);
    }
}

TEST(Odd, TiltIsTold) {
    SKIP_WITHOUT_SHARED_DATA();
    const Opened opened(odd("gantry_tilt_4slices"));
    const Message* told = opened.find(key::kTiltedStack);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_NEAR(numberArgument(*told, "degrees"), 14.0, 0.01);
}

TEST(Odd, SlopesPerSliceAreTold) {
    SKIP_WITHOUT_SHARED_DATA();
    EXPECT_TRUE(Opened(odd("nonisotropic_perslice_slope")).says(key::kPerSliceRescale));
}

TEST(Odd, LegacyConvertedPairIsOneVolumeBothWays) {
    SKIP_WITHOUT_SHARED_DATA();
    const Json truth = truthOf("legacy_enhanced_pair");
    const Opened opened(odd("legacy_enhanced_pair"));
    const auto volumes = opened.volumes();
    ASSERT_EQ(volumes.size(), 2u) << opened.keys();
    for (const Stack* stack : volumes) {
        const auto volume = opened.load(*stack);
        ASSERT_NE(volume, nullptr);
        expectTruth(*volume, truth);
    }
    ASSERT_EQ(opened.others().size(), 1u);
    EXPECT_EQ(opened.others()[0].sopClassUid, "1.2.840.10008.5.1.4.1.1.66.4");
    const Opened multi(odd("legacy_enhanced_pair/mf.dcm"));
    const auto volume = multi.onlyVolume();
    ASSERT_NE(volume, nullptr);
    expectTruth(*volume, truth);
}

// By hand from the dump: orientation -1 0 0 0 1 0, so that the normal points down; frame 2 (z -149) is first.
TEST(Odd, EnhancedCt) {
    SKIP_WITHOUT_SHARED_DATA();
    const Opened opened(odd("enhanced_ct_2frame.dcm"));
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    expectGrid(*volume, {512, 512, 2},
               affine({-0.388672, 0, 0}, {0, 0.388672, 0}, {0, 0, -10}, {99.5, -301.5, -149}), 1e-9);
    EXPECT_EQ(volume->unit(), Unit::raw);  // its RescaleType is US: unspecified
    DcmFileFormat format;
    ASSERT_TRUE(format.loadFile(odd("enhanced_ct_2frame.dcm").c_str()).good());
    const Uint16* cells = nullptr;
    unsigned long count = 0;
    ASSERT_TRUE(format.getDataset()->findAndGetUint16Array(DCM_PixelData, cells, &count).good());
    constexpr std::size_t kFrame = 512 * 512;
    ASSERT_EQ(count, 2 * kFrame);
    for (std::size_t n = 0; n < kFrame; n += 37) {
        const int i = static_cast<int>(n % 512);
        const int j = static_cast<int>(n / 512);
        ASSERT_EQ(volume->value(i, j, 0), cells[kFrame + n] - 1024.0);
        ASSERT_EQ(volume->value(i, j, 1), cells[n] - 1024.0);
    }
}

// Its functional groups were removed: ten pictures without a place.
TEST(Odd, EnhancedMrWithoutFunctionalGroups) {
    SKIP_WITHOUT_SHARED_DATA();
    const Opened opened(odd("enhanced_mr_10frame.dcm"));
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_EQ(opened.frames(), 10u);
    EXPECT_TRUE(opened.says(key::kMultiFrameNoPosition)) << opened.keys();
}

TEST(Odd, MixedFlatFolder) {
    SKIP_WITHOUT_SHARED_DATA();
    const Opened opened(odd("mixed_flat_folder"));
    EXPECT_EQ(opened.series().size() - (opened.series().size() > opened.stacks().size() ? 1 : 0), 2u);
    ASSERT_EQ(opened.volumes().size(), 2u) << opened.keys();
    ASSERT_EQ(opened.others().size(), 1u);
    EXPECT_EQ(opened.others()[0].sopClassUid, "1.2.840.10008.5.1.4.1.1.481.3");
    EXPECT_TRUE(opened.scan().skipped.empty());
    for (const std::size_t index : {std::size_t{0}, std::size_t{1}}) {
        const Json truth = truthOf("mixed_flat_folder", index);
        SCOPED_TRACE(truth["modality"].get<std::string>());
        const Series* series = seriesOf(opened, truth["series_uid"]);
        ASSERT_NE(series, nullptr);
        ASSERT_EQ(series->stacks.size(), 1u);
        const auto volume = opened.load(series->stacks[0]);
        ASSERT_NE(volume, nullptr);
        expectTruth(*volume, truth);
    }
}

// Seven copies of one image in seven syntaxes: they decode alike (../truth_test.cpp), and are no volume.
TEST(Odd, TransferSyntaxesAreOnePosition) {
    SKIP_WITHOUT_SHARED_DATA();
    const Opened opened(odd("transfer_syntaxes"));
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_TRUE(opened.scan().skipped.empty());
    EXPECT_TRUE(opened.says(key::kSingleSlice) || opened.says(key::kDuplicatePositions)) << opened.keys();
    ASSERT_EQ(opened.series().size(), 1u);
    EXPECT_EQ(opened.series()[0]->transferSyntaxUids.size(), 7u);
    EXPECT_EQ(opened.frames(), 7u);
}

// Made into a volume by giving each a place of its own: all seven give the same values.
TEST(Odd, TransferSyntaxesSideBySideAreOneVolume) {
    SKIP_WITHOUT_SHARED_DATA();
    const Json truth = truthOf("transfer_syntaxes");
    const TemporaryFolder folder;
    int n = 0;
    for (const auto& entry : fs::directory_iterator(odd("transfer_syntaxes"))) {
        const fs::path copy = folder / std::to_string(n);
        fs::copy_file(entry.path(), copy);
        // J2K, JPEG and JPEG-LS streams are kept as they are.
        editFile(copy, [n](DcmItem& item) {
            put(item, DCM_ImagePositionPatient, fmt::format("-161.399994\\-148.800003\\{}", 10 * n));
            put(item, DCM_SOPInstanceUID, fmt::format("2.25.{}", 900 + n));
        });
        ++n;
    }
    ASSERT_EQ(n, 7);
    const Opened opened(folder.path());
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->size(), glm::ivec3(512, 512, 7));
    for (const Json& probe : truth["probes"]) {
        for (int k = 0; k < 7; ++k) {
            EXPECT_EQ(volume->value(probe["col_row_slice"][0], probe["col_row_slice"][1], k),
                      probe["value"].get<double>());
        }
    }
}

TEST(Odd, ColourIsListedAndNoVolume) {
    SKIP_WITHOUT_SHARED_DATA();
    for (const auto& [name, frames] : {std::pair{"rgb_series_j2k", 4u}, {"rgb_secondary_capture.dcm", 1u}}) {
        SCOPED_TRACE(name);
        const Opened opened(odd(name));
        EXPECT_TRUE(opened.volumes().empty());
        EXPECT_EQ(opened.frames(), frames);
        EXPECT_TRUE(opened.says(key::kColourImage)) << opened.keys();
    }
}

TEST(Odd, ProjectionWithLowValuesBright) {
    SKIP_WITHOUT_SHARED_DATA();
    const Opened opened(odd("monochrome1_dx.dcm"));
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_EQ(opened.frames(), 1u);
    EXPECT_TRUE(opened.says(key::kInvertedDisplay)) << opened.keys();
    EXPECT_TRUE(opened.says(key::kNoPosition) || opened.says(key::kUnsupportedSeries)) << opened.keys();
}

TEST(Odd, MediaWithADirectory) {
    SKIP_WITHOUT_SHARED_DATA();
    const Opened opened(odd("dicomdir_media"));
    EXPECT_FALSE(opened.says(key::kDicomdirMissingFiles));
    EXPECT_FALSE(opened.says(key::kDicomdirUnreadable));
    EXPECT_TRUE(opened.scan().skipped.empty());
    EXPECT_EQ(opened.frames(), 31u);
    EXPECT_EQ(opened.scan().notDicom, 1u);  // README.txt
    EXPECT_EQ(opened.scan().patients, 2);   // one of them in two folders
    // Five slices of 2.5 mm, first down at z -1.2375.
    const Series* head = seriesOf(opened, "1.3.6.1.4.1.5962.1.1.0.0.0.1194734704.16302.0.6");
    ASSERT_NE(head, nullptr);
    ASSERT_EQ(head->stacks.size(), 1u);
    EXPECT_TRUE(head->stacks[0].canBeVolume()) << opened.keys();
    // Two localizers at a right angle, in one series.
    const Series* scouts = seriesOf(opened, "1.3.6.1.4.1.5962.1.1.0.0.0.1194734704.16302.0.2");
    ASSERT_NE(scouts, nullptr);
    EXPECT_FALSE(scouts->canBeVolume());
    // Projections around the head, and three-plane localizers.
    for (const char* uid : {"1.3.6.1.4.1.5962.1.1.0.0.0.1196533885.18148.0.118",
                            "1.3.6.1.4.1.5962.1.1.0.0.0.1196533885.18148.0.136",
                            "1.3.6.1.4.1.5962.1.1.0.0.0.1196533885.18148.0.17"}) {
        const Series* series = seriesOf(opened, uid);
        ASSERT_NE(series, nullptr);
        EXPECT_FALSE(series->canBeVolume()) << uid;
    }
}

// Four of 165 slices were kept: -99.48 and then 103.02, 104.27, 105.52. Whatever is shown, it is said that
// 161 are missing, or that they are not there.
TEST(Odd, MediaWithAGapOfTwentyCentimetres) {
    SKIP_WITHOUT_SHARED_DATA();
    const Opened opened(odd("dicomdir_media/77654033/CT2"));
    EXPECT_EQ(opened.frames(), 4u);
    const Message* told = opened.find(key::kMissingSlices);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_EQ(numberArgument(*told, "missing"), 161.0);
    for (const Stack* stack : opened.volumes()) EXPECT_LE(stack->slices.size(), 20u) << "made of nothing";
}

TEST(Odd, TruncatedIsNamed) {
    SKIP_WITHOUT_SHARED_DATA();
    EXPECT_EQ(std::count_if(everything().scan().skipped.begin(), everything().scan().skipped.end(),
                            [](const SkippedFile& s) {
                                return s.file.filename() == "truncated_mr.dcm" &&
                                       s.message.key == key::kTruncatedFile;
                            }),
              1);
}

TEST(Odd, WithoutPreamble) {
    SKIP_WITHOUT_SHARED_DATA();
    const Opened opened(odd("no_preamble_ct.dcm"));
    EXPECT_EQ(opened.frames(), 1u);
    EXPECT_TRUE(opened.says(key::kSingleSlice)) << opened.keys();
    ASSERT_EQ(opened.series().size(), 1u);
    EXPECT_EQ(opened.series()[0]->transferSyntaxUids, std::vector<std::string>{"1.2.840.10008.1.2"});
}

TEST(Odd, Localizer) {
    SKIP_WITHOUT_SHARED_DATA();
    const Opened opened(odd("ct_localizer_scout.dcm"));
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_TRUE(opened.says(key::kLocalizer)) << opened.keys();
}

TEST(Odd, ObjectsThatAreNoImages) {
    SKIP_WITHOUT_SHARED_DATA();
    const auto listed = [](const char* name) {
        for (const OtherObject& other : everything().others()) {
            if (other.file.filename() == name) return other.sopClassUid;
        }
        return std::string();
    };
    EXPECT_EQ(listed("rtstruct.dcm"), "1.2.840.10008.5.1.4.1.1.481.3");
    EXPECT_EQ(listed("RS_RS.dcm"), "1.2.840.10008.5.1.4.1.1.481.3");
    EXPECT_EQ(listed("seg_1frame.dcm"), "1.2.840.10008.5.1.4.1.1.66.4");
    EXPECT_EQ(listed("label.seg"), "1.2.840.10008.5.1.4.1.1.66.4");
}

// Every series once, every frame in it, and whatever is no volume says why.
TEST(Odd, NothingIsLostAndNothingIsSilent) {
    SKIP_WITHOUT_SHARED_DATA();
    std::vector<std::string> uids;
    for (const Series* series : everything().series()) {
        uids.push_back(series->seriesInstanceUid);
        for (const Stack& stack : series->stacks) {
            EXPECT_EQ(stack.canBeVolume(), stack.whyNoVolume() == nullptr);
            EXPECT_FALSE(stack.frames.empty());
            if (!stack.canBeVolume()) {
                EXPECT_FALSE(stack.whyNoVolume()->sentence.empty());
            }
            Progress progress;
            const auto volume = loadVolume(*series, stack, progress);
            EXPECT_EQ(volume.ok(), stack.canBeVolume()) << series->seriesInstanceUid;
        }
    }
    std::sort(uids.begin(), uids.end());
    EXPECT_EQ(std::adjacent_find(uids.begin(), uids.end()), uids.end());
}

TEST(Odd, NamesInOtherAlphabets) {
    SKIP_WITHOUT_SHARED_DATA();
    const Opened opened(odd("charsets"));
    std::vector<std::string> names;
    for (const Study& study : opened.scan().studies) names.push_back(study.patientName);
    for (const char* name : {"Wang^XiaoDong=王^小東=", "Yamada^Tarou=山田^太郎=やまだ^たろう", "Люкceмбypг",
                             "قباني^لنزار", "김희중"}) {
        // The Korean one has no pixels: it is told of, and not shown.
        if (std::string(name) == "김희중") continue;
        EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
    }
}

}  // namespace
}  // namespace macula::dicom::test

// Files that other programs open, or that are named for what they are: old headers, spectra, mosaics, doses.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <fstream>
#include <sstream>

#include "../bytes.h"
#include "opened.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

using ForeignFiles = Pitfall;

std::string contents(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

// Some writers give the file meta information without value representations.
TEST_F(ForeignFiles, ImplicitFileMetaInformation) {
    for (const fs::path& file : writeFiles(folder.path(), series)) {
        const std::string bytes = contents(file);
        std::size_t at = 132;
        std::string meta;
        while (bytes[at] == 2 && bytes[at + 1] == 0) {
            const std::string vr = bytes.substr(at + 4, 2);
            const bool isLong = vr == "OB" || vr == "UN" || vr == "OW" || vr == "SQ";
            std::uint32_t length = 0;
            bytes.copy(reinterpret_cast<char*>(&length), isLong ? 4 : 2, at + (isLong ? 8 : 6));
            const std::size_t value = at + (isLong ? 12 : 8);
            meta += bytes.substr(at, 4) + bytesOf(length, 4) + bytes.substr(value, length);
            at = value + length;
        }
        std::ofstream(file, std::ios::binary) << bytes.substr(0, 132) << meta << bytes.substr(at);
    }
    expectOnlyVolume(open(), series);
}

// ACR-NEMA knew greyscale only.
TEST_F(ForeignFiles, WithoutPhotometricInterpretation) {
    series.edits.push_back([](DcmItem& item) { erase(item, DCM_PhotometricInterpretation); });
    writeFiles(folder.path(), series);
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_TRUE(opened.says(key::kGreyscaleAssumed)) << opened.keys();
}

TEST_F(ForeignFiles, SpectroscopyIsNamed) {
    Shell shell{.sopClassUid = "1.2.840.10008.5.1.4.1.1.4.2", .modality = "MR"};
    shell.edits.push_back([](DcmItem& item) {
        putWord(item, DCM_Rows, 1);
        putWord(item, DCM_Columns, 1);
        const std::vector<Float32> spectrum(16, 1.0f);
        ASSERT_TRUE(
            item.putAndInsertFloat32Array(DcmTag(0x5600, 0x0020, EVR_OF), spectrum.data(), spectrum.size())
                .good());
    });
    writeShell(folder / "spectrum", shell);
    const Opened opened = open();
    ASSERT_EQ(opened.others().size(), 1u) << opened.keys();
    EXPECT_EQ(opened.others()[0].kind, "MR spectroscopy");
    EXPECT_FALSE(opened.says(key::kNoPixelData)) << opened.keys();
}

TEST_F(ForeignFiles, APreambleIsNoPatient) {
    writeFiles(folder.path(), series);
    std::ofstream(folder / "empty", std::ios::binary) << std::string(128, '\0') << "DICM";
    const Opened opened = open();
    EXPECT_EQ(opened.scan().patients, 1);
    EXPECT_EQ(opened.series().size(), 1u);
    EXPECT_TRUE(opened.says(key::kDamagedFile)) << opened.keys();
}

TEST_F(ForeignFiles, MosaicsAreNamed) {
    series.modality = "MR";
    series.imageType = "ORIGINAL\\PRIMARY\\M\\ND\\MOSAIC";
    writeFiles(folder.path(), series);
    const Opened opened = open();
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_TRUE(opened.says(key::kMosaic)) << opened.keys();
    EXPECT_EQ(opened.stacks().size(), 1u);
}

TEST_F(ForeignFiles, ADoseSaysSoAndItsUnit) {
    series.modality = "RTDOSE";
    series.sopClassUid = UID_RTDoseStorage;
    series.writeRescale = false;
    series.edits.push_back([](DcmItem& item) {
        put(item, DCM_DoseGridScaling, "0.01");
        put(item, DCM_DoseUnits, "GY");
    });
    writeFiles(folder.path(), series);
    const Opened opened = open();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->unitName(), "Gy");
    const Message* told = opened.find(key::kDose);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_NE(told->sentence.english().find("Gy"), std::string::npos) << told->sentence;
    EXPECT_EQ(told->severity, Severity::warning);
}

TEST_F(ForeignFiles, ARelativeDoseSaysWhatItIsRelativeTo) {
    series.modality = "RTDOSE";
    series.sopClassUid = UID_RTDoseStorage;
    series.writeRescale = false;
    series.edits.push_back([](DcmItem& item) {
        put(item, DCM_DoseGridScaling, "0.01");
        put(item, DCM_DoseUnits, "RELATIVE");
    });
    writeFiles(folder.path(), series);
    const Opened opened = open();
    const Message* told = opened.find(key::kDose);
    ASSERT_NE(told, nullptr);
    EXPECT_EQ(told->sentence,
              "These values are a dose distribution (unit: × reference dose), and no anatomy.");
}

TEST_F(ForeignFiles, WithoutTheDictionaryNothingIsReadAndItIsSaid) {
    writeFiles(folder.path(), series);
    dcmDataDict.wrlock().clear();
    dcmDataDict.wrunlock();
    Progress progress;
    const auto scanned = scanFolder(folder.path(), progress);
    dcmDataDict.wrlock().reloadDictionaries(OFTrue, OFTrue);
    dcmDataDict.wrunlock();
    ASSERT_FALSE(scanned);
    EXPECT_NE(scanned.error().message.english().find("dictionary"), std::string::npos)
        << scanned.error().message;
    EXPECT_FALSE(scanned.error().hint.empty());
    expectOnlyVolume(open(), series);
}

}  // namespace
}  // namespace macula::dicom::test

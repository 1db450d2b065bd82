// Pictures for the archive: whose they are, what is in them, and what a checker of DICOM says.
#include "dicom/write/secondary_capture.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <set>

#include "dicom/read/placeholder.h"
#include "dicom/scan.h"
#include "dicom/write/series_writer.h"
#include "edit.h"
#include "opens_in_dcmtk.h"
#include "support.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 5;  // odd, as is the height: the pixels need a byte to be even
constexpr int kHeight = 3;

std::vector<std::uint8_t> pixels() {
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < kWidth * kHeight; ++i) {
        for (const int value : {i, 100 + i, 255 - i, 128}) rgba.push_back(std::uint8_t(value));
    }
    return rgba;
}

std::string textOf(DcmDataset& dataset, const DcmTagKey& tag) {
    OFString all;
    dataset.findAndGetOFStringArray(tag, all);
    return all.c_str();
}

class SecondaryCaptureTest : public testing::Test {
  protected:
    void SetUp() override {
        source_ = write(smallVolume(), folder_.path() / "source").front();
        DcmFileFormat file;
        ASSERT_TRUE(file.loadFile(source_.c_str()).good());
        DcmDataset& dataset = *file.getDataset();
        dataset.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 100");
        dataset.putAndInsertString(DCM_PatientName, "M\xfcller^Anna");  // Latin 1
        dataset.putAndInsertString(DCM_PatientID, "0042");
        dataset.putAndInsertString(DCM_AccessionNumber, "A17");
        ASSERT_TRUE(file.saveFile(source_.c_str()).good());
        const std::string uid = textOf(dataset, DCM_SOPInstanceUID);
        capture_ = {.widthPx = kWidth,
                    .heightPx = kHeight,
                    .rgba = rgba_,
                    .source = SecondaryCapture::Source{source_, uid},
                    .seriesDescription = "Macula 3D",
                    .derivation = "Volume rendering, path traced, 32 samples",
                    .softwareVersion = "1.0"};
    }

    DcmDataset& written() {
        const Result<void> done = writeSecondaryCapture(path_, capture_);
        EXPECT_TRUE(done.ok()) << (done ? "" : done.error().message.english());
        EXPECT_TRUE(file_.loadFile(path_.c_str()).good());
        return *file_.getDataset();
    }

    const TemporaryFolder folder_;
    const fs::path path_ = folder_.path() / "capture.dcm";
    fs::path source_;
    std::vector<std::uint8_t> rgba_ = pixels();
    SecondaryCapture capture_;
    DcmFileFormat file_;
};

TEST_F(SecondaryCaptureTest, BelongsToTheStudyThatItShows) {
    DcmFileFormat original;
    ASSERT_TRUE(original.loadFile(source_.c_str()).good());
    DcmDataset& is = written();
    for (const DcmTagKey& tag : {DCM_SpecificCharacterSet, DCM_PatientName, DCM_PatientID,
                                 DCM_StudyInstanceUID, DCM_StudyDate, DCM_AccessionNumber, DCM_Modality})
        EXPECT_EQ(textOf(is, tag), textOf(*original.getDataset(), tag)) << tag.toString();
    EXPECT_NE(textOf(is, DCM_SeriesInstanceUID), textOf(*original.getDataset(), DCM_SeriesInstanceUID));
    EXPECT_EQ(textOf(is, DCM_BurnedInAnnotation), "NO");
    EXPECT_EQ(textOf(is, DCM_ConversionType), "WSD");
    DcmItem* item = nullptr;
    ASSERT_TRUE(is.findAndGetSequenceItem(DCM_SourceImageSequence, item, 0).good());
    OFString uid;
    item->findAndGetOFString(DCM_ReferencedSOPInstanceUID, uid);
    EXPECT_EQ(std::string(uid.c_str()), textOf(*original.getDataset(), DCM_SOPInstanceUID));
}

TEST_F(SecondaryCaptureTest, PixelsAreThoseOfThePicture) {
    DcmDataset& is = written();
    const Uint8* bytes = nullptr;
    unsigned long count = 0;
    ASSERT_TRUE(is.findAndGetUint8Array(DCM_PixelData, bytes, &count).good());
    ASSERT_EQ(count, 46u);  // 45, and one to be even
    for (std::size_t pixel = 0; pixel < 15; ++pixel) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            EXPECT_EQ(bytes[3 * pixel + channel], rgba_[4 * pixel + channel]);
    }
}

TEST_F(SecondaryCaptureTest, OfNobodyNothingIsLeftOfThePatient) {
    capture_.isDeidentified = true;
    DcmDataset& is = written();
    DcmFileFormat original;
    ASSERT_TRUE(original.loadFile(source_.c_str()).good());
    EXPECT_EQ(textOf(is, DCM_PatientIdentityRemoved), "YES");
    EXPECT_NE(textOf(is, DCM_StudyInstanceUID), textOf(*original.getDataset(), DCM_StudyInstanceUID));
    // Of the file itself, whatever the tag.
    std::ifstream stream(path_, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
    for (const DcmTagKey& tag : {DCM_PatientName, DCM_PatientID, DCM_StudyInstanceUID, DCM_SeriesInstanceUID,
                                 DCM_SOPInstanceUID, DCM_AccessionNumber, DCM_FrameOfReferenceUID})
        EXPECT_EQ(bytes.find(textOf(*original.getDataset(), tag)), std::string::npos) << tag.toString();
}

// An archive must not file all deidentified pictures under one patient.
TEST_F(SecondaryCaptureTest, OfNobodyThoseOfOnePatientStayTogetherAndApartFromOthers) {
    capture_.isDeidentified = true;
    const std::string id = textOf(written(), DCM_PatientID);
    const std::string study = textOf(written(), DCM_StudyInstanceUID);
    EXPECT_EQ(textOf(written(), DCM_PatientID), id);
    EXPECT_EQ(textOf(written(), DCM_StudyInstanceUID), study);
    EXPECT_FALSE(isPlaceholder(id)) << id;
    DcmFileFormat other;
    ASSERT_TRUE(other.loadFile(source_.c_str()).good());
    other.getDataset()->putAndInsertString(DCM_PatientID, "0043");
    capture_.source->file = folder_.path() / "other.dcm";
    ASSERT_TRUE(other.saveFile(capture_.source->file.c_str()).good());
    EXPECT_NE(textOf(written(), DCM_PatientID), id);
    EXPECT_NE(textOf(written(), DCM_StudyInstanceUID), study);
    // Nothing tells whose they are: none is with another.
    capture_.source.reset();
    std::set<std::string> ids{id};
    for (int n = 0; n < 3; ++n) ids.insert(textOf(written(), DCM_PatientID));
    EXPECT_EQ(ids.size(), 4u);
}

TEST_F(SecondaryCaptureTest, SaysThatAFaceMayBeSeenUnlessItCannot) {
    capture_.heightMm = 300.0;
    EXPECT_EQ(textOf(written(), DCM_RecognizableVisualFeatures), "YES") << "no body part is named";
    DcmFileFormat file;
    ASSERT_TRUE(file.loadFile(source_.c_str()).good());
    for (const auto& [part, told] : {std::pair("ABDOMEN", "NO"), {"HEAD", "YES"}}) {
        file.getDataset()->putAndInsertString(DCM_BodyPartExamined, part);
        ASSERT_TRUE(file.saveFile(source_.c_str()).good());
        for (const bool isDeidentified : {true, false}) {
            capture_.isDeidentified = isDeidentified;
            EXPECT_EQ(textOf(written(), DCM_RecognizableVisualFeatures), told) << part;
        }
    }
    capture_.source.reset();
    capture_.isDeidentified = true;
    EXPECT_EQ(textOf(written(), DCM_RecognizableVisualFeatures), "YES");
}

TEST_F(SecondaryCaptureTest, EachIsAnInstanceOfItsOwn) {
    std::set<std::string> uids;
    for (int i = 0; i < 3; ++i) {
        DcmDataset& is = written();
        uids.insert({textOf(is, DCM_SeriesInstanceUID), textOf(is, DCM_SOPInstanceUID)});
    }
    EXPECT_EQ(uids.size(), 6u);
    for (const std::string& uid : uids) EXPECT_LE(uid.size(), 64u);
}

TEST_F(SecondaryCaptureTest, WhatDoesNotFitIsRefusedAndWritesNothing) {
    const auto refused = [&](SecondaryCapture capture, ErrorCode code) {
        const Result<void> done = writeSecondaryCapture(path_, capture);
        EXPECT_FALSE(done.ok());
        if (!done) {
            EXPECT_EQ(done.error().code, code);
            EXPECT_EQ(done.error().message.english().find("ller"), std::string::npos);
        }
        EXPECT_FALSE(fs::exists(path_));
    };
    SecondaryCapture wrong = capture_;
    wrong.widthPx = 0;
    refused(wrong, ErrorCode::usage);
    wrong = capture_;
    wrong.heightPx = 4;
    refused(wrong, ErrorCode::usage);
    wrong = capture_;
    wrong.seriesDescription = std::string(65, 'a');
    refused(wrong, ErrorCode::usage);
    wrong.seriesDescription = "one\\two";
    refused(wrong, ErrorCode::usage);
    wrong = capture_;
    wrong.source->file = folder_.path() / "gone.dcm";
    refused(wrong, ErrorCode::inputNotUsable);
    std::ofstream(folder_.path() / "text.dcm") << "no DICOM";
    wrong.source->file = folder_.path() / "text.dcm";
    refused(wrong, ErrorCode::inputNotUsable);
    // The disc was changed: the same name, and another image.
    wrong = capture_;
    wrong.source->sopInstanceUid += "1";
    refused(wrong, ErrorCode::inputNotUsable);
    // Of somebody, and nobody says who.
    wrong = capture_;
    wrong.source.reset();
    refused(wrong, ErrorCode::usage);
}

TEST_F(SecondaryCaptureTest, AFolderThatIsGoneIsAnError) {
    const Result<void> done = writeSecondaryCapture(folder_.path() / "gone" / "capture.dcm", capture_);
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().code, ErrorCode::outputNotWritable);
}

TEST_F(SecondaryCaptureTest, DcmtkOpensIt) {
    for (const bool isDeidentified : {false, true}) {
        capture_.isDeidentified = isDeidentified;
        ASSERT_TRUE(writeSecondaryCapture(path_, capture_).ok());
        expectOpensInDcmtk(path_);
    }
}

TEST_F(SecondaryCaptureTest, TheCheckerFindsNoError) {
    if (std::system("command -v dciodvfy >/dev/null 2>&1") != 0)
        GTEST_SKIP() << "dciodvfy is not installed: packaging/bootstrap";
    for (const int kind : {0, 1, 2}) {
        SecondaryCapture capture = capture_;
        capture.isDeidentified = kind == 1;
        if (kind == 2) {
            capture.source.reset();
            capture.isOfNobody = true;
        }
        ASSERT_TRUE(writeSecondaryCapture(path_, capture).ok());
        const fs::path report = folder_.path() / "report.txt";
        std::ignore =
            std::system(fmt::format("dciodvfy '{}' >'{}' 2>&1", path_.string(), report.string()).c_str());
        std::ifstream stream(report);
        const std::string text((std::istreambuf_iterator<char>(stream)), {});
        EXPECT_NE(text.find("SCImage"), std::string::npos) << text;
        EXPECT_EQ(text.find("Error"), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace macula::dicom::test

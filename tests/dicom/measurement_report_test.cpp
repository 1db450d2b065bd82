// Reports of measurements: what DCMTK's reader of structured reports, which checks them against their class,
// and a checker of DICOM find in them.
#include "dicom/write/measurement_report.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmsr/dsrdoc.h>
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <sstream>

#include "dicom/scan.h"
#include "dicom/write/uid.h"
#include "opens_in_dcmtk.h"
#include "support.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

const CodedName kLength{"410668003", "SCT", "Length"};
const CodedName kMm{"mm", "UCUM", "millimeter"};

std::string textOf(DcmItem& item, const DcmTagKey& tag) {
    OFString all;
    item.findAndGetOFStringArray(tag, all);
    return all.c_str();
}

std::string bytesOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class MeasurementReportTest : public testing::Test {
  protected:
    void SetUp() override {
        source_ = write(smallVolume(), folder_ / "source").front();
        setPatient("ISO_IR 100", "M\xfcller^Anna");  // Latin 1
        DcmDataset& image = *original_.getDataset();
        owner_.image = SecondaryCapture::Source{source_, textOf(image, DCM_SOPInstanceUID)};
        owner_.softwareVersion = "1.0";
        report_.modality = "CT";
        report_.series = {.seriesInstanceUid = textOf(image, DCM_SeriesInstanceUID),
                          .frameOfReferenceUid = textOf(image, DCM_FrameOfReferenceUID),
                          .images = {{textOf(image, DCM_SOPClassUID), textOf(image, DCM_SOPInstanceUID)}}};
        report_.measurements = {length("Distance 1", 12.5)};
    }

    void setPatient(const char* characterSet, const char* name) {
        ASSERT_TRUE(original_.loadFile(source_.c_str()).good());
        original_.loadAllDataIntoMemory();
        DcmDataset& dataset = *original_.getDataset();
        dataset.putAndInsertString(DCM_SpecificCharacterSet, characterSet);
        dataset.putAndInsertString(DCM_PatientName, name);
        dataset.putAndInsertString(DCM_PatientID, "0042");
        dataset.putAndInsertString(DCM_AccessionNumber, "A17");
        ASSERT_TRUE(original_.saveFile(source_.c_str()).good());
    }

    static ReportedMeasurement length(const std::string& label, double mm) {
        return {.label = label,
                .trackingUid = uidFrom(label),
                .comment = {},
                .points = PointsOnImage{0, 0, {{0.5, 1.5}, {3.25, 2.0}}},
                .numbers = {{kLength, kMm, mm}}};
    }
    static ReportedMeasurement region() {
        return {.label = "Lesion",
                .trackingUid = "2.25.77",
                .comment = "1 of 9 voxels lies in a slice without an image.",
                .shape = ReportedShape::ellipse,
                .points = PointsInSpace{{{1, 2, 3}, {5, 2, 3}, {3, 1, 3}, {3, 3, 3.5}}},
                .numbers = {{{"42798000", "SCT", "Area"}, {"mm2", "UCUM", "square millimeter"}, 6.25},
                            {{"112181", "DCM", "Mean Attenuation Coefficient"},
                             {"[hnsf'U]", "UCUM", "Hounsfield unit"},
                             -12.0}}};
    }

    // As DCMTK's dsrdump prints it; also checks that the file is right for its class.
    std::string written() {
        const Result<void> done = writeMeasurementReport(path_, report_, owner_);
        EXPECT_TRUE(done.ok()) << (done ? "" : done.error().message.english());
        if (!done) return {};
        EXPECT_TRUE(file_.loadFile(path_.c_str()).good());
        DSRDocument document;
        const OFCondition read = document.read(*file_.getDataset());
        EXPECT_TRUE(read.good()) << read.text();
        EXPECT_EQ(document.getDocumentType(), DSRTypes::DT_Comprehensive3DSR);
        std::ostringstream text;
        EXPECT_TRUE(document
                        .print(text, DSRTypes::PF_printAllCodes | DSRTypes::PF_printTemplateIdentification |
                                         DSRTypes::PF_printSOPInstanceUID)
                        .good());
        return text.str();
    }
    static bool has(const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    }
    DcmDataset& dataset() { return *file_.getDataset(); }

    const TemporaryFolder folder_;
    const fs::path path_ = folder_ / "report.dcm";
    fs::path source_;
    DcmFileFormat original_;
    MeasurementReport report_;
    NewObject owner_;
    DcmFileFormat file_;
};

TEST_F(MeasurementReportTest, SaysWhatWasMeasuredAndWhere) {
    report_.measurements.push_back(region());
    const std::string text = written();
    const std::string image = report_.series.images[0].sopInstanceUid;
    for (const std::string& part : std::vector<std::string>{
             "CONTAINER:(126000,DCM,\"Imaging Measurement Report\")=SEPARATE>", "TID 1500 (DCMR)",
             "TID 1410 (DCMR)", "TID 1501 (DCMR)",
             "CODE:(121005,DCM,\"Observer Type\")=(121007,DCM,\"Device\")",
             "TEXT:(121013,DCM,\"Device Observer Name\")=\"Macula 1.0\"",
             "CODE:(121139,DCM,\"Modality\")=(CT,DCM,\"Computed Tomography\")",
             "TEXT:(112039,DCM,\"Tracking Identifier\")=\"Distance 1\"",
             "UIDREF:(112040,DCM,\"Tracking Unique Identifier\")=\"" + uidFrom("Distance 1"),
             "NUM:(410668003,SCT,\"Length\")=\"12.5\" (mm,UCUM,\"millimeter\")",
             "inferred from SCOORD:(121112,DCM,\"Source of Measurement\")=(POLYLINE,0.5/1.5,3.25/2)",
             "selected from IMAGE:=(CT image,\"" + image,
             "contains SCOORD3D:(111030,DCM,\"Image Region\")=(ELLIPSE,", "1/2/3,5/2/3,3/1/3,3/3/3.5",
             "NUM:(42798000,SCT,\"Area\")=\"6.25\" (mm2,UCUM,\"square millimeter\")",
             "NUM:(112181,DCM,\"Mean Attenuation Coefficient\")=\"-12\" ([hnsf'U],UCUM,\"Hounsfield unit\")",
             "TEXT:(121106,DCM,\"Comment\")=\"1 of 9 voxels"})
        EXPECT_TRUE(has(text, part)) << part << "\nis not in\n" << text;
}

TEST_F(MeasurementReportTest, BelongsToTheStudyAndNamesItsEvidence) {
    written();
    DcmDataset& image = *original_.getDataset();
    for (const DcmTagKey& tag : {DCM_SpecificCharacterSet, DCM_PatientName, DCM_PatientID,
                                 DCM_StudyInstanceUID, DCM_StudyDate, DCM_AccessionNumber})
        EXPECT_EQ(textOf(dataset(), tag), textOf(image, tag)) << tag.toString();
    EXPECT_EQ(textOf(dataset(), DCM_Modality), "SR");
    EXPECT_EQ(textOf(dataset(), DCM_VerificationFlag), "UNVERIFIED");
    EXPECT_EQ(textOf(dataset(), DCM_CompletionFlag), "COMPLETE");
    EXPECT_NE(textOf(dataset(), DCM_SeriesInstanceUID), report_.series.seriesInstanceUid);
    DcmItem* study = nullptr;
    ASSERT_TRUE(
        dataset().findAndGetSequenceItem(DCM_CurrentRequestedProcedureEvidenceSequence, study).good());
    EXPECT_EQ(textOf(*study, DCM_StudyInstanceUID), textOf(image, DCM_StudyInstanceUID));
    DcmItem* series = nullptr;
    ASSERT_TRUE(study->findAndGetSequenceItem(DCM_ReferencedSeriesSequence, series).good());
    EXPECT_EQ(textOf(*series, DCM_SeriesInstanceUID), report_.series.seriesInstanceUid);
    DcmItem* instance = nullptr;
    ASSERT_TRUE(series->findAndGetSequenceItem(DCM_ReferencedSOPSequence, instance).good());
    EXPECT_EQ(textOf(*instance, DCM_ReferencedSOPInstanceUID), textOf(image, DCM_SOPInstanceUID));
}

// Of the content tree, wherever it stands.
void forEachItem(DcmItem& item, const std::function<void(DcmItem&)>& visit) {
    visit(item);
    DcmSequenceOfItems* below = nullptr;
    if (item.findAndGetSequence(DCM_ContentSequence, below).bad()) return;
    for (unsigned long i = 0; i < below->card(); ++i) forEachItem(*below->getItem(i), visit);
}

TEST_F(MeasurementReportTest, ValuesKeepTheirLastBit) {
    const std::vector<double> values{0.0,      1.0 / 3.0, -1024.0 / 7.0, std::numbers::pi * 1e5,
                                     1e-300,   1.7e308,   -2.2e-308,     123456789.123456789,
                                     0.1 + 0.2};
    report_.measurements.clear();
    for (const double value : values)
        report_.measurements.push_back(
            length("Distance " + std::to_string(report_.measurements.size()), value));
    written();
    std::vector<double> exact;
    forEachItem(dataset(), [&](DcmItem& item) {
        if (textOf(item, DCM_ValueType) != "NUM") return;
        DcmItem* measured = nullptr;
        ASSERT_TRUE(item.findAndGetSequenceItem(DCM_MeasuredValueSequence, measured).good());
        const std::string decimal = textOf(*measured, DCM_NumericValue);
        EXPECT_LE(decimal.size(), 16u) << decimal;
        double value = 0.0;
        EXPECT_TRUE(measured->findAndGetFloat64(DCM_FloatingPointValue, value).good());
        EXPECT_NEAR(std::stold(decimal), value, 1e-8 * std::abs(value));
        exact.push_back(value);
    });
    EXPECT_EQ(exact, values);
}

TEST_F(MeasurementReportTest, TheFrameOfAFileOfSeveralIsNamed) {
    std::get<PointsOnImage>(report_.measurements[0].points).frame = 7;
    EXPECT_TRUE(has(written(), ",7)")) << written();
}

TEST_F(MeasurementReportTest, ALabelThatNeedsItMakesAllOfItUtf8) {
    report_.measurements[0].label = "Größe der Läsion";
    EXPECT_TRUE(has(written(), "Größe der Läsion"));
    EXPECT_EQ(textOf(dataset(), DCM_SpecificCharacterSet), "ISO_IR 192");
    EXPECT_EQ(textOf(dataset(), DCM_PatientName), "Müller^Anna");

    // 山田^太郎 as PS3.5 H.3 has it, with ideographs in the second group of components.
    setPatient("\\ISO 2022 IR 87", "Yamada^Tarou=\x1B$B;3ED\x1B(B^\x1B$BB@O:\x1B(B");
    report_.measurements[0].label = "病変";
    EXPECT_TRUE(has(written(), "病変"));
    EXPECT_EQ(textOf(dataset(), DCM_PatientName), "Yamada^Tarou=山田^太郎");
    EXPECT_EQ(textOf(dataset(), DCM_PatientID), "0042");
    const auto found = scan(path_);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->studies.size(), 1u);
    EXPECT_EQ(found->studies[0].patientName, "Yamada^Tarou=山田^太郎");

    report_.measurements[0].label = "line\nbreak \\ \"quotes\" <tag> \xff";
    written();
    EXPECT_EQ(textOf(dataset(), DCM_SpecificCharacterSet), "ISO_IR 192");
    EXPECT_TRUE(has(bytesOf(path_), "line\nbreak \\ \"quotes\" <tag> ÿ"));
}

TEST_F(MeasurementReportTest, OfNobodyNothingIsLeftOfThePatient) {
    owner_.isDeidentified = true;
    report_.measurements.push_back(region());
    const std::string text = written();
    EXPECT_EQ(textOf(dataset(), DCM_PatientIdentityRemoved), "YES");
    const std::string bytes = bytesOf(path_);
    for (const DcmTagKey& tag : {DCM_PatientName, DCM_PatientID, DCM_StudyInstanceUID, DCM_SeriesInstanceUID,
                                 DCM_SOPInstanceUID, DCM_AccessionNumber, DCM_FrameOfReferenceUID})
        EXPECT_FALSE(has(bytes, textOf(*original_.getDataset(), tag))) << tag.toString();
    EXPECT_TRUE(has(text, "NUM:(410668003,SCT,\"Length\")=\"12.5\""));
}

TEST_F(MeasurementReportTest, EachIsAnInstanceOfItsOwnOfTheSameFindings) {
    std::set<std::string> uids;
    for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(has(written(), uidFrom("Distance 1")));
        uids.insert({textOf(dataset(), DCM_SeriesInstanceUID), textOf(dataset(), DCM_SOPInstanceUID)});
    }
    EXPECT_EQ(uids.size(), 6u);
}

TEST_F(MeasurementReportTest, WithoutFrameOfReferenceThoseOnImagesAreWritten) {
    report_.series.frameOfReferenceUid.clear();
    for (const bool isDeidentified : {false, true}) {
        owner_.isDeidentified = isDeidentified;
        EXPECT_FALSE(has(written(), "112227"));
    }
}

TEST_F(MeasurementReportTest, WhatDoesNotFitIsRefusedAndWritesNothing) {
    const auto refused = [&](const MeasurementReport& report, const NewObject& owner, ErrorCode code) {
        const Result<void> done = writeMeasurementReport(path_, report, owner);
        ASSERT_FALSE(done.ok());
        EXPECT_EQ(done.error().code, code);
        EXPECT_FALSE(done.error().hint.empty());
        EXPECT_FALSE(has(done.error().message.english(), "ller"));
        EXPECT_FALSE(fs::exists(path_));
    };
    const auto refusedReport = [&](const std::function<void(MeasurementReport&)>& change) {
        MeasurementReport report = report_;
        change(report);
        refused(report, owner_, ErrorCode::usage);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    refusedReport([](MeasurementReport& r) { r.measurements.clear(); });
    refusedReport([](MeasurementReport& r) { r.series.images.clear(); });
    refusedReport([](MeasurementReport& r) { r.series.images[0].sopInstanceUid = "no UID"; });
    refusedReport([](MeasurementReport& r) { r.measurements[0].label.clear(); });
    refusedReport([](MeasurementReport& r) { r.measurements[0].numbers.clear(); });
    for (const double bad : {nan, infinity, -infinity}) {
        refusedReport([&](MeasurementReport& r) { r.measurements[0].numbers[0].value = bad; });
        refusedReport([&](MeasurementReport& r) {
            std::get<PointsOnImage>(r.measurements[0].points).pointsPx[1].y = bad;
        });
    }
    refusedReport([](MeasurementReport& r) {
        r.measurements[0].points = PointsInSpace{{{0, 0, 0}, {1e39, 0, 0}}};  // beyond float32
    });
    refusedReport([](MeasurementReport& r) {
        r.measurements[0].points = PointsInSpace{{{0, 0, 0}, {1, 0, 0}}};
        r.series.frameOfReferenceUid.clear();
    });
    refusedReport([](MeasurementReport& r) { std::get<PointsOnImage>(r.measurements[0].points).image = 1; });
    refusedReport([](MeasurementReport& r) { r.measurements[0].shape = ReportedShape::ellipse; });
    NewObject wrong = owner_;
    wrong.image.reset();
    refused(report_, wrong, ErrorCode::usage);
    wrong = owner_;
    wrong.image->sopInstanceUid += "1";
    refused(report_, wrong, ErrorCode::inputNotUsable);
    wrong = owner_;
    wrong.softwareVersion = "one\\two";
    refused(report_, wrong, ErrorCode::usage);
    const Result<void> nowhere = writeMeasurementReport(folder_ / "gone" / "a.dcm", report_, owner_);
    ASSERT_FALSE(nowhere.ok());
    EXPECT_EQ(nowhere.error().code, ErrorCode::outputNotWritable);
}

TEST_F(MeasurementReportTest, ToolsFindNoError) {
    report_.measurements.push_back(region());
    for (const bool isDeidentified : {false, true}) {
        owner_.isDeidentified = isDeidentified;
        report_.measurements[0].label = isDeidentified ? "Distance 1" : "Größe";
        ASSERT_TRUE(writeMeasurementReport(path_, report_, owner_).ok());
        expectOpensInDcmtk(path_);
        for (const char* tool : {"dsrdump", "dsr2xml", "dciodvfy"}) {
            if (std::system(fmt::format("command -v {} >/dev/null 2>&1", tool).c_str()) != 0) continue;
            const fs::path told = folder_ / "told.txt";
            const int status =
                std::system(fmt::format("{} '{}' >'{}' 2>&1", tool, path_.string(), told.string()).c_str());
            EXPECT_GT(fs::file_size(told), 0u);
            if (std::string_view(tool) != "dciodvfy") {
                EXPECT_EQ(status, 0);
            }
            std::istringstream lines(bytesOf(told));
            for (std::string line; std::getline(lines, line);) {
                // DCMTK up to 3.6.7 has no tables for UTF-8.
                if (line.ends_with("does not support this Specific Character Set: ISO_IR 192")) continue;
                for (const char* trouble : {"W: ", "E: ", "F: ", "Error"})
                    EXPECT_FALSE(has(line, trouble)) << tool << ": " << line;
            }
        }
    }
}

}  // namespace
}  // namespace macula::dicom::test

// macula read: documents as text and JSON, and the file that one holds.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/exit_codes.h"
#include "cli/run_command.h"
#include "synthetic.h"

namespace macula::cli {
namespace {

using dicom::test::nested;
using dicom::test::put;
using nlohmann::json;

class Read : public CommandTest {
  protected:
    void SetUp() override {
        CommandTest::SetUp();
        std::filesystem::create_directories(folder_ / "study");
        dicom::test::Shell report{.sopClassUid = UID_BasicTextSRStorage, .modality = "SR"};
        report.edits.push_back([](DcmItem& root) {
            put(root, DCM_PatientName, "DOE^JANE");
            put(root, DCM_ValueType, "CONTAINER");
            put(root, DCM_CompletionFlag, "COMPLETE");
            put(root, DCM_VerificationFlag, "UNVERIFIED");
            put(nested(root, DCM_ConceptNameCodeSequence), DCM_CodeMeaning, "Chest report");
            DcmItem& finding = dicom::test::appended(root, DCM_ContentSequence);
            put(finding, DCM_ValueType, "TEXT");
            put(nested(finding, DCM_ConceptNameCodeSequence), DCM_CodeMeaning, "Finding");
            put(finding, DCM_TextValue, "A nodule.");
        });
        dicom::test::writeShell(folder_ / "study/report.dcm", report);
    }
    void writePdf(const std::string& name) const {
        dicom::test::Shell shell{.sopClassUid = UID_EncapsulatedPDFStorage,
                                 .modality = "DOC",
                                 .sopInstanceUid = "2.25.3100",
                                 .seriesUid = "2.25.3101"};
        shell.edits.push_back([](DcmItem& root) {
            put(root, DCM_MIMETypeOfEncapsulatedDocument, "application/pdf");
            const std::string padded = std::string("%PDF-1.4 letter") + '\0';
            root.putAndInsertUint8Array(DCM_EncapsulatedDocument,
                                        reinterpret_cast<const Uint8*>(padded.data()), padded.size());
            root.putAndInsertUint32(DCM_EncapsulatedDocumentLength, 15);
        });
        dicom::test::writeShell(folder_ / name, shell);
    }
};

TEST_F(Read, AReportIsPrinted) {
    for (const std::string& path : {at("study"), at("study/report.dcm")}) {
        const Ran ran = runMacula({"read", path});
        ASSERT_EQ(ran.exitCode, kExitDone) << ran.err;
        EXPECT_NE(ran.out.find("Structured report: Chest report\n"), std::string::npos) << ran.out;
        EXPECT_NE(ran.out.find("DOE, JANE"), std::string::npos);
        EXPECT_NE(ran.out.find("Not verified by anybody."), std::string::npos);
        EXPECT_NE(ran.out.find("Finding: A nodule."), std::string::npos);
    }
    const json all = json::parse(runMacula({"read", at("study"), "--json"}).out);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0]["title"], "Chest report");
    EXPECT_EQ(all[0]["verified"], false);
    EXPECT_EQ(all[0]["entries"][0]["value"], "A nodule.");
}

TEST_F(Read, ThePdfOfADocumentIsWritten) {
    writePdf("study/letter.dcm");
    const Ran ran = runMacula({"read", at("study"), "-o", at("letter.pdf")});
    ASSERT_EQ(ran.exitCode, kExitDone) << ran.err;
    EXPECT_EQ(readAll(at("letter.pdf")), "%PDF-1.4 letter");
    EXPECT_NE(runMacula({"read", at("study"), "-o", at("letter.pdf")}).exitCode, kExitDone) << "it is there";
    EXPECT_EQ(runMacula({"read", at("study"), "-o", at("letter.pdf"), "--overwrite"}).exitCode, kExitDone);
}

TEST_F(Read, WhatCannotBeReadIsSaidInASentence) {
    const auto expectError = [](const Ran& ran, std::string_view words) {
        EXPECT_NE(ran.exitCode, kExitDone);
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
    };
    expectError(runMacula({"read", write("a.txt", "no DICOM")}), "no DICOM file");
    expectError(runMacula({"read", at("nowhere")}), "cannot be read");
    expectError(runMacula({"read", at("study"), "-o", at("a.pdf")}), "No document there holds a file");
    expectError(runMacula({"read", at("study"), "-o", "-"}), "standard output");
    std::filesystem::create_directories(folder_ / "empty");
    write("empty/a.txt", "nothing");
    EXPECT_NE(runMacula({"read", at("empty")}).exitCode, kExitDone);
}

}  // namespace
}  // namespace macula::cli

// Documents: made here with known words and numbers, and those of ../shared/data against values that were
// read without this code (truth/*.json).
#include "dicom/documents/read_document.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "dicom/documents/document_text.h"
#include "support.h"
#include "synthetic.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

void code(DcmItem& item, const DcmTagKey& sequence, const char* value, const char* scheme,
          const std::string& meaning) {
    DcmItem& made = nested(item, sequence);
    put(made, DCM_CodeValue, value);
    put(made, DCM_CodingSchemeDesignator, scheme);
    put(made, DCM_CodeMeaning, meaning);
}

DcmItem& child(DcmItem& parent, const char* type, const std::string& meaning,
               const char* relation = "CONTAINS") {
    DcmItem& item = appended(parent, DCM_ContentSequence);
    put(item, DCM_RelationshipType, relation);
    put(item, DCM_ValueType, type);
    if (!meaning.empty()) code(item, DCM_ConceptNameCodeSequence, "1", "99TEST", meaning);
    return item;
}

Shell reportShell(const char* title = "Chest report") {
    Shell shell{.sopClassUid = UID_ComprehensiveSRStorage, .modality = "SR"};
    shell.edits.push_back([title](DcmItem& root) {
        put(root, DCM_PatientName, "DOE^JANE");
        put(root, DCM_PatientID, "4711");
        put(root, DCM_ContentDate, "20240229");
        put(root, DCM_ContentTime, "140500");
        put(root, DCM_ValueType, "CONTAINER");
        put(root, DCM_CompletionFlag, "COMPLETE");
        put(root, DCM_VerificationFlag, "UNVERIFIED");
        code(root, DCM_ConceptNameCodeSequence, "1", "99TEST", title);
    });
    return shell;
}

std::string english(const Text& text) {
    return text.english();
}

class DocumentTest : public testing::Test {
  protected:
    StudyDocument read(const Shell& shell) {
        writeShell(folder_ / "document.dcm", shell);
        return read(folder_ / "document.dcm");
    }
    static StudyDocument read(const fs::path& file) {
        const auto document = readDocument(file);
        EXPECT_TRUE(document) << document.error().message.english();
        return document ? *document : StudyDocument{};
    }
    static std::string textOf(const StudyDocument& document) { return plainTextOf(document, english); }
    static bool has(const std::vector<Text>& sentences, std::string_view part) {
        return std::ranges::any_of(
            sentences, [&](const Text& each) { return each.english().find(part) != std::string::npos; });
    }
    static const DocumentEntry* entry(const StudyDocument& document, std::string_view heading) {
        for (const DocumentEntry& each : document.entries)
            if (each.heading.english() == heading) return &each;
        return nullptr;
    }
    TemporaryFolder folder_;
};

TEST_F(DocumentTest, AReportIsATreeOfHeadingsAndValues) {
    Shell shell = reportShell();
    shell.edits.push_back([](DcmItem& root) {
        DcmItem& findings = child(root, "CONTAINER", "Findings");
        put(child(findings, "TEXT", "Finding"), DCM_TextValue, "A nodule.\r\nIt is round.");
        DcmItem& size = child(findings, "NUM", "Diameter");
        DcmItem& value = nested(size, DCM_MeasuredValueSequence);
        put(value, DCM_NumericValue, "12.50");
        code(value, DCM_MeasurementUnitsCodeSequence, "mm", "UCUM", "millimeter");
        DcmItem& image = child(size, "IMAGE", "", "INFERRED FROM");
        DcmItem& sop = nested(image, DCM_ReferencedSOPSequence);
        put(sop, DCM_ReferencedSOPClassUID, UID_CTImageStorage);
        put(sop, DCM_ReferencedSOPInstanceUID, "2.25.17");
        code(child(root, "CODE", "Assessment"), DCM_ConceptCodeSequence, "2", "99TEST", "Benign");
        put(child(root, "PNAME", "Observer", "HAS OBS CONTEXT"), DCM_PersonName, "REED^ANNA^^DR");
        put(child(root, "DATETIME", "Seen"), DCM_DateTime, "20240229140530+0100");
    });
    const StudyDocument document = read(shell);
    EXPECT_EQ(document.kind, StudyDocument::Kind::report);
    EXPECT_EQ(document.title.english(), "Chest report");
    EXPECT_FALSE(document.isVerified);
    EXPECT_TRUE(has(document.status, "Not verified"));
    EXPECT_TRUE(has(document.status, "Complete."));
    EXPECT_TRUE(document.notes.empty());
    EXPECT_EQ(textOf(document),
              "Structured report: Chest report\n"
              "DOE, JANE, ID 4711\n"
              "2024-02-29, 14:05:00\n"
              "Complete.\n"
              "Not verified by anybody.\n"
              "\n"
              "Findings:\n"
              "  Finding:\n"
              "    A nodule.\n"
              "    It is round.\n"
              "  Diameter: 12.50 mm\n"
              "    Inferred from: CT image\n"
              "Assessment: Benign\n"
              "Observer: REED, ANNA, DR\n"
              "Seen: 2024-02-29 14:05:30 +0100\n");
    const DocumentEntry* size = entry(document, "Diameter");
    ASSERT_NE(size, nullptr);
    EXPECT_EQ(size->number, 12.5);
    EXPECT_EQ(size->place, "1.1.2");
    EXPECT_EQ(document.references(), (std::vector<DocumentReference>{{UID_CTImageStorage, "2.25.17", {}}}));
}

TEST_F(DocumentTest, WhoVerifiedItIsSaid) {
    Shell shell = reportShell();
    shell.edits.push_back([](DcmItem& root) {
        put(root, DCM_CompletionFlag, "PARTIAL");
        put(root, DCM_VerificationFlag, "VERIFIED");
        put(child(root, "TEXT", "Finding"), DCM_TextValue, "None.");
        DcmItem& observer = nested(root, DCM_VerifyingObserverSequence);
        put(observer, DCM_VerifyingObserverName, "REED^ANNA");
        put(observer, DCM_VerifyingOrganization, "St. Mary");
        put(observer, DCM_VerificationDateTime, "20240301");
    });
    const StudyDocument document = read(shell);
    EXPECT_TRUE(document.isVerified);
    EXPECT_TRUE(has(document.status, "Verified by REED, ANNA, St. Mary on 2024-03-01."));
    EXPECT_TRUE(has(document.status, "Partial"));
}

TEST_F(DocumentTest, LettersAreThoseOfTheCharacterSet) {
    Shell shell = reportShell();
    shell.edits.push_back([](DcmItem& root) {
        put(root, DCM_SpecificCharacterSet, "ISO_IR 144");  // Cyrillic
        put(root, DCM_PatientName, "\xbb\xee\xda\xd5\xe0\xdc\xd0\xdd");
        put(child(root, "TEXT", "Finding"), DCM_TextValue, "\xbd\xde\xe0\xdc\xd0");
    });
    const StudyDocument document = read(shell);
    EXPECT_EQ(entry(document, "Finding")->value.english(), "Норма");
    EXPECT_EQ(patientLineOf(document).english(), "Люкерман, ID 4711");
    Shell japanese = reportShell();
    japanese.edits.push_back([](DcmItem& root) {
        put(root, DCM_SpecificCharacterSet, "\\ISO 2022 IR 87");
        put(child(root, "TEXT", "Finding"), DCM_TextValue, "\x1b$B;3ED\x1b(B");
    });
    EXPECT_EQ(entry(read(japanese), "Finding")->value.english(), "山田");
}

TEST_F(DocumentTest, WhatIsNotValidIsSaidAndTheRestIsRead) {
    Shell shell = reportShell();
    shell.edits.push_back([](DcmItem& root) {
        child(root, "TEXT", "Nothing");
        child(root, "HOLOGRAM", "Unknown");
        DcmItem& number = nested(child(root, "NUM", "Size"), DCM_MeasuredValueSequence);
        put(number, DCM_NumericValue, "1e999");
        child(root, "IMAGE", "Nowhere");
        DcmItem& loop = child(root, "", "Loop");
        const std::array<Uint32, 2> self{1, 5};
        loop.putAndInsertUint32Array(DCM_ReferencedContentItemIdentifier, self.data(), 2);
        DcmItem& gone = child(root, "", "Gone");
        const std::array<Uint32, 3> nowhere{1, 77, 3};
        gone.putAndInsertUint32Array(DCM_ReferencedContentItemIdentifier, nowhere.data(), 3);
        DcmItem& odd = child(root, "SCOORD", "Odd");
        const std::array<Float32, 3> points{1, 2, 3};
        odd.putAndInsertFloat32Array(DCM_GraphicData, points.data(), 3);
        put(odd, DCM_GraphicType, "POLYLINE");
        put(child(root, "TEXT", "Controls"), DCM_TextValue,
            "a\x01"
            "b");
    });
    const StudyDocument document = read(shell);
    EXPECT_EQ(document.entries.size(), 8u);
    EXPECT_TRUE(has(document.notes, "no value"));
    EXPECT_TRUE(has(document.notes, "not shown"));
    EXPECT_TRUE(has(document.notes, "no number"));
    EXPECT_TRUE(has(document.notes, "lead nowhere"));
    EXPECT_TRUE(has(document.notes, "points that cannot be read"));
    EXPECT_FALSE(entry(document, "Size")->number);
    EXPECT_EQ(entry(document, "Size")->value.english(), "1e999");
    EXPECT_EQ(entry(document, "Gone")->value.english(), "See an item that is not there");
    EXPECT_EQ(entry(document, "Loop")->value.english().substr(0, 4), "See:");
    EXPECT_EQ(entry(document, "Controls")->value.english(), "ab");
}

TEST_F(DocumentTest, AHundredThousandEntriesAreCutWithANote) {
    Shell shell = reportShell();
    shell.edits.push_back([](DcmItem& root) {
        auto* sequence = new DcmSequenceOfItems(DCM_ContentSequence);
        for (int i = 0; i < 100'000; ++i) {
            auto* item = new DcmItem;
            item->putAndInsertString(DCM_ValueType, "TEXT");
            item->putAndInsertString(DCM_TextValue, "x");
            sequence->append(item);
        }
        ASSERT_TRUE(root.insert(sequence, true).good());
    });
    const StudyDocument document = read(shell);
    EXPECT_EQ(document.entries.size(), 10'000u);
    EXPECT_TRUE(has(document.notes, "larger than what is shown"));
}

// Written by hand: DCMTK would recurse.
TEST_F(DocumentTest, AHundredThousandNestedItemsAreRefused) {
    writeShell(folder_ / "deep.dcm", reportShell());
    std::ofstream file(folder_ / "deep.dcm", std::ios::binary | std::ios::app);
    const char sequence[] = "\x40\x00\x30\xa7SQ\0\0\xff\xff\xff\xff\xfe\xff\x00\xe0\xff\xff\xff\xff";
    for (int i = 0; i < 100'000; ++i) file.write(sequence, 20);
    file.close();
    const auto document = readDocument(folder_ / "deep.dcm");
    ASSERT_FALSE(document);
    EXPECT_EQ(document.error().code, ErrorCode::inputNotUsable);
    EXPECT_NE(document.error().message.english().find("nested deeper"), std::string::npos);
}

TEST_F(DocumentTest, OtherFilesAreRefused) {
    EXPECT_FALSE(readDocument(folder_ / "nothing.dcm"));
    std::ofstream(folder_ / "text.txt") << "no DICOM at all";
    const auto text = readDocument(folder_ / "text.txt");
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error().message.english(), "The file is no DICOM file.");
    writeShell(folder_ / "other.dcm", {.sopClassUid = UID_RTStructureSetStorage, .modality = "RTSTRUCT"});
    const auto other = readDocument(folder_ / "other.dcm");
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().code, ErrorCode::inputNotUsable);
    const auto bytes = readEncapsulatedFile(folder_ / "other.dcm");
    EXPECT_FALSE(bytes);
}

TEST_F(DocumentTest, AFileComesWithoutItsPadding) {
    for (const bool saysLength : {true, false}) {
        const std::string pdf = "%PDF-1.4 odd length!!";
        ASSERT_EQ(pdf.size() % 2, 1u);
        Shell shell{.sopClassUid = UID_EncapsulatedPDFStorage, .modality = "DOC"};
        shell.edits.push_back([&](DcmItem& root) {
            put(root, DCM_DocumentTitle, "Letter");
            put(root, DCM_MIMETypeOfEncapsulatedDocument, "application/pdf");
            const std::string padded = pdf + '\0';
            root.putAndInsertUint8Array(DCM_EncapsulatedDocument,
                                        reinterpret_cast<const Uint8*>(padded.data()), padded.size());
            if (saysLength) root.putAndInsertUint32(DCM_EncapsulatedDocumentLength, Uint32(pdf.size()));
        });
        const StudyDocument document = read(shell);
        EXPECT_EQ(document.kind, StudyDocument::Kind::file);
        EXPECT_EQ(document.title.english(), "Letter");
        ASSERT_TRUE(document.contents);
        EXPECT_EQ(document.contents->bytes, pdf.size());
        EXPECT_TRUE(document.notes.empty());
        const auto bytes = readEncapsulatedFile(document.file);
        ASSERT_TRUE(bytes);
        EXPECT_EQ(*bytes, pdf);
    }
}

TEST_F(DocumentTest, APdfThatIsNoneIsSaid) {
    Shell shell{.sopClassUid = UID_EncapsulatedPDFStorage, .modality = "DOC"};
    shell.edits.push_back([&](DcmItem& root) {
        put(root, DCM_MIMETypeOfEncapsulatedDocument, "application/pdf");
        const std::string program = "MZ a program";
        root.putAndInsertUint8Array(DCM_EncapsulatedDocument, reinterpret_cast<const Uint8*>(program.data()),
                                    program.size());
        root.putAndInsertUint32(DCM_EncapsulatedDocumentLength, 4000);
    });
    const StudyDocument document = read(shell);
    EXPECT_TRUE(has(document.notes, "does not begin as one"));
    EXPECT_TRUE(has(document.notes, "longer or shorter"));
}

class SharedDocuments : public DocumentTest {
  protected:
    static Json truth(const std::string& group) {
        return Json::parse(std::ifstream(sharedData() / "planar/truth" / (group + ".json")));
    }
};

TEST_F(SharedDocuments, ReportsHaveTheNumbersAndShapesOfTheTruth) {
    SKIP_WITHOUT_SHARED_DATA();
    std::size_t reports = 0;
    const Json all = truth("2_structured");  // outlives the loop
    for (const auto& [path, of] : all.items()) {
        if (!of.is_object() || !of.contains("sr")) continue;
        ++reports;
        const StudyDocument document = read(sharedData() / "planar" / path);
        const Json& sr = of["sr"];
        EXPECT_EQ(document.sopInstanceUid, of["sop_instance"]) << path;
        EXPECT_NE(sr["title"].get<std::string>().find("\"" + document.title.english() + "\""),
                  std::string::npos)
            << path;
        std::vector<double> numbers;
        std::vector<std::vector<double>> points;
        std::size_t images = 0;
        for (const DocumentEntry& each : document.entries) {
            if (each.number) numbers.push_back(*each.number);
            if (each.points) points.push_back(each.points->numbers);
            images += each.type == "IMAGE" ? 1 : 0;
        }
        const Json none = Json::array();
        const Json& trueNumbers = sr.contains("numbers") ? sr["numbers"] : none;
        ASSERT_EQ(numbers.size(), trueNumbers.size()) << path;
        for (std::size_t i = 0; i < numbers.size(); ++i)
            EXPECT_NEAR(numbers[i], trueNumbers[i]["value"].get<double>(), 1e-9) << path;
        const Json& truePoints = sr.contains("scoord") ? sr["scoord"] : none;
        ASSERT_EQ(points.size(), truePoints.size()) << path;
        for (std::size_t i = 0; i < points.size(); ++i) {
            ASSERT_EQ(points[i].size(), truePoints[i]["points"].size());
            for (std::size_t n = 0; n < points[i].size(); ++n)
                EXPECT_NEAR(points[i][n], truePoints[i]["points"][n].get<double>(), 1e-4) << path;
        }
        const std::size_t trueImages = sr.contains("images") ? sr["images"].size() : 0;
        EXPECT_EQ(images, trueImages) << path;
        const bool isVerified = sr.contains("verification") && sr["verification"] == "VERIFIED";
        EXPECT_EQ(document.isVerified, isVerified) << path;
    }
    EXPECT_GE(reports, 7u);
}

TEST_F(SharedDocuments, APlanSaysWhatTheTruthSays) {
    SKIP_WITHOUT_SHARED_DATA();
    for (const char* folder : {"made_rt_full_hfs", "rt_breast_dicompyler"}) {
        const std::string path = fmt::format("3_radiotherapy/{}/rtplan.dcm", folder);
        const Json plan = truth("3_radiotherapy")[path]["rtplan"];
        const StudyDocument document = read(sharedData() / "planar" / path);
        EXPECT_EQ(document.kind, StudyDocument::Kind::plan);
        EXPECT_EQ(document.title.english(), plan["label"]);
        const std::string text = textOf(document);
        const auto expect = [&](const std::string& line) {
            EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
        };
        for (const Json& dose : plan["prescription"])
            expect(fmt::format("Prescribed dose: {:.10g} Gy", dose.get<double>()));
        for (const Json& fractions : plan["fractions"])
            expect(fmt::format("Planned fractions: {}", fractions.get<int>()));
        for (const Json& beam : plan["beams"]) {
            expect(fmt::format("Beam {}: {}", beam["number"].get<int>(), beam["name"].get<std::string>()));
            expect(fmt::format("Energy: {:.10g} MV", beam["energy"].get<double>()));
            expect(fmt::format("Gantry angle: {:.1f}°", beam["gantry"].get<double>()));
            expect(fmt::format("Meterset: {:.10g} MU in fraction group 1",
                               beam["meterset_dose"][0].get<double>()));
            expect(fmt::format("Control points: {}", beam["control_points"].get<int>()));
        }
    }
}

TEST_F(SharedDocuments, APdfHasTheBytesOfTheTruth) {
    SKIP_WITHOUT_SHARED_DATA();
    const std::string path = "1_planar_and_cine/made_pdf_one_page.dcm";
    const Json made = truth("1_planar_and_cine")[path];
    const auto bytes = readEncapsulatedFile(sharedData() / "planar" / path);
    ASSERT_TRUE(bytes);
    EXPECT_EQ(bytes->size(), made["document_length_element"].get<std::size_t>());
    EXPECT_TRUE(beginsAsPdf(*bytes));
    const StudyDocument document = read(sharedData() / "planar" / path);
    EXPECT_EQ(document.contents->mimeType, "application/pdf");
}

}  // namespace
}  // namespace macula::dicom::test

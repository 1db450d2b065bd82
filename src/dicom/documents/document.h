// Documents of a study as text: structured reports, key object selections, radiotherapy plans, and documents
// of other formats in DICOM's clothes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/coded_name.h"
#include "base/text.h"
#include "dicom/read/patient.h"

namespace macula::dicom {

struct DocumentReference {
    std::string sopClassUid;
    std::string sopInstanceUid;
    std::vector<int> frames;  // from 1; none: all of them

    bool operator==(const DocumentReference&) const = default;
};

// How an entry relates to the one above it (PS3.3 C.17.3.2.4).
enum class DocumentRelation {
    contains,
    hasProperties,
    describes,  // a concept modifier
    observed,   // the context of an observation or an acquisition: who, when, of whom
    inferredFrom,
    selectedFrom,
};

// Points that a report draws. On an image pairs of (column, row), where (0.5, 0.5) is the middle of the first
// pixel (PS3.3 C.18.6.1.2); in space triples in mm of a frame of reference (C.18.9).
struct DrawnPoints {
    std::string type;  // "POLYLINE", "ELLIPSE"
    std::vector<double> numbers;
    bool isInSpace = false;
    std::string frameOfReferenceUid;  // in space
};

// Texts come from files and may name a patient: for the screen alone, as plain text; lines end with \n.
struct DocumentEntry {
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    std::size_t parent = kNone;
    int depth = 0;      // how many entries are above it
    std::string place;  // of a report: "1.2.3" (PS3.3 C.17.3.2.5)
    std::string type;   // of a report: "NUM", "IMAGE"; else empty
    DocumentRelation relation = DocumentRelation::contains;
    bool isSection = false;    // a heading of what is below it
    bool isTechnical = false;  // for programs: a UID, the language
    Text heading;              // what it is; may be empty
    Text value;                // may be empty
    CodedName name;            // of a report: the concept of the heading
    CodedName code;            // of a coded value, or the unit of a number
    std::optional<double> number;
    std::vector<DocumentReference> references;
    std::optional<DrawnPoints> points;
};

struct EncapsulatedFile {
    std::string mimeType;     // "application/pdf"
    std::uint64_t bytes = 0;  // without padding
};

struct StudyDocument {
    enum class Kind { report, keyObjects, plan, file };

    std::filesystem::path file;
    Kind kind = Kind::report;
    Text kindName;             // "Structured report"
    Text title;                // "Chest CT Report"; may be empty
    CodedName titleCode = {};  // of a report or a selection
    std::string sopClassUid, sopInstanceUid, studyInstanceUid;
    std::string patientName;  // components separated by ^
    PatientIdentity patient;
    std::string date, time;                    // of its content: YYYYMMDD and HHMMSS; may be empty
    std::vector<Text> status;                  // sentences: complete or not, verified by whom
    bool isVerified = false;                   // a person vouches for it: verified, or of a plan approved
    std::vector<DocumentEntry> entries;        // those above come before those below; in the order of reading
    std::vector<Text> notes;                   // sentences: what is not valid, or not shown
    std::optional<EncapsulatedFile> contents;  // of Kind::file

    // Instances that it refers to, each once, in the order of reading; of a selection those are the key
    // images.
    std::vector<DocumentReference> references() const;
};

// Whether objects of the class are documents that readDocument reads.
bool isDocument(std::string_view sopClassUid);

}  // namespace macula::dicom

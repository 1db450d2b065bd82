#include "dicom/documents/read_document.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <new>
#include <set>
#include <utility>

#include "base/exceptions.h"
#include "base/parsing.h"
#include "dicom/documents/document_tags.h"
#include "dicom/documents/document_values.h"
#include "dicom/documents/plan.h"
#include "dicom/documents/report.h"
#include "dicom/read/sop_class.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

namespace tags = document_tag;

constexpr std::string_view kReports = "1.2.840.10008.5.1.4.1.1.88.";
constexpr std::string_view kKeyObjects = "1.2.840.10008.5.1.4.1.1.88.59";
constexpr std::string_view kEncapsulated = "1.2.840.10008.5.1.4.1.1.104.";
constexpr std::string_view kPlan = "1.2.840.10008.5.1.4.1.1.481.5";
constexpr std::string_view kIonPlan = "1.2.840.10008.5.1.4.1.1.481.8";
constexpr std::size_t kMostBytes = std::size_t{1} << 30;  // of an encapsulated file

Error notReadable(const fs::path& file, Text why, Text hint) {
    return {ErrorCode::inputNotUsable, std::move(why), file.string(), std::move(hint)};
}

Error noMemory(const fs::path& file) {
    return {ErrorCode::outOfMemory, Text("There is not enough memory for the document."), file.string(),
            Text("Close other programs.")};
}

Result<Dataset> headerOf(const fs::path& file) {
    HeaderFile read = readHeader(file);
    if (read.header) return *std::move(read.header);
    const Text again = Text("Copy the file again from its source.");
    switch (read.state) {
        case FileState::notDicom:
            return notReadable(file, Text("The file is no DICOM file."),
                               Text("Choose a report, a plan or another document in DICOM."));
        case FileState::damaged:
        case FileState::truncated:
        case FileState::complete:
            return notReadable(
                file,
                Text("The document is damaged, or nested deeper than any real one, and cannot be read."),
                again);
        default:
            return notReadable(file, Text("The file cannot be read."),
                               Text("Check that the file or disc is still there."));
    }
}

// The file's bytes in the document, as DCMTK has them; null where there are none. `format` holds them.
const Uint8* bytesIn(DcmFileFormat& format, const fs::path& file, std::size_t& count) {
    if (!format.loadFile(file.c_str()).good()) return nullptr;
    DcmElement* element = nullptr;
    if (!format.getDataset()->findAndGetElement(DCM_EncapsulatedDocument, element).good() ||
        element == nullptr || element->getLength() > kMostBytes)
        return nullptr;
    Uint8* bytes = nullptr;
    if (!element->getUint8Array(bytes).good() || bytes == nullptr) return nullptr;
    count = element->getLength();
    return bytes;
}

// Without the one byte that makes the length even (PS3.3 C.24.2.1, PS3.5 6.2).
std::size_t lengthWithoutPadding(const Dataset& header, std::string_view bytes, bool& isContradicted) {
    const auto said = header.number(tags::kEncapsulatedLength);
    isContradicted = false;
    if (said) {
        if (*said == double(bytes.size()) || *said + 1.0 == double(bytes.size())) return std::size_t(*said);
        isContradicted = true;
    }
    return bytes.ends_with('\0') ? bytes.size() - 1 : bytes.size();
}

Result<std::string> encapsulatedIn(const Dataset& header, const fs::path& file, bool& isContradicted) {
    DcmFileFormat format;
    std::size_t count = 0;
    const Uint8* bytes = bytesIn(format, file, count);
    if (bytes == nullptr)
        return notReadable(file, Text("The document holds no file, or one that is too large to be read."),
                           Text("Get the document again from where it was made."));
    const std::string_view all(reinterpret_cast<const char*>(bytes), count);
    return std::string(all.substr(0, lengthWithoutPadding(header, all, isContradicted)));
}

void readFile(StudyDocument& document, const Dataset& header) {
    document.title = wordsOf(header, tags::kDocumentTitle);
    if (document.title.empty()) document.title = wordsOf(codeIn(header, tags::kConceptName));
    document.contents = EncapsulatedFile{.mimeType = inLines(header.shortText(tags::kMimeType)), .bytes = 0};
    bool isContradicted = false;
    const Result<std::string> bytes = encapsulatedIn(header, document.file, isContradicted);
    if (!bytes) {
        document.notes.push_back(bytes.error().message);
        return;
    }
    document.contents->bytes = bytes->size();
    if (isContradicted)
        document.notes.push_back(Text(
            "The document says that its file is longer or shorter than it is: the file may be cut off."));
    const bool isPdf = document.contents->mimeType == "application/pdf" ||
                       document.sopClassUid == "1.2.840.10008.5.1.4.1.1.104.1";
    if (isPdf && !beginsAsPdf(*bytes))
        document.notes.push_back(
            Text("The document calls its file a PDF, but the file does not begin as one."));
    const std::string verified = header.shortText(tags::kVerificationFlag);
    document.isVerified = verified == "VERIFIED";
    if (document.isVerified) document.status.push_back(Text("Verified."));
    if (verified == "UNVERIFIED") document.status.push_back(Text("Not verified by anybody."));
}

StudyDocument::Kind kindOf(std::string_view sopClassUid) {
    using Kind = StudyDocument::Kind;
    if (sopClassUid == kKeyObjects) return Kind::keyObjects;
    if (sopClassUid == kPlan || sopClassUid == kIonPlan) return Kind::plan;
    return sopClassUid.starts_with(kEncapsulated) ? Kind::file : Kind::report;
}

StudyDocument documentIn(const Dataset& header, const fs::path& file) {
    StudyDocument document;
    document.file = file;
    document.sopClassUid = header.shortText(tag::kSopClassUid);
    document.sopInstanceUid = header.shortText(tag::kSopInstanceUid);
    document.studyInstanceUid = header.shortText(tag::kStudyInstanceUid);
    document.kind = kindOf(document.sopClassUid);
    document.kindName = describeSopClass(document.sopClassUid);
    document.patientName = header.text(tag::kPatientName).value_or("");
    document.patient = patientIdentity(header);
    const bool isPlan = document.kind == StudyDocument::Kind::plan;
    document.date = inLines(header.shortText(isPlan ? Tag{0x300A, 0x0006} : tags::kContentDate));
    document.time = inLines(header.shortText(isPlan ? Tag{0x300A, 0x0007} : tags::kContentTime));
    switch (document.kind) {
        case StudyDocument::Kind::report:
        case StudyDocument::Kind::keyObjects:
            readReport(document, header);
            break;
        case StudyDocument::Kind::plan:
            readPlan(document, header);
            break;
        case StudyDocument::Kind::file:
            readFile(document, header);
            break;
    }
    if (header.charsetFallback())
        document.notes.push_back(
            Text("The document says another character set than it has: letters may be wrong."));
    return document;
}

}  // namespace

bool isDocument(std::string_view sopClassUid) {
    return sopClassUid.starts_with(kReports) || sopClassUid.starts_with(kEncapsulated) ||
           sopClassUid == kPlan || sopClassUid == kIonPlan;
}

std::vector<DocumentReference> StudyDocument::references() const {
    std::vector<DocumentReference> all;
    std::set<std::pair<std::string, std::vector<int>>> seen;
    for (const DocumentEntry& entry : entries) {
        for (const DocumentReference& each : entry.references) {
            if (seen.emplace(each.sopInstanceUid, each.frames).second) all.push_back(each);
        }
    }
    return all;
}

Result<StudyDocument> readDocument(const fs::path& file) try {
    MACULA_TRY(const Dataset header, headerOf(file));
    if (!isDocument(header.shortText(tag::kSopClassUid)))
        return notReadable(file, Text("The file is no report, plan or other document."),
                           Text("Choose a report, a plan or another document in DICOM."));
    return documentIn(header, file);
} catch (const std::bad_alloc&) {
    return noMemory(file);
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("read the document"));
}

std::string documentTitleOf(const Dataset& header) {
    const std::string sopClass = header.shortText(tag::kSopClassUid);
    if (!isDocument(sopClass)) return {};
    const StudyDocument::Kind kind = kindOf(sopClass);
    if (kind == StudyDocument::Kind::plan) return inLines(header.shortText(tags::kPlanLabel));
    std::string title;
    if (kind == StudyDocument::Kind::file) title = inLines(header.text(tags::kDocumentTitle).value_or(""));
    return title.empty() ? codeIn(header, tags::kConceptName).meaning : title;
}

Result<std::string> readEncapsulatedFile(const fs::path& file) try {
    MACULA_TRY(const Dataset header, headerOf(file));
    bool isContradicted = false;
    return encapsulatedIn(header, file, isContradicted);
} catch (const std::bad_alloc&) {
    return noMemory(file);
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("read the document"));
}

bool beginsAsPdf(std::string_view bytes) {
    constexpr std::size_t kWithin = 1024;
    return bytes.substr(0, kWithin).find("%PDF-") != std::string_view::npos;
}

}  // namespace macula::dicom

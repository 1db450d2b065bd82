#include "study/documents/listed_documents.h"

#include <memory>
#include <optional>
#include <utility>

#include "base/printable.h"
#include "dicom/documents/document_text.h"
#include "dicom/documents/read_document.h"
#include "dicom/scan.h"
#include "study/documents/image_places.h"
#include "study/open/found_volumes.h"

namespace macula::study {

namespace fs = std::filesystem;

namespace {

std::string inEnglish(const Text& text) {
    return text.english();
}

// `found` is null for one file.
std::string textOf(const dicom::StudyDocument& document, const FoundVolumes* found, int patient) {
    std::optional<ImagePlaces> places;
    if (found != nullptr) places.emplace(*found, patient);
    return plainTextOf(document, inEnglish, [&](const dicom::DocumentReference& reference) {
        const auto place = places ? places->of(reference) : std::nullopt;
        return place ? nameOf(*place).english() : printable(reference.sopInstanceUid);
    });
}

}  // namespace

Result<ListedDocuments> readDocuments(const fs::path& path, Progress& progress) {
    ListedDocuments listed;
    std::error_code error;
    if (!fs::is_directory(path, error)) {
        MACULA_TRY(dicom::StudyDocument document, dicom::readDocument(path));
        std::string text = textOf(document, nullptr, 0);
        listed.documents.push_back({std::move(document), std::move(text)});
        return listed;
    }
    MACULA_TRY(dicom::Scan scan, dicom::scanFolder(path, progress));
    const FoundVolumes found(std::move(scan));
    for (const dicom::Study& study : found.scan().studies) {
        for (const dicom::Series& series : study.series) {
            for (const dicom::OtherObject& object : series.objects) {
                if (!dicom::isDocument(object.sopClassUid)) continue;
                // One that cannot be read takes nothing from the others.
                Result<dicom::StudyDocument> document = dicom::readDocument(object.file);
                if (!document) {
                    listed.unreadable.push_back(document.error().message);
                    continue;
                }
                std::string text = textOf(*document, &found, study.patient);
                listed.documents.push_back({*std::move(document), std::move(text)});
            }
        }
    }
    if (listed.documents.empty())
        return Error{ErrorCode::inputNotUsable,
                     listed.unreadable.empty() ? Text("The folder holds no report, plan or other document.")
                                               : listed.unreadable.front(),
                     {},
                     Text("macula info lists what is in it.")};
    return listed;
}

Result<std::string> onlyFileOf(const ListedDocuments& listed) {
    const dicom::StudyDocument* holder = nullptr;
    for (const ListedDocument& each : listed.documents) {
        if (!each.document.contents) continue;
        if (holder != nullptr)
            return Error{ErrorCode::usage,
                         Text("Several documents there hold a file."),
                         {},
                         Text("Give the path of one of them instead of the folder.")};
        holder = &each.document;
    }
    if (holder == nullptr)
        return Error{ErrorCode::usage,
                     Text("No document there holds a file, such as a PDF."),
                     {},
                     Text("Read it without --output.")};
    return dicom::readEncapsulatedFile(holder->file);
}

}  // namespace macula::study

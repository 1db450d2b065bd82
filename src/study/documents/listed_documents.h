// The documents of a folder, or one file, read as text.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/text.h"
#include "dicom/documents/document.h"

namespace macula::study {

struct ListedDocument {
    dicom::StudyDocument document;
    // In English, as dicom::plainTextOf; images that it names by series and number where they are in the
    // folder, otherwise by UID.
    std::string text;
};

struct ListedDocuments {
    std::vector<ListedDocument> documents;  // in the order of the list of the folder
    std::vector<Text> unreadable;           // sentences about those that cannot be read
};

// Fails with inputNotUsable when there are none, or the one file cannot be read; with cancelled.
Result<ListedDocuments> readDocuments(const std::filesystem::path& path, Progress& progress);

// The bytes of the file that one of them holds (dicom::readEncapsulatedFile). Fails with usage when none of
// them holds one, or several do.
Result<std::string> onlyFileOf(const ListedDocuments& listed);

}  // namespace macula::study

// macula read PATH: the documents of a study as text, and the file that one of them holds.
//
// A document names its patient: whoever reads one has asked for that.
#include <CLI/App.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/printable.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/output_options.h"
#include "cli/shared/report.h"
#include "dicom/documents/document_text.h"
#include "dicom/documents/read_document.h"
#include "dicom/scan.h"
#include "pictures/output_files.h"
#include "study/documents/image_places.h"
#include "study/open/found_volumes.h"

namespace macula::cli {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct ReadOptions {
    fs::path path;
    fs::path output;
    bool overwrite = false;
    bool json = false;
};

std::string inEnglish(const Text& text) {
    return text.english();
}

Json toJson(const CodedName& code) {
    return {{"value", code.value}, {"scheme", code.scheme}, {"meaning", code.meaning}};
}

Json toJson(const dicom::DocumentReference& reference) {
    Json json{{"sopClassUid", reference.sopClassUid}, {"sopInstanceUid", reference.sopInstanceUid}};
    if (!reference.frames.empty()) json["frames"] = reference.frames;
    return json;
}

Json toJson(const dicom::DocumentEntry& entry) {
    Json json{{"depth", entry.depth}};
    if (!entry.place.empty()) json["place"] = entry.place;
    if (!entry.type.empty()) json["type"] = entry.type;
    json["heading"] = headingOf(entry).english();
    json["value"] = entry.value.english();
    if (!entry.name.value.empty()) json["name"] = toJson(entry.name);
    if (!entry.code.value.empty()) json[entry.type == "NUM" ? "unit" : "code"] = toJson(entry.code);
    if (entry.number) json["number"] = *entry.number;
    for (const dicom::DocumentReference& each : entry.references) json["references"].push_back(toJson(each));
    if (entry.points) {
        json["shape"] = entry.points->type;
        json[entry.points->isInSpace ? "pointsMm" : "pointsPx"] = entry.points->numbers;
        if (entry.points->isInSpace) json["frameOfReferenceUid"] = entry.points->frameOfReferenceUid;
    }
    return json;
}

std::string_view nameOf(dicom::StudyDocument::Kind kind) {
    using Kind = dicom::StudyDocument::Kind;
    switch (kind) {
        case Kind::report:
            return "report";
        case Kind::keyObjects:
            return "keyObjects";
        case Kind::plan:
            return "plan";
        case Kind::file:
            return "file";
    }
    return "report";
}

Json toJson(const dicom::StudyDocument& document) {
    Json json{{"kind", nameOf(document.kind)},
              {"kindName", document.kindName.english()},
              {"title", document.title.english()},
              {"sopClassUid", document.sopClassUid},
              {"sopInstanceUid", document.sopInstanceUid},
              {"studyInstanceUid", document.studyInstanceUid},
              {"patientName", document.patientName},
              {"patientId", document.patient.id},
              {"date", document.date},
              {"time", document.time},
              {"verified", document.isVerified},
              {"status", Json::array()},
              {"notes", Json::array()},
              {"entries", Json::array()}};
    for (const Text& each : document.status) json["status"].push_back(each.english());
    for (const Text& each : document.notes) json["notes"].push_back(each.english());
    for (const dicom::DocumentEntry& each : document.entries) json["entries"].push_back(toJson(each));
    if (document.contents)
        json["file"] = {{"mimeType", document.contents->mimeType}, {"bytes", document.contents->bytes}};
    return json;
}

struct Documents {
    std::shared_ptr<const study::FoundVolumes> found;  // the folder; null for one file
    std::vector<std::pair<fs::path, int>> files;       // with Study::patient
};

// The documents of a folder, in the order of its list; of a file that file.
Result<Documents> documentsIn(const fs::path& path) {
    std::error_code error;
    if (!fs::is_directory(path, error)) return Documents{{}, {{path, 0}}};
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(dicom::Scan scan, dicom::scanFolder(path, progress));
    Documents documents;
    documents.found = std::make_shared<const study::FoundVolumes>(std::move(scan));
    for (const dicom::Study& study : documents.found->scan().studies) {
        for (const dicom::Series& series : study.series) {
            for (const dicom::OtherObject& object : series.objects)
                if (dicom::isDocument(object.sopClassUid))
                    documents.files.emplace_back(object.file, study.patient);
        }
    }
    if (documents.files.empty())
        return Error{ErrorCode::inputNotUsable,
                     Text("The folder holds no report, plan or other document."),
                     {},
                     Text("macula info lists what is in it.")};
    return documents;
}

// As text; images that it names by series and number where they are in the folder, otherwise by UID.
std::string textOf(const dicom::StudyDocument& document, const Documents& in, int patient) {
    std::optional<study::ImagePlaces> places;
    if (in.found) places.emplace(*in.found, patient);
    return plainTextOf(document, inEnglish, [&](const dicom::DocumentReference& reference) {
        const auto place = places ? places->of(reference) : std::nullopt;
        return place ? nameOf(*place).english() : printable(reference.sopInstanceUid);
    });
}

Result<void> writeFileOf(const ReadOptions& options, const std::vector<dicom::StudyDocument>& documents) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<const dicom::StudyDocument*> withFile;
    for (const dicom::StudyDocument& each : documents)
        if (each.contents) withFile.push_back(&each);
    if (withFile.size() != 1)
        return Error{ErrorCode::usage,
                     withFile.empty() ? Text("No document there holds a file, such as a PDF.")
                                      : Text("Several documents there hold a file."),
                     {},
                     withFile.empty() ? Text("Read it without --output.")
                                      : Text("Give the path of one of them instead of the folder.")};
    MACULA_TRY(const std::string bytes, dicom::readEncapsulatedFile(withFile.front()->file));
    MACULA_TRY_VOID(writeTextAtomically(options.output, bytes));
    printWritten(options.output, start);
    return {};
}

Result<void> readAll(const ReadOptions& options) {
    if (options.output == "-")
        return Error{ErrorCode::usage,
                     Text("The file of a document is not written to standard output."),
                     {},
                     Text("Give --output the path of a new file.")};
    pictures::OutputFiles outputs(options.overwrite);
    outputs.read(options.path);
    MACULA_TRY_VOID(outputs.write(options.output));
    MACULA_TRY(const Documents in, documentsIn(options.path));
    std::vector<dicom::StudyDocument> documents;
    std::string text;
    for (const auto& [file, patient] : in.files) {
        Result<dicom::StudyDocument> document = dicom::readDocument(file);
        // In a folder, one that cannot be read takes nothing from the others.
        if (document) {
            text += (documents.empty() ? "" : "\n----\n\n") + textOf(*document, in, patient);
            documents.push_back(*std::move(document));
        } else if (in.files.size() == 1) {
            return document.error();
        } else {
            printWarning(document.error().message);
        }
    }
    if (options.json) {
        Json all = Json::array();
        for (const dicom::StudyDocument& each : documents) all.push_back(toJson(each));
        fmt::print("{}\n", jsonText(all));
    } else if (options.output.empty()) {
        fmt::print("{}", text);
    }
    return options.output.empty() ? Result<void>() : writeFileOf(options, documents);
}

}  // namespace

void addRead(CLI::App& app, Action& action) {
    auto options = std::make_shared<ReadOptions>();
    auto* command = app.add_subcommand(
        "read", "Print reports, radiotherapy plans and key image selections as text; names the patient");
    command->add_option("PATH", options->path, "A document in DICOM, or a folder with some")->required();
    command->add_flag("--json", options->json, "Print JSON");
    command->add_option("-o,--output", options->output,
                        "Write the file that a document holds, such as a PDF");
    addOverwrite(*command, options->overwrite);
    command->callback([options, &action] { action = [options] { return readAll(*options); }; });
}

}  // namespace macula::cli

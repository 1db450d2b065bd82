// macula read PATH: the documents of a study as text, and the file that one of them holds.
//
// A document names its patient: whoever reads one has asked for that.
#include <CLI/App.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/output_options.h"
#include "cli/shared/report.h"
#include "pictures/output_files.h"
#include "study/documents/document_json.h"
#include "study/documents/listed_documents.h"

namespace macula::cli {

namespace {

struct ReadOptions {
    std::filesystem::path path;
    std::filesystem::path output;
    bool overwrite = false;
    bool json = false;
};

void print(const study::ListedDocuments& listed, bool asJson) {
    auto all = nlohmann::ordered_json::array();
    for (const study::ListedDocument& each : listed.documents) {
        if (asJson)
            all.push_back(study::toJson(each.document));
        else
            fmt::print("{}{}", &each == &listed.documents.front() ? "" : "\n----\n\n", each.text);
    }
    if (asJson) fmt::print("{}\n", jsonText(all));
}

Result<void> readAll(const ReadOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    if (options.output == "-")
        return Error{ErrorCode::usage,
                     Text("The file of a document is not written to standard output."),
                     {},
                     Text("Give --output the path of a new file.")};
    pictures::OutputFiles outputs(options.overwrite);
    outputs.read(options.path);
    MACULA_TRY_VOID(outputs.write(options.output));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const study::ListedDocuments listed, study::readDocuments(options.path, progress));
    for (const Text& each : listed.unreadable) printWarning(each);
    if (options.json || options.output.empty()) print(listed, options.json);
    if (options.output.empty()) return {};
    MACULA_TRY(const std::string bytes, study::onlyFileOf(listed));
    MACULA_TRY_VOID(writeTextAtomically(options.output, bytes));
    printWritten(options.output, start);
    return {};
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

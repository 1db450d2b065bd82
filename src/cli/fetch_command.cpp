// macula fetch ARCHIVE: a study from an archive into the private folder of fetched studies.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <memory>

#include "base/progress_bar.h"
#include "cli/archive_options.h"
#include "cli/command.h"
#include "cli/query_options.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/report.h"
#include "study/archive/archive_json.h"

namespace macula::cli {

namespace {

struct FetchOptions : ArchiveOptions, QueryOptions {
    std::vector<std::string> series;
    std::filesystem::path into;
    bool all = false;
};

// Which studies the search means: one, unless all are wanted.
Result<std::vector<std::string>> studiesToFetch(net::Archive& archive, const FetchOptions& options,
                                                Progress& progress) {
    MACULA_TRY(const net::StudyQuery query, queryOf(options));
    if (isEmpty(query))
        return Error{ErrorCode::usage,
                     Text("It is not said which study to fetch."),
                     {},
                     Text("Give --accession or --study, or another key of macula find.")};
    MACULA_TRY(const net::StudyAnswers answers, archive.findStudies(query, progress));
    if (answers.studies.empty())
        return Error{ErrorCode::archiveNotUsable,
                     Text("The archive has no study that matches."),
                     {},
                     Text("Check the search with macula find.")};
    if (answers.studies.size() > 1 && !options.all)
        return Error{ErrorCode::usage,
                     Text("{} studies match.", answers.studies.size()),
                     {},
                     Text("Narrow the search, or fetch all of them with --all.")};
    std::vector<std::string> uids;
    for (const net::FoundStudy& study : answers.studies) uids.push_back(study.studyInstanceUid);
    return uids;
}

void printFetched(const study::FetchedStudy& fetched) {
    fmt::print("{}\n", fetched.folder.string());
    printNote(Text("{} images came, {} were there, of {}.", fetched.counts.kept, fetched.counts.hadAlready,
                   fetched.counts.promised));
    for (const Message& message : fetched.messages)
        printWarning(message.sentence.english() + " " + message.action.english());
}

Result<void> fetch(const FetchOptions& options) {
    MACULA_TRY(const OpenArchive open, openArchive(options));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const auto uids, studiesToFetch(*open.archive, options, progress));
    MACULA_TRY(study::Spool spool,
               options.into.empty() ? study::Spool::open() : study::Spool::chosen(options.into));
    auto json = nlohmann::ordered_json::array();
    std::size_t incomplete = 0;
    for (const std::string& uid : uids) {
        MACULA_TRY(
            const study::FetchedStudy fetched,
            study::fetchStudy(*open.archive, open.source.name, {uid, options.series}, spool, progress));
        json.push_back(study::toJson(fetched));
        incomplete += fetched.isComplete ? 0 : 1;
        if (!options.json) printFetched(fetched);
    }
    if (options.json) fmt::print("{}\n", jsonText(json));
    if (incomplete == 0) return {};
    return Error{ErrorCode::archiveNotUsable,
                 Text("Not all came of {} of {} studies.", incomplete, uids.size()),
                 {},
                 Text("Run the same command again: it fetches only what is missing.")};
}

}  // namespace

void addFetch(CLI::App& app, Action& action) {
    auto options = std::make_shared<FetchOptions>();
    auto* command = app.add_subcommand(
        "fetch", "Fetch a study from an archive (PACS), and print the folder where it lies then");
    addArchive(*command, *options);
    addQuery(*command, *options);
    command->add_option("--series", options->series, "Series Instance UIDs; without it, all series");
    command->add_option("--into", options->into,
                        "Folder for fetched studies; without it, a private one of yours");
    command->add_flag("--all", options->all, "Fetch all studies that match");
    command->callback([options, &action] { action = [options] { return fetch(*options); }; });
}

}  // namespace macula::cli

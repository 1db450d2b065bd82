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
#include "study/link/linked_studies.h"
#include "study/manifest/manifest_fetch.h"

namespace macula::cli {

namespace {

struct FetchOptions : ArchiveOptions, QueryOptions {
    std::vector<std::string> series;
    std::string link;
    std::filesystem::path manifest;
    std::filesystem::path into;
    bool all = false;
};

Result<void> refuseSeveral(std::size_t studies, const FetchOptions& options) {
    if (studies < 2 || options.all) return {};
    return Error{ErrorCode::usage,
                 Text("{} studies match.", studies),
                 {},
                 Text("Narrow the search, or fetch all of them with --all.")};
}

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
    MACULA_TRY_VOID(refuseSeveral(answers.studies.size(), options));
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

// Prints each study once it is there.
class Report {
  public:
    explicit Report(const FetchOptions& options) : options_(options) {}

    void add(const study::FetchedStudy& fetched) {
        json_.push_back(study::toJson(fetched));
        incomplete_ += fetched.isComplete ? 0 : 1;
        if (!options_.json) printFetched(fetched);
    }
    Result<void> end() const {
        if (options_.json) fmt::print("{}\n", jsonText(json_));
        if (incomplete_ == 0) return {};
        return Error{ErrorCode::archiveNotUsable,
                     Text("Not all came of {} of {} studies.", incomplete_, json_.size()),
                     {},
                     Text("Run the same command again: it fetches only what is missing.")};
    }

  private:
    const FetchOptions& options_;
    nlohmann::ordered_json json_ = nlohmann::ordered_json::array();
    std::size_t incomplete_ = 0;
};

Result<void> fetchSearched(const FetchOptions& options, study::Spool& spool, Progress& progress,
                           Report& report) {
    MACULA_TRY(const OpenArchive open, openArchive(options));
    MACULA_TRY(const auto uids, studiesToFetch(*open.archive, options, progress));
    for (const std::string& uid : uids) {
        MACULA_TRY(
            const study::FetchedStudy fetched,
            study::fetchStudy(*open.archive, open.source.name, {uid, options.series}, spool, progress));
        report.add(fetched);
    }
    return {};
}

// Whoever types a link means it: only the window asks.
Result<void> fetchLinked(const FetchOptions& options, study::Spool& spool, Progress& progress,
                         Report& report) {
    MACULA_TRY(study::StudyLink link, study::studyLinkOf(options.link));
    MACULA_TRY(const net::SourceList sources, readSourceList());
    if (!options.archive.empty()) link.archive = options.archive;
    for (const Text& notDone : link.notDone) printNote(notDone);
    MACULA_TRY(const study::LinkedStudies found, study::findLinked(link, sources, progress));
    for (const Text& remark : found.remarks) printWarning(remark);
    MACULA_TRY_VOID(refuseSeveral(found.studies.size(), options));
    for (const study::LinkedStudy& linked : found.studies) {
        ArchiveOptions named;
        named.archive = linked.archive;
        MACULA_TRY(const OpenArchive open, openArchive(named));
        const study::FetchRequest request{.studyInstanceUid = linked.study.studyInstanceUid,
                                          .seriesInstanceUids = options.series,
                                          .chosen = study::identityOf(linked.study)};
        MACULA_TRY(const study::FetchedStudy fetched,
                   study::fetchStudy(*open.archive, open.source.name, request, spool, progress));
        report.add(fetched);
    }
    return {};
}

Result<void> fetchManifested(const FetchOptions& options, study::Spool& spool, Progress& progress,
                             Report& report) {
    MACULA_TRY(const dicom::ImagingManifest manifest, dicom::readImagingManifest(options.manifest));
    MACULA_TRY(const net::SourceList sources, readSourceList());
    MACULA_TRY(const auto fetched, study::fetchManifest(manifest, sources, options.archive, spool, progress));
    for (const study::FetchedStudy& each : fetched) report.add(each);
    return {};
}

Result<void> fetch(const FetchOptions& options) {
    const bool searches = options.link.empty() && options.manifest.empty();
    if (searches && options.archive.empty())
        return Error{ErrorCode::usage,
                     Text("It is not said from which archive to fetch."),
                     {},
                     Text("Give the name of one, as macula pacs list prints it; or --link or --manifest.")};
    if (!searches && !isEmpty(options.query))
        return Error{ErrorCode::usage,
                     Text("A link or a manifest says itself which studies are meant."),
                     {},
                     Text("Leave the keys of the search out.")};
    MACULA_TRY(study::Spool spool,
               options.into.empty() ? study::Spool::open() : study::Spool::chosen(options.into));
    Progress progress(terminalProgressBar(), interruptToken());
    Report report(options);
    if (!options.link.empty()) {
        MACULA_TRY_VOID(fetchLinked(options, spool, progress, report));
    } else if (!options.manifest.empty()) {
        MACULA_TRY_VOID(fetchManifested(options, spool, progress, report));
    } else {
        MACULA_TRY_VOID(fetchSearched(options, spool, progress, report));
    }
    return report.end();
}

}  // namespace

void addFetch(CLI::App& app, Action& action) {
    auto options = std::make_shared<FetchOptions>();
    auto* command = app.add_subcommand(
        "fetch", "Fetch a study from an archive (PACS), and print the folder where it lies then");
    addArchive(*command, *options);
    command->get_option("ARCHIVE")->required(false);
    addQuery(*command, *options);
    CLI::Option* series =
        command->add_option("--series", options->series, "Series Instance UIDs; without it, all series");
    CLI::Option* link = command->add_option("--link", options->link,
                                            "What a link asks for: macula://open?study=UID, or an IHE Invoke "
                                            "Image Display; ARCHIVE may be left out then");
    command
        ->add_option("--manifest", options->manifest,
                     "What a file names that is an imaging manifest (IHE MADO, XDS-I.b); ARCHIVE may be left "
                     "out then")
        ->excludes(link)
        ->excludes(series);
    command->add_option("--into", options->into,
                        "Folder for fetched studies; without it, a private one of yours");
    command->add_flag("--all", options->all, "Fetch all studies that match");
    command->callback([options, &action] { action = [options] { return fetch(*options); }; });
}

}  // namespace macula::cli

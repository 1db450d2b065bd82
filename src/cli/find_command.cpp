// macula find ARCHIVE: the studies of an archive that match. Names patients: this is what was asked for.
#include <CLI/App.hpp>
#include <memory>

#include "base/printable.h"
#include "base/progress_bar.h"
#include "cli/archive_options.h"
#include "cli/command.h"
#include "cli/query_options.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/report.h"
#include "study/archive/archive_json.h"
#include "study/open/identity.h"

namespace macula::cli {

namespace {

struct FindOptions : ArchiveOptions, QueryOptions {
    bool series = false;
};

std::string orDash(const std::string& text) {
    return text.empty() ? "-" : printable(text);
}

void printStudy(const net::FoundStudy& study) {
    std::string modalities;
    for (const std::string& modality : study.modalities)
        modalities += (modalities.empty() ? "" : "\\") + modality;
    fmt::print(
        "{}  {}  {}  {}  {}\n    accession {}  images {}  {}\n", orDash(study::dateForPeople(study.date)),
        orDash(study::nameForPeople(study.patientName)), orDash(study.patientId), orDash(modalities),
        orDash(study.description), orDash(study.accessionNumber),
        study.instanceCount ? std::to_string(*study.instanceCount) : "-", orDash(study.studyInstanceUid));
}

void printSeries(const net::FoundSeries& series) {
    fmt::print("      series {}  {}  {}  images {}  {}\n",
               series.number ? std::to_string(*series.number) : "-", orDash(series.modality),
               orDash(series.description), series.instanceCount ? std::to_string(*series.instanceCount) : "-",
               orDash(series.seriesInstanceUid));
}

Result<void> find(const FindOptions& options) {
    MACULA_TRY(const net::StudyQuery query, queryOf(options));
    MACULA_TRY(const OpenArchive open, openArchive(options));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const net::StudyAnswers answers, open.archive->findStudies(query, progress));
    auto json = study::toJson(answers);
    for (std::size_t i = 0; i < answers.studies.size(); ++i) {
        if (!options.json) printStudy(answers.studies[i]);
        if (!options.series) continue;
        MACULA_TRY(const auto series,
                   open.archive->findSeries(answers.studies[i].studyInstanceUid, progress));
        json["studies"][i]["series"] = study::toJson(series);
        if (options.json) continue;
        for (const net::FoundSeries& each : series) printSeries(each);
    }
    if (options.json) fmt::print("{}\n", jsonText(json));
    if (answers.studies.empty() && !options.json) fmt::print("No study matches.\n");
    if (answers.isCutShort)
        printWarning(Text("There are more: only the first {} are listed. Narrow the search, or give --most.",
                          answers.studies.size()));
    if (answers.unusable > 0)
        printWarning(Text("{} answers of the archive are not usable, and are left out.", answers.unusable));
    return {};
}

}  // namespace

void addFind(CLI::App& app, Action& action) {
    auto options = std::make_shared<FindOptions>();
    auto* command =
        app.add_subcommand("find", "Search an archive (PACS) for studies; prints who the patients are");
    addArchive(*command, *options);
    addQuery(*command, *options);
    command->add_flag("--series", options->series, "Also list the series of each study");
    command->callback([options, &action] { action = [options] { return find(*options); }; });
}

}  // namespace macula::cli

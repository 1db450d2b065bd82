#include "study/link/linked_studies.h"

#include <algorithm>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "base/parsing.h"
#include "net/connect.h"
#include "study/archive/fetched_study.h"
#include "study/open/same_patient.h"

namespace macula::study {

namespace {

constexpr std::size_t kMostAnswers = 500;

// What one archive answered.
struct Answer {
    std::vector<net::FoundStudy> studies;
    std::size_t leftOut = 0;  // answers to another question
    bool isCutShort = false;
    std::optional<Error> error;
};

template <class T>
bool holds(const std::vector<T>& all, const T& one) {
    return std::ranges::find(all, one) != all.end();
}

std::string bare(const std::string& text) {
    return std::string(trimmed(text));
}

// An archive that ignores the accession number answers with everything.
bool isAskedFor(const StudyLink& link, const net::FoundStudy& study) {
    if (!link.studyInstanceUids.empty() && !holds(link.studyInstanceUids, study.studyInstanceUid))
        return false;
    const std::string accession = bare(study.accessionNumber);
    if (!link.accessionNumbers.empty() && !holds(link.accessionNumbers, accession)) return false;
    if (!link.patientId.empty() && bare(study.patientId) != link.patientId) return false;
    const std::string day = bare(study.date);
    if (!link.dateFrom.empty() && !day.empty() && day < link.dateFrom) return false;
    if (!link.dateTo.empty() && !day.empty() && day > link.dateTo) return false;
    Identity known;
    known.birthDate = link.patientBirthDate;
    if (samePatient(known, identityOf(study)) == SamePatient::no) return false;
    const bool hasModality = link.modalities.empty() || study.modalities.empty() ||
                             std::ranges::any_of(study.modalities, [&](const std::string& modality) {
                                 return holds(link.modalities, modality);
                             });
    return hasModality;
}

std::vector<net::StudyQuery> queriesOf(const StudyLink& link) {
    std::vector<net::StudyQuery> queries;
    net::StudyQuery query;
    query.mostAnswers = kMostAnswers;
    for (const std::string& uid : link.studyInstanceUids) {
        query.studyInstanceUid = uid;
        queries.push_back(query);
    }
    if (!queries.empty()) return queries;
    for (const std::string& number : link.accessionNumbers) {
        query.accessionNumber = number;
        queries.push_back(query);
    }
    if (!queries.empty()) return queries;
    query.patientId = link.patientId;
    query.dateFrom = link.dateFrom;
    query.dateTo = link.dateTo;
    return {query};
}

Result<void> ask(const StudyLink& link, const net::Source& source, const net::SourceList& sources,
                 Progress& progress, Answer& answer) {
    MACULA_TRY(const auto archive, net::archiveOf(sources, source));
    for (const net::StudyQuery& query : queriesOf(link)) {
        MACULA_TRY(net::StudyAnswers found, archive->findStudies(query, progress));
        answer.isCutShort = answer.isCutShort || found.isCutShort;
        for (net::FoundStudy& study : found.studies) {
            if (isAskedFor(link, study)) {
                answer.studies.push_back(std::move(study));
            } else {
                ++answer.leftOut;
            }
        }
    }
    return {};
}

std::vector<Answer> askAll(const StudyLink& link, const std::vector<net::Source>& asked,
                           const net::SourceList& sources, Progress& progress) {
    std::vector<Answer> answers(asked.size());
    progress.beginStage(asked.size() == 1 ? Text("Asking the archive for the study")
                                          : Text("Asking {} archives for the study", asked.size()),
                        asked.size());
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        threads.emplace_back([&, i] {
            Progress own({}, progress.token());
            const auto done = ask(link, asked[i], sources, own, answers[i]);
            if (!done) answers[i].error = done.error();
            progress.advance();
        });
    }
    threads.clear();
    return answers;
}

std::vector<Text> remarksOf(const std::vector<net::Source>& asked, const std::vector<Answer>& answers) {
    std::vector<Text> remarks;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const std::string& name = asked[i].name;
        if (answers[i].error)
            remarks.push_back(Text("{} could not be asked: {}", name, answers[i].error->message));
        if (answers[i].isCutShort) remarks.push_back(Text("{} has more studies that match.", name));
        if (answers[i].leftOut > 0)
            remarks.push_back(Text("{} also answered {} studies that the link does not ask for.", name,
                                   answers[i].leftOut));
    }
    return remarks;
}

Error nothingFits(const std::vector<net::Source>& asked, const std::vector<Answer>& answers,
                  std::vector<Text> remarks) {
    const auto failed = std::ranges::find_if(answers, [](const Answer& each) { return bool(each.error); });
    if (failed != answers.end() && asked.size() == 1) return *failed->error;
    const Text none = asked.size() == 1
                          ? Text("{} has no study that fits the link.", asked.front().name)
                          : Text("None of {} archives has a study that fits the link.", asked.size());
    remarks.insert(remarks.begin(), none);
    const Text hint =
        failed != answers.end()
            ? failed->error->hint
            : Text(
                  "Search for the study in the panel Archive or with macula find, or ask whoever made the "
                  "link.");
    return {ErrorCode::archiveNotUsable, Text::joined(std::move(remarks), " "), {}, hint};
}

}  // namespace

Result<std::vector<net::Source>> sourcesFor(const StudyLink& link, const net::SourceList& sources) {
    if (link.archive.empty() && !sources.all().empty()) return sources.all();
    MACULA_TRY(net::Source source, sources.find(link.archive));
    return std::vector<net::Source>{std::move(source)};
}

Result<LinkedStudies> findLinked(const StudyLink& link, const net::SourceList& sources, Progress& progress) {
    MACULA_TRY(const std::vector<net::Source> asked, sourcesFor(link, sources));
    std::vector<Answer> answers = askAll(link, asked, sources, progress);
    if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("The search was cancelled."), {}, {}};
    LinkedStudies found{.studies = {}, .remarks = remarksOf(asked, answers)};
    std::set<std::string> known;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        for (net::FoundStudy& study : answers[i].studies) {
            if (known.insert(study.studyInstanceUid).second)
                found.studies.push_back({asked[i].name, std::move(study)});
        }
    }
    if (found.studies.empty()) return nothingFits(asked, answers, std::move(found.remarks));
    std::ranges::stable_sort(found.studies, std::ranges::greater(), [](const LinkedStudy& each) {
        return std::pair(each.study.date, each.study.time);
    });
    if (link.mostRecent && found.studies.size() > *link.mostRecent) found.studies.resize(*link.mostRecent);
    return found;
}

}  // namespace macula::study

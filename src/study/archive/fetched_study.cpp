#include "study/archive/fetched_study.h"

#include <algorithm>
#include <atomic>
#include <ctime>
#include <utility>

namespace macula::study {

namespace {

std::string nowInUtc() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[32];
    const std::size_t length = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
    return std::string(text, length);
}

Result<net::FoundStudy> askForStudy(net::Archive& archive, const std::string& studyInstanceUid,
                                    Progress& progress) {
    MACULA_TRY(net::StudyAnswers answers,
               archive.findStudies({.studyInstanceUid = studyInstanceUid, .mostAnswers = 2}, progress));
    const auto found = std::find_if(
        answers.studies.begin(), answers.studies.end(),
        [&](const net::FoundStudy& study) { return study.studyInstanceUid == studyInstanceUid; });
    if (found == answers.studies.end())
        return Error{ErrorCode::archiveNotUsable,
                     Text("The archive has no such study."),
                     {},
                     Text("Search for it again: it may have been removed or merged.")};
    return *found;
}

TextArgument count(std::size_t value) {
    return {"count", static_cast<std::int64_t>(value)};
}

Message warningOf(std::string key, std::size_t number, Text sentence, Text action) {
    return {Severity::warning, std::move(key), {count(number)}, std::move(sentence), std::move(action)};
}

std::vector<Message> messagesOf(const net::Fetched& fetched, const SpooledStudy& study) {
    std::vector<Message> messages;
    if (!fetched.never.empty())
        messages.push_back(warningOf(
            "never-came", fetched.never.size(),
            Text("{} of {} images that the archive has did not come.", fetched.never.size(),
                 fetched.promised),
            Text("Fetch the study again, and tell the administrator of the archive if it stays so.")));
    if (study.ofOtherStudies() > 0)
        messages.push_back(
            warningOf("came-of-others", study.ofOtherStudies(),
                      Text("The archive sent {} images of another study or patient. They were not kept.",
                           study.ofOtherStudies()),
                      Text("Tell the administrator of the archive.")));
    if (study.unreadable() > 0)
        messages.push_back(warningOf(
            "came-unreadable", study.unreadable(),
            Text("{} objects that came cannot be read. They were not kept.", study.unreadable()),
            Text("Fetch the study again, and tell the administrator of the archive if it stays so.")));
    return messages;
}

}  // namespace

Identity identityOf(const net::FoundStudy& study) {
    return {.patientName = study.patientName,
            .patientId = study.patientId,
            .birthDate = study.patientBirthDate,
            .sex = study.patientSex,
            .studyDate = study.date,
            .studyDescription = study.description,
            .series = {},
            .isOfNobody = false,
            .studyInstanceUid = study.studyInstanceUid};
}

Result<FetchedStudy> fetchStudy(net::Archive& archive, const std::string& source, const FetchRequest& request,
                                Spool& spool, Progress& progress, const ArrivalListener& arrived) {
    MACULA_TRY(const net::FoundStudy asFound, askForStudy(archive, request.studyInstanceUid, progress));
    MACULA_TRY_VOID(spool.purge());
    MACULA_TRY(const std::unique_ptr<SpooledStudy> study, spool.study(request.studyInstanceUid));
    MACULA_TRY_VOID(study->expect(identityOf(asFound)));
    const net::Wanted wanted{.studyInstanceUid = request.studyInstanceUid,
                             .seriesInstanceUids = request.seriesInstanceUids,
                             .sopInstancesHad = study->instances()};
    std::atomic<std::size_t> instances{wanted.sopInstancesHad.size()};
    study->onKept([&] {
        const std::size_t now = ++instances;
        if (arrived) arrived({study->folder(), now});
    });

    SpoolRecord record;
    record.source = source;
    record.fetchedAt = nowInUtc();
    MACULA_TRY_VOID(study->finish(record));  // of whom the files are, should the program be killed
    auto fetched = archive.fetch(wanted, *study, progress);
    if (!fetched) return fetched.error();
    record.promised = fetched->promised;
    for (const net::FoundInstance& instance : fetched->never) record.never.push_back(instance.sopInstanceUid);
    const bool isWhole = request.seriesInstanceUids.empty() && fetched->never.empty();
    record.isComplete = isWhole && study->instances().size() >= fetched->promised;
    MACULA_TRY_VOID(study->finish(record));
    FetchedStudy result{.folder = study->folder(),
                        .counts = {},
                        .isComplete = record.isComplete,
                        .messages = messagesOf(*fetched, *study)};
    result.counts = *std::move(fetched);
    return result;
}

}  // namespace macula::study

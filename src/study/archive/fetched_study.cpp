#include "study/archive/fetched_study.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "base/utc_time.h"
#include "study/open/same_patient.h"

namespace macula::study {

namespace {

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

std::vector<Message> messagesOf(const FetchedStudy& fetched, const SpooledStudy& study) {
    const net::Fetched& counts = fetched.counts;
    const Text again("Fetch the study again, and tell the administrator of the archive if it stays so.");
    std::vector<Message> messages;
    if (!counts.never.empty())
        messages.push_back(warningOf(
            "never-came", counts.never.size(),
            Text("{} of {} images that the archive has did not come.", counts.never.size(), counts.promised),
            again));
    else if (!fetched.isComplete)
        messages.push_back(warningOf(
            "may-be-missing", study.instances().size(),
            Text("Images of this study may be missing: the archive did not say which it has, or sent fewer."),
            again));
    if (study.ofOtherStudies() > 0)
        messages.push_back(
            warningOf("came-of-others", study.ofOtherStudies(),
                      Text("The archive sent {} images of another study or patient. They were not kept.",
                           study.ofOtherStudies()),
                      Text("Tell the administrator of the archive.")));
    if (study.unreadable() > 0)
        messages.push_back(warningOf(
            "came-unreadable", study.unreadable(),
            Text("{} objects that came cannot be read. They were not kept.", study.unreadable()), again));
    return messages;
}

// What came before and after a fetch of some series is not all of the study: then the note stays as it was.
// So it does while a study that was complete is fetched again, unless the archive has more by now.
Result<void> note(SpooledStudy& study, const FetchRequest& request, SpoolRecord record) {
    const auto before = readSpoolRecord(study.folder());
    const bool isKnown = before && before->studyInstanceUid == request.studyInstanceUid;
    if (isKnown) record.senders = before->senders;
    const bool isStillComplete =
        isKnown && before->isComplete && record.promised > 0 && record.promised <= study.instances().size();
    if (isKnown && !record.isComplete && (isStillComplete || !request.seriesInstanceUids.empty()))
        record = *before;
    return study.finish(std::move(record));
}

bool hasAll(const net::Fetched& counts, const SpooledStudy& study, const FetchRequest& request,
            const net::FoundStudy& asFound) {
    if (!counts.isListWhole || !counts.never.empty()) return false;
    if (!request.seriesInstanceUids.empty()) return counts.kept + counts.hadAlready >= counts.promised;
    const std::size_t there = study.instances().size();
    return there >= counts.promised && there >= asFound.instanceCount.value_or(0);
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
    if (request.chosen && samePatient(*request.chosen, identityOf(asFound)) == SamePatient::no)
        return Error{
            ErrorCode::archiveNotUsable,
            Text("The archive names another patient for this study than the list or the manifest that it was "
                 "chosen from."),
            {},
            Text("Do not rely on either. Search again, and tell the administrator of the archive.")};
    MACULA_TRY(const std::unique_ptr<SpooledStudy> study,
               spool.study(request.studyInstanceUid, progress.token()));
    MACULA_TRY_VOID(spool.purge());
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
    record.fetchedAt = timeOfRecord();
    record.promised = asFound.instanceCount.value_or(0);
    record.asFound = asFound;
    MACULA_TRY_VOID(note(*study, request, record));  // should the program be killed
    FetchedStudy fetched{.folder = study->folder(), .counts = {}, .isComplete = false, .messages = {}};
    MACULA_TRY(fetched.counts, archive.fetch(wanted, *study, progress));
    fetched.isComplete = hasAll(fetched.counts, *study, request, asFound);
    fetched.messages = messagesOf(fetched, *study);
    record.promised = std::max(record.promised, fetched.counts.promised);
    for (const net::FoundInstance& instance : fetched.counts.never)
        record.never.push_back(instance.sopInstanceUid);
    record.isComplete = fetched.isComplete && request.seriesInstanceUids.empty();
    MACULA_TRY_VOID(note(*study, request, record));
    return fetched;
}

}  // namespace macula::study

#include "net/dimse/dimse_archive.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <string_view>
#include <utility>
#include <variant>

#include "net/archive/query_check.h"
#include "net/dimse/committing.h"
#include "net/dimse/connection_test.h"
#include "net/dimse/connector.h"
#include "net/dimse/fetch.h"
#include "net/dimse/find.h"
#include "net/dimse/send.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::net {

namespace {

constexpr std::size_t kMostPatientsKept = 100000;

// In the patient root model a study is found by its patient: the IDs of those that were searched for last.
class PatientsOfStudies {
  public:
    void keep(const std::vector<FoundStudy>& studies) {
        const std::lock_guard lock(mutex_);
        if (patients_.size() + studies.size() > kMostPatientsKept) patients_.clear();
        for (const FoundStudy& study : studies) patients_[study.studyInstanceUid] = study.patientId;
    }
    std::string of(const std::string& studyInstanceUid) const {
        const std::lock_guard lock(mutex_);
        const auto found = patients_.find(studyInstanceUid);
        return found == patients_.end() ? std::string() : found->second;
    }

  private:
    mutable std::mutex mutex_;
    std::map<std::string, std::string> patients_;
};

class DimseArchive : public Archive {
  public:
    explicit DimseArchive(Connector connector) : connector_(std::move(connector)) {}

    Result<StudyAnswers> findStudies(const StudyQuery& query, Progress& progress) override {
        const QuietToolkit quiet;
        MACULA_TRY_VOID(checkQuery(query));
        progress.beginStage(Text("Searching the archive"), 1);
        MACULA_TRY(Finder finder, Finder::open(connector_, progress.token()));
        Result<StudyAnswers> answers = finder.studies(query);
        if (answers && connector_.peer().patientRoot) patients_.keep(answers->studies);
        progress.advance();
        return answers;
    }

    Result<std::vector<FoundSeries>> findSeries(const std::string& studyInstanceUid,
                                                Progress& progress) override {
        const QuietToolkit quiet;
        MACULA_TRY_VOID(checkUid(studyInstanceUid));
        progress.beginStage(Text("Asking the archive for series"), 1);
        MACULA_TRY(Finder finder, Finder::open(connector_, progress.token()));
        MACULA_TRY(SeriesAnswers answers, finder.series(placeOf(studyInstanceUid)));
        progress.advance();
        return std::move(answers.series);
    }

    Result<std::vector<FoundInstance>> findInstances(const std::string& studyInstanceUid,
                                                     const std::string& seriesInstanceUid,
                                                     Progress& progress) override {
        const QuietToolkit quiet;
        MACULA_TRY_VOID(checkUid(studyInstanceUid));
        if (!seriesInstanceUid.empty()) MACULA_TRY_VOID(checkUid(seriesInstanceUid));
        MACULA_TRY(Finder finder, Finder::open(connector_, progress.token()));
        std::vector<std::string> series{seriesInstanceUid};
        // Archives need not search for instances without their series.
        if (seriesInstanceUid.empty()) {
            MACULA_TRY(const SeriesAnswers answers, finder.series(placeOf(studyInstanceUid)));
            series.clear();
            for (const FoundSeries& each : answers.series) series.push_back(each.seriesInstanceUid);
        }
        progress.beginStage(Text("Asking the archive for images"), std::max<std::size_t>(series.size(), 1));
        std::vector<FoundInstance> found;
        for (const std::string& each : series) {
            MACULA_TRY(InstanceAnswers answers, finder.instances(placeOf(studyInstanceUid), each,
                                                                 kMostInstancesOfStudy - found.size()));
            found.insert(found.end(), std::make_move_iterator(answers.instances.begin()),
                         std::make_move_iterator(answers.instances.end()));
            progress.advance();
            if (answers.isCutShort) return tooManyInstances();
        }
        return found;
    }

    Result<Fetched> fetch(const Wanted& wanted, Receiver& receiver, Progress& progress) override {
        const QuietToolkit quiet;
        return Fetch(connector_, wanted, placeOf(wanted.studyInstanceUid).patientId, receiver, progress)
            .run();
    }

    Result<Sent> send(std::span<const std::filesystem::path> files, Progress& progress) override {
        const QuietToolkit quiet;
        return Sending(connector_, files, progress).run();
    }

    Result<std::vector<Commitment>> commit(std::span<const std::filesystem::path> files,
                                           std::chrono::seconds patience, Progress& progress) override {
        const QuietToolkit quiet;
        return Committing(connector_, files, patience, progress).run();
    }

    std::vector<TestStep> test(Progress& progress) override {
        const QuietToolkit quiet;
        return testConnection(connector_, progress);
    }

  private:
    StudyPlace placeOf(const std::string& studyInstanceUid) const {
        return {studyInstanceUid, patients_.of(studyInstanceUid)};
    }

    Connector connector_;
    PatientsOfStudies patients_;
};

Error badSetting(Text message, Text hint) {
    return {ErrorCode::usage, std::move(message), {}, std::move(hint)};
}

}  // namespace

bool isAeTitle(std::string_view title) {
    return !title.empty() && title.size() <= 16 && title.find_first_not_of(' ') != std::string_view::npos &&
           std::ranges::all_of(title, [](char c) { return c >= 0x20 && c < 0x7f && c != '\\'; });
}

Result<void> checkDimsePeer(const DimsePeer& peer) {
    const Text titleHint("An AE title has 1 to 16 letters, digits and signs, without accents.");
    if (peer.host.empty() || peer.host.find_first_of(" /\\") != std::string::npos)
        return badSetting(Text("The archive has no host name that could be looked for."),
                          Text("Enter a host name or an IP address alone, without a port."));
    if (peer.port == 0)
        return badSetting(Text("The archive has no port."), Text("Enter a number from 1 to 65535."));
    if (!isAeTitle(peer.calledAe)) return badSetting(Text("The archive's AE title is not valid."), titleHint);
    if (!isAeTitle(peer.callingAe))
        return badSetting(Text("The AE title of this program is not valid."), titleHint);
    if (!peer.receiverAe.empty() && !isAeTitle(peer.receiverAe))
        return badSetting(Text("The AE title of this program's receiver is not valid."), titleHint);
    if (peer.retrieve == Retrieve::move && peer.receiverPort == 0)
        return badSetting(Text("Fetching by C-MOVE needs a port at which this program receives."),
                          Text("Enter a receiver's port, or let the program choose how to fetch."));
    if (peer.tls.certificate.empty() && !peer.tls.key.empty())
        return badSetting(Text("There is a key, but no certificate that it belongs to."),
                          Text("Enter the certificate of this program too."));
    return {};
}

std::unique_ptr<Archive> makeDimseArchive(const Source& source, const Secrets& secrets) {
    return std::make_unique<DimseArchive>(
        Connector(std::get<DimsePeer>(source.peer), secrets, source.connectTimeout, source.answerTimeout));
}

}  // namespace macula::net

#include "study/archive/received_studies.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "base/printable.h"
#include "dicom/stack/examination.h"
#include "net/archive/file_meta.h"
#include "study/open/file_identity.h"

namespace macula::study {

namespace fs = std::filesystem;
using Verdict = net::Receiver::Verdict;

namespace {

constexpr std::size_t kMostSenders = 16;
constexpr std::size_t kMostModalities = 16;

Error tooManyStudies(const ReceptionLimits& limits) {
    return {ErrorCode::archiveNotUsable,
            Text("More than {} new studies were sent within {} hours.", limits.mostStudies,
                 std::chrono::ceil<std::chrono::hours>(limits.counted).count()),
            {},
            Text("Look at what was sent. Macula takes more later, or when it begins to receive again.")};
}

}  // namespace

// Its mutex is never waited for while that of ReceivedStudies is held.
struct ReceivedStudies::Arriving {
    explicit Arriving(std::string uid) : studyInstanceUid(std::move(uid)) {}

    void note(const dicom::Examination& found, const std::string& sender) {
        if (senders.size() < kMostSenders) senders.insert(sender);
        if (!found.modality.empty() && modalities.size() < kMostModalities) modalities.insert(found.modality);
        if (identity.studyInstanceUid.empty()) identity = identityOf(found);
    }

    const std::string studyInstanceUid;
    std::mutex mutex;
    bool isFinished = false;  // whoever waited for the mutex needs a new one
    std::unique_ptr<SpooledStudy> study;
    SpoolRecord record;
    std::set<std::string> senders;
    Identity identity;
    std::set<std::string> modalities;
    std::optional<Clock::time_point> counted;  // in begun_
    std::size_t kept = 0;
    std::size_t hadAlready = 0;
    std::size_t refused = 0;
    std::size_t otherContents = 0;
    // Under the mutex of ReceivedStudies.
    std::size_t came = 0;
    Clock::time_point last = Clock::now();
};

std::vector<Message> ReceivedStudies::messagesOf(const Arriving& arriving) {
    std::vector<Message> messages;
    const auto warn = [&](std::string key, std::size_t number, Text sentence) {
        if (number > 0)
            messages.push_back({Severity::warning,
                                std::move(key),
                                {{"count", static_cast<std::int64_t>(number)}},
                                std::move(sentence),
                                Text("Tell the administrator of the machine that sent them.")});
    };
    warn("came-of-others", arriving.refused,
         Text("{} objects came that name another patient than the rest of this study. They were not kept.",
              arriving.refused));
    warn("came-with-other-contents", arriving.otherContents,
         Text("{} objects came again with other contents. Those that came first were kept.",
              arriving.otherContents));
    return messages;
}

// What comes over one association.
class ReceivedStudies::FromCaller : public net::Receiver {
  public:
    FromCaller(ReceivedStudies& all, std::string sender) : all_(all), sender_(std::move(sender)) {}

    Result<fs::path> place() override {
        Result<fs::path> place = all_.files_.place();
        if (!place) return all_.noted(place.error());
        return place;
    }
    Result<Verdict> take(const fs::path& file, const net::InstanceKey& promised) override {
        Result<Verdict> verdict = all_.take(file, promised, sender_);
        if (!verdict) return all_.noted(verdict.error());
        return verdict;
    }
    void drop(const fs::path& file) noexcept override { all_.files_.drop(file); }
    std::uintmax_t mostBytesOfInstance() const override { return all_.files_.mostBytesOfFile(); }

  private:
    ReceivedStudies& all_;
    const std::string sender_;
};

Result<std::unique_ptr<ReceivedStudies>> ReceivedStudies::into(Spool& spool, const ReceptionLimits& limits) {
    MACULA_TRY([[maybe_unused]] const fs::path folder, ArrivingFiles::prepareFolder(spool.folder()));
    return std::unique_ptr<ReceivedStudies>(new ReceivedStudies(spool, limits));
}

ReceivedStudies::ReceivedStudies(Spool& spool, const ReceptionLimits& limits)
    : spool_(spool), limits_(limits), files_(spool.folder(), spool.limits()) {}

ReceivedStudies::~ReceivedStudies() = default;

std::unique_ptr<net::Receiver> ReceivedStudies::receiverFor(const net::Caller& caller) {
    return std::make_unique<FromCaller>(*this, printable(caller.ae.empty() ? caller.address : caller.ae));
}

Error ReceivedStudies::noted(const Error& error) {
    const std::lock_guard lock(mutex_);
    trouble_ = error;
    return error;
}

std::optional<Error> ReceivedStudies::takeTrouble() {
    const std::lock_guard lock(mutex_);
    return std::exchange(trouble_, std::nullopt);
}

Result<Verdict> ReceivedStudies::take(const fs::path& file, const net::InstanceKey& promised,
                                      const std::string& sender) {
    const std::optional<Draft> draft = files_.take(file);  // what is not kept goes with it
    const dicom::Examination found = dicom::examine(file);
    const bool isPromised = promised.sopInstanceUid == found.sopInstanceUid;
    if (!isWorthKeeping(found) || !isPromised || !net::isUid(found.studyInstanceUid)) {
        ++unreadable_;
        return Verdict::refused;
    }
    while (true) {
        MACULA_TRY(const std::shared_ptr<Arriving> arriving, arrivingOf(found.studyInstanceUid));
        const std::lock_guard lock(arriving->mutex);
        if (arriving->isFinished) continue;
        MACULA_TRY_VOID(open(*arriving, sender));
        MACULA_TRY(Verdict verdict, arriving->study->keep(file, found));
        switch (verdict) {
            case Verdict::kept:
                ++arriving->kept;
                break;
            case Verdict::hadAlready:
                if (!arriving->study->hasSame(file, found.sopInstanceUid)) {
                    ++arriving->otherContents;
                    verdict = Verdict::refused;  // the sender must not take it for stored
                    break;
                }
                ++arriving->hadAlready;
                break;
            case Verdict::refused:
                ++arriving->refused;
                break;
        }
        if (verdict != Verdict::refused) arriving->note(found, sender);
        const std::lock_guard own(mutex_);
        if (verdict == Verdict::kept) ++arriving->came;
        // Who only repeats what is refused holds no study open.
        if (verdict != Verdict::refused) arriving->last = Clock::now();
        return verdict;
    }
}

Result<std::shared_ptr<ReceivedStudies::Arriving>> ReceivedStudies::arrivingOf(
    const std::string& studyInstanceUid) {
    bool isCrowded = false;
    {
        const std::lock_guard lock(mutex_);
        const auto found = studies_.find(studyInstanceUid);
        if (found != studies_.end()) return found->second;
        isCrowded = studies_.size() >= limits_.mostStudiesAtOnce;
    }
    if (isCrowded) finishOldest();
    const std::lock_guard lock(mutex_);
    auto& arriving = studies_[studyInstanceUid];
    if (!arriving) arriving = std::make_shared<Arriving>(studyInstanceUid);
    return arriving;
}

Result<void> ReceivedStudies::open(Arriving& arriving, const std::string& sender) {
    if (arriving.study) return {};
    MACULA_TRY_VOID(countNew(arriving));
    MACULA_TRY(std::unique_ptr<SpooledStudy> study, spool_.study(arriving.studyInstanceUid));
    MACULA_TRY_VOID(spool_.purge());
    auto before = readSpoolRecord(study->folder());
    if (before && before->studyInstanceUid == arriving.studyInstanceUid) {
        arriving.record = *std::move(before);
        arriving.senders = {arriving.record.senders.begin(), arriving.record.senders.end()};
    } else {
        arriving.record = {
            .studyInstanceUid = arriving.studyInstanceUid, .senders = {sender}, .fetchedAt = timeOfRecord()};
        MACULA_TRY_VOID(writeSpoolRecord(study->folder(), arriving.record));  // should the program be killed
    }
    arriving.study = std::move(study);
    return {};
}

// A sender without end must not fill the disk with folders.
Result<void> ReceivedStudies::countNew(Arriving& arriving) {
    std::error_code failure;
    if (arriving.counted || fs::exists(spool_.folderOf(arriving.studyInstanceUid), failure)) return {};
    const std::lock_guard lock(mutex_);
    const Clock::time_point now = Clock::now();
    while (!begun_.empty() && begun_.front() <= now - limits_.counted) begun_.pop_front();
    if (begun_.size() >= limits_.mostStudies) return tooManyStudies(limits_);
    begun_.push_back(now);
    arriving.counted = now;
    return {};
}

void ReceivedStudies::finish(const std::shared_ptr<Arriving>& arriving) {
    const std::lock_guard lock(arriving->mutex);
    if (arriving->isFinished) return;
    arriving->isFinished = true;
    std::optional<ReceivedStudy> finished;
    bool isForgotten = true;
    if (arriving->study) {
        const std::size_t instances = arriving->study->instances().size();
        const fs::path folder = arriving->study->folder();
        std::vector<std::string> senders(arriving->senders.begin(), arriving->senders.end());
        arriving->record.senders = senders;
        // More came than the archive had: nobody says whether that is all of it.
        if (arriving->kept > 0) arriving->record.isComplete = false;
        if (arriving->kept > 0 && arriving->record.source.empty())
            arriving->record.fetchedAt = timeOfRecord();
        if (instances > 0) {
            isForgotten = false;
            const Result<void> written = arriving->study->finish(arriving->record);
            if (!written) noted(written.error());
            finished = ReceivedStudy{.folder = folder,
                                     .identity = arriving->identity,
                                     .modalities = arriving->modalities,
                                     .senders = std::move(senders),
                                     .kept = arriving->kept,
                                     .hadAlready = arriving->hadAlready,
                                     .refused = arriving->refused,
                                     .otherContents = arriving->otherContents,
                                     .instances = instances,
                                     .messages = messagesOf(*arriving)};
        } else {
            std::error_code ignored;
            if (fs::remove(folder, ignored)) fs::remove(spoolRecordFile(folder), ignored);
        }
        arriving->study.reset();
    }
    const std::lock_guard own(mutex_);
    studies_.erase(arriving->studyInstanceUid);
    if (isForgotten && arriving->counted) {
        const auto counted = std::ranges::find(begun_, *arriving->counted);
        if (counted != begun_.end()) begun_.erase(counted);
    }
    if (finished) finished_.push_back(*std::move(finished));
}

std::vector<std::shared_ptr<ReceivedStudies::Arriving>> ReceivedStudies::quietSince(
    Clock::time_point time) const {
    const std::lock_guard lock(mutex_);
    std::vector<std::shared_ptr<Arriving>> quiet;
    for (const auto& [uid, arriving] : studies_) {
        if (arriving->last <= time) quiet.push_back(arriving);
    }
    std::ranges::sort(quiet, {}, &Arriving::last);
    return quiet;
}

void ReceivedStudies::finishOldest() {
    const auto open = quietSince(Clock::now());
    if (!open.empty()) finish(open.front());
}

ArrivingStudies ReceivedStudies::arriving() const {
    const std::lock_guard lock(mutex_);
    ArrivingStudies now;
    for (const auto& [uid, arriving] : studies_) {
        if (arriving->came == 0) continue;
        ++now.studies;
        now.images += arriving->came;
    }
    return now;
}

std::vector<ReceivedStudy> ReceivedStudies::takeFinished() {
    const std::lock_guard lock(mutex_);
    return std::exchange(finished_, {});
}

std::vector<ReceivedStudy> ReceivedStudies::finishQuiet() {
    for (const auto& arriving : quietSince(Clock::now() - limits_.quiet)) finish(arriving);
    return takeFinished();
}

std::vector<ReceivedStudy> ReceivedStudies::finishAll() {
    for (const auto& arriving : quietSince(Clock::now())) finish(arriving);
    return takeFinished();
}

}  // namespace macula::study

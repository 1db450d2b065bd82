#include "net/dimse/incoming.h"

#include <algorithm>
#include <utility>

#include "net/archive/file_meta.h"
#include "net/dimse/instance_arrival.h"

namespace macula::net {

namespace {

constexpr std::size_t kMostUnpromised = 200'000;
constexpr std::size_t kSpareArrivals = 1000;

Error diskTrouble() {
    return {ErrorCode::outputNotWritable,
            Text("An instance from the archive could not be written."),
            {},
            Text("Make room on the disk, and fetch again: what has come is kept.")};
}

Error farTooMuch() {
    return archiveError(Text("The archive sends far more instances than it says it has."),
                        Text("Ask the administrator of the archive what its log says about this study."));
}

}  // namespace

Incoming::Incoming(const Wanted& wanted, Receiver& receiver, Progress& progress)
    : wanted_(wanted), receiver_(receiver), progress_(progress) {}

void Incoming::expect(const std::map<std::string, FoundInstance>& promised) {
    const std::lock_guard lock(mutex_);
    promised_ = promised;
}

std::optional<Error> Incoming::failure() const {
    const std::lock_guard lock(mutex_);
    return failure_;
}

bool Incoming::isSettled(const std::string& sopInstanceUid) const {
    const std::lock_guard lock(mutex_);
    return taken_.contains(sopInstanceUid) || refused_.contains(sopInstanceUid);
}

std::size_t Incoming::steps() const {
    const std::lock_guard lock(mutex_);
    return steps_;
}

std::size_t Incoming::arrived() const {
    const std::lock_guard lock(mutex_);
    return arrived_;
}

Fetched Incoming::counts() const {
    const std::lock_guard lock(mutex_);
    return counts_;
}

std::size_t Incoming::distinct() const {
    const std::lock_guard lock(mutex_);
    return taken_.size() + counts_.refused;
}

bool Incoming::cameAgain(const std::string& sopInstanceUid) const {
    const std::lock_guard lock(mutex_);
    return had_.contains(sopInstanceUid);
}

// With each try, instances may come again.
bool Incoming::isTooMuch() const {
    const std::lock_guard lock(mutex_);
    return arrived_ >= (promised_.empty() ? kMostUnpromised : kSpareArrivals + 2 * promised_.size());
}

void Incoming::count(const std::string& sopInstanceUid, Outcome outcome) {
    const std::lock_guard lock(mutex_);
    ++arrived_;
    bool isNew = false;
    switch (outcome) {
        case Outcome::kept:
            ++counts_.kept;
            isNew = taken_.insert(sopInstanceUid).second;
            break;
        case Outcome::hadAlready:
            if (had_.insert(sopInstanceUid).second) ++counts_.hadAlready;
            isNew = taken_.insert(sopInstanceUid).second && promised_.contains(sopInstanceUid);
            break;
        case Outcome::refused:
            // One that was too large comes again with each try; it is one all the same.
            isNew = !isUid(sopInstanceUid) || refused_.insert(sopInstanceUid).second;
            if (isNew) ++counts_.refused;
            isNew = isNew && promised_.contains(sopInstanceUid) && !taken_.contains(sopInstanceUid);
            break;
    }
    if (isNew) {
        ++steps_;
        progress_.advance();
    }
}

Incoming::Stored Incoming::fail(const Error& error) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = error;
    return {{}, error};
}

Incoming::Stored Incoming::take(const std::filesystem::path& file, const Command& command) {
    InstanceKey key{wanted_.studyInstanceUid, {}, command.sopClassUid, command.sopInstanceUid};
    {
        const std::lock_guard lock(mutex_);
        const auto promised = promised_.find(command.sopInstanceUid);
        if (promised != promised_.end()) key.seriesInstanceUid = promised->second.seriesInstanceUid;
    }
    const Result<Receiver::Verdict> verdict = receiver_.take(file, key);
    if (!verdict) return fail(verdict.error());
    switch (*verdict) {
        case Receiver::Verdict::kept:
            return {Outcome::kept, {}};
        case Receiver::Verdict::hadAlready:
            return {Outcome::hadAlready, {}};
        case Receiver::Verdict::refused:
            break;
    }
    return {Outcome::refused, {}};
}

Incoming::Stored Incoming::write(Association& association, const ReceivedCommand& request) {
    using Fate = ArrivedInstance::Fate;
    const ArrivalLimits limits{.mostBytes = receiver_.mostBytesOfInstance(),
                               .hasRoomFor = [this](std::size_t bytes) {
                                   const std::lock_guard lock(mutex_);
                                   counts_.bytes += bytes;
                                   return true;
                               }};
    const ArrivedInstance arrived = receiveInstance(association, request, receiver_, limits);
    switch (arrived.fate) {
        case Fate::whole:
            break;
        case Fate::nameless:
            return {Outcome::refused, {}};
        case Fate::tooLarge:
            return {Outcome::refused, closedMidway()};
        case Fate::withoutRoom:
            return fail(arrived.error.value_or(diskTrouble()));
        case Fate::cutOff:
            return {{}, arrived.error};
    }
    const std::string& study = arrived.studyInstanceUid;
    if (study.empty() || study == wanted_.studyInstanceUid) return take(arrived.file, request.command);
    receiver_.drop(arrived.file);
    return {Outcome::refused, {}};
}

Result<void> Incoming::store(Association& association, const ReceivedCommand& request) {
    const Command& command = request.command;
    if (!command.messageId || !command.hasDataset) return notWhatDicomSays();
    if (isTooMuch()) return *fail(farTooMuch()).end;
    const Stored stored = write(association, request);
    if (stored.outcome) count(command.sopInstanceUid, *stored.outcome);
    const bool hasFailed = failure().has_value();
    if (stored.end && !hasFailed) return *stored.end;
    const bool isGood = stored.outcome && *stored.outcome != Outcome::refused;
    const Command response{.field = CommandField::storeResponse,
                           .respondsTo = command.messageId,
                           .sopClassUid = command.sopClassUid,
                           .sopInstanceUid = command.sopInstanceUid,
                           .status = isGood      ? kStatusStored
                                     : hasFailed ? kStatusNoRoom
                                                 : kStatusNotWanted};
    MACULA_TRY_VOID(sendCommand(association, request.context, response));
    if (const auto failed = failure()) return *failed;
    return {};
}

}  // namespace macula::net

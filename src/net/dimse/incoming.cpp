#include "net/dimse/incoming.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "net/archive/file_meta.h"
#include "net/dimse/contexts.h"
#include "net/dimse/elements.h"

namespace macula::net {

namespace {

constexpr std::uint16_t kStored = 0x0000;
constexpr std::uint16_t kNoRoom = 0xa700;
constexpr std::uint16_t kNotWanted = 0xa900;
constexpr std::size_t kMostUnpromised = 200'000;
constexpr std::size_t kSpareArrivals = 1000;
constexpr std::size_t kMostBytesOfHead = std::size_t{256} << 10;
constexpr std::uint32_t kStudyInstanceUid = 0x0020000d;

// A file that is written to its end, or dropped.
class InstanceFile {
  public:
    explicit InstanceFile(const std::filesystem::path& path)
        : descriptor_(::open(path.c_str(), O_WRONLY | O_TRUNC | O_NOFOLLOW | O_CLOEXEC)) {}
    ~InstanceFile() { close(); }
    InstanceFile(const InstanceFile&) = delete;
    InstanceFile& operator=(const InstanceFile&) = delete;

    bool write(const void* bytes, std::size_t count) {
        const char* at = static_cast<const char*>(bytes);
        while (count > 0) {
            const ssize_t written = ::write(descriptor_, at, count);
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) return false;
            at += written;
            count -= static_cast<std::size_t>(written);
        }
        return descriptor_ >= 0;
    }
    bool close() {
        if (descriptor_ < 0) return false;
        return ::close(std::exchange(descriptor_, -1)) == 0;
    }

  private:
    int descriptor_;
};

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

// Of the beginning of a dataset; empty where it is not found there.
std::string studyOfHead(std::span<const unsigned char> head, std::string_view transferSyntax) {
    Encoding encoding{};
    std::string study;
    if (!encodingOf(transferSyntax, encoding)) return study;
    forEachElement(head, encoding, [&](const Element& element) {
        if (element.tag == kStudyInstanceUid) study = textOf(element);
        return element.tag < kStudyInstanceUid;
    });
    return study;
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
    const Command& command = request.command;
    const AcceptedContext* context = association.contextOf(request.context);
    MACULA_CHECK(context != nullptr);
    const std::uintmax_t most = receiver_.mostBytesOfInstance();
    std::uintmax_t count = 0;
    if (!isUid(command.sopClassUid) || !isUid(command.sopInstanceUid)) {
        const Result<void> ignored = receiveDataset(
            association, request.context, [&](std::span<const unsigned char> bytes) -> Result<void> {
                count += bytes.size();
                if (count > most) return notWhatDicomSays();
                return {};
            });
        if (!ignored) return {{}, ignored.error()};
        return {Outcome::refused, {}};
    }
    const Result<std::filesystem::path> place = receiver_.place();
    if (!place) return fail(place.error());
    InstanceFile file(*place);
    const std::string meta =
        fileMetaBytes({command.sopClassUid, command.sopInstanceUid, context->transferSyntax});
    bool isWritten = file.write(meta.data(), meta.size());
    bool isTooLarge = false;
    std::vector<unsigned char> head;
    const Result<void> received = receiveDataset(
        association, request.context, [&](std::span<const unsigned char> bytes) -> Result<void> {
            count += bytes.size();
            isTooLarge = count + meta.size() > most;
            if (isTooLarge) return notWhatDicomSays();
            isWritten = isWritten && file.write(bytes.data(), bytes.size());
            if (!isWritten) return diskTrouble();
            const std::size_t wanting = kMostBytesOfHead - std::min(kMostBytesOfHead, head.size());
            const auto part = bytes.first(std::min(wanting, bytes.size()));
            head.insert(head.end(), part.begin(), part.end());
            const std::lock_guard lock(mutex_);
            counts_.bytes += bytes.size();
            return {};
        });
    isWritten = file.close() && isWritten;
    if (received && isWritten) {
        const std::string study = studyOfHead(head, context->transferSyntax);
        if (study.empty() || study == wanted_.studyInstanceUid) return take(*place, command);
    }
    receiver_.drop(*place);
    if (!isWritten) return fail(diskTrouble());
    // What is left of one that is too large may have no end: the association goes.
    if (isTooLarge) return {Outcome::refused, closedMidway()};
    if (!received) return {{}, received.error()};
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
                           .status = isGood      ? kStored
                                     : hasFailed ? kNoRoom
                                                 : kNotWanted};
    MACULA_TRY_VOID(sendCommand(association, request.context, response));
    if (const auto failed = failure()) return *failed;
    return {};
}

}  // namespace macula::net

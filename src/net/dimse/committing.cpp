#include "net/dimse/committing.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <system_error>
#include <thread>
#include <utility>

#include "net/archive/file_meta.h"
#include "net/dimse/contexts.h"
#include "net/dimse/move_receiver.h"
#include "net/dimse/port_turn.h"
#include "net/dimse/requests.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::net {

namespace {

constexpr std::size_t kInstancesOfTransaction = 500;
constexpr std::size_t kMostBytesOfReport = std::size_t{1} << 20;
constexpr std::size_t kMostConnections = 4;
constexpr std::chrono::milliseconds kSlice{50};
// An archive that means to report over a connection of its own may wait until the one that asked has ended.
constexpr std::chrono::seconds kPatienceOverSameAssociation{10};
constexpr std::uint16_t kRequestStorageCommitment = 1;  // action type
constexpr std::uint16_t kProcessingFailure = 0x0110;

// PS3.5 B.2: of 2^128 possible numbers, one of 37 digits that nobody guesses.
Result<std::string> newTransactionUid() {
    std::array<std::uint64_t, 2> random{};
    if (getrandom(random.data(), sizeof random, 0) != static_cast<ssize_t>(sizeof random))
        return Error{
            ErrorCode::archiveNotUsable, Text("The system has no random numbers."), {}, Text("Try again.")};
    constexpr std::uint64_t kDigits18 = 1'000'000'000'000'000'000;
    std::string low = std::to_string(random[1] % kDigits18);
    low.insert(0, 18 - low.size(), '0');
    return "2.25.1" + std::to_string(kDigits18 / 10 + random[0] % (kDigits18 / 10 * 9)) + low;
}

Error unanswered(bool listens) {
    return archiveError(
        Text("The archive has not said yet whether it keeps this object."),
        listens ? Text("Ask again later. The archive must know the receiver's AE title, host name and port, "
                       "and no firewall may block them.")
                : Text("Most archives report over a connection of their own: enter a receiver's port in the "
                       "settings of the archive, and have AE title, host name and port entered there."));
}

}  // namespace

Committing::Committing(const Connector& connector, std::span<const std::filesystem::path> files,
                       std::chrono::seconds patience, Progress& progress)
    : connector_(connector),
      patience_(patience),
      progress_(progress),
      heartbeat_(std::make_shared<Heartbeat>()) {
    const Error none = unanswered(connector.peer().receiverPort != 0);
    for (const std::filesystem::path& file : files)
        results_.push_back({file, Commitment::State::unanswered, none.message, none.hint});
}

void Committing::readFiles() {
    for (std::size_t i = 0; i < results_.size(); ++i) {
        const Result<FileMeta> meta = readFileMeta(results_[i].file);
        if (!meta || !meta->isWhole()) {
            const Error why = meta ? notWhatDicomSays() : meta.error();
            results_[i] = {results_[i].file, Commitment::State::refused, why.message, why.hint};
            continue;
        }
        std::vector<std::size_t>& places = places_[meta->sopInstanceUid];
        if (places.empty()) instances_.push_back({meta->sopClassUid, meta->sopInstanceUid});
        places.push_back(i);
    }
}

Result<void> Committing::makeTransactions() {
    for (std::size_t i = 0; i < instances_.size(); i += kInstancesOfTransaction) {
        MACULA_TRY(const std::string uid, newTransactionUid());
        const auto begin = instances_.begin() + static_cast<std::ptrdiff_t>(i);
        const auto count = std::min(kInstancesOfTransaction, instances_.size() - i);
        transactions_[uid].instances = {begin, begin + static_cast<std::ptrdiff_t>(count)};
    }
    return {};
}

Result<std::vector<Commitment>> Committing::run() {
    readFiles();
    MACULA_TRY_VOID(makeTransactions());
    if (transactions_.empty()) return results_;
    progress_.beginStage(Text("Waiting for the archive to confirm that it keeps the files"),
                         instances_.size());
    const DimsePeer& peer = connector_.peer();
    PortTurn turn(peer.receiverPort);
    std::unique_ptr<Acceptor> acceptor;
    if (peer.receiverPort != 0) {
        if (!turn.wait(progress_.token())) return cancelledError();
        MACULA_TRY(acceptor, listen());
    }
    std::thread hearing;
    try {
        hearing = std::thread([this] { askAndHear(); });
    } catch (const std::system_error&) {
        return archiveError(Text("This machine could not make a connection."),
                            Text("Close other programs and try again."));
    }
    const Result<void> waited = wait(acceptor != nullptr);
    stopHearing_.cancel();
    hearing.join();
    acceptor.reset();
    if (!waited) return waited.error();
    return results_;
}

Result<std::unique_ptr<Acceptor>> Committing::listen() {
    const DimsePeer& peer = connector_.peer();
    MACULA_TRY(const auto tls, connector_.receiverTls());
    return Acceptor::start({peer.receiverAddress, peer.receiverPort}, kMostConnections, stopListening_,
                           [this, tls](const Acceptor::Connection& connection) {
                               const QuietToolkit quiet;
                               auto wire = std::make_unique<Wire>(connection.socket,
                                                                  connector_.answerTimeout(), stopListening_);
                               if (tls && !wire->beginTls(*tls, {}, connector_.answerTimeout())) return;
                               serve(std::move(wire));
                           });
}

void Committing::serve(std::unique_ptr<Wire> wire) {
    const Welcome welcome{
        .judge =
            [this](const AssociationTitles& titles) {
                return unlessCalled(titles, receiverTitle(connector_.peer()));
            },
        .offers = [](std::string_view abstractSyntax) { return abstractSyntax == kCommitment; }};
    const Result<std::unique_ptr<Association>> association = Association::accept(std::move(wire), welcome);
    if (!association) return;
    answerRequests(**association,
                   [&](const ReceivedCommand& request) { return takeReport(**association, request); });
}

Result<void> Committing::wait(bool listens) {
    const auto until = Clock::now() + patience_;
    std::unique_lock lock(mutex_);
    while (!isOver()) {
        changed_.wait_for(lock, kSlice);
        heartbeat_->beat();
        const auto now = Clock::now();
        if (asked_ && !asked_->ok()) return asked_->error();
        if (progress_.cancelled()) return cancelledError();
        if (now >= until) return {};
        if (listens && askedAt_ && now >= *askedAt_ + kPatienceOverSameAssociation) stopHearing_.cancel();
        if (!listens && hasEndedHearing_) return {};
    }
    return {};
}

void Committing::askAndHear() {
    const QuietToolkit quiet;
    Result<std::unique_ptr<Association>> association =
        connector_.open({plainContext(kVerification), plainContext(kCommitment)}, stopHearing_);
    Result<void> asked = association ? ask(**association) : Result<void>(association.error());
    {
        const std::lock_guard lock(mutex_);
        asked_ = asked;
        askedAt_ = Clock::now();
    }
    if (asked) {
        (*association)->wire().setHeartbeat(heartbeat_);
        answerRequests(**association,
                       [&](const ReceivedCommand& request) { return takeReport(**association, request); });
    }
    if (association) (*association)->release();
    const std::lock_guard lock(mutex_);
    hasEndedHearing_ = true;
    changed_.notify_all();
}

Result<void> Committing::ask(Association& association) {
    const AcceptedContext* context = association.contextFor(std::string(kCommitment));
    if (context == nullptr) return serviceNotOffered(Service::commit);
    for (const auto& [uid, transaction] : transactions_) {
        const std::uint16_t messageId = association.newMessageId();
        MACULA_TRY_VOID(sendCommand(association, context->id,
                                    {.field = CommandField::actionRequest,
                                     .messageId = messageId,
                                     .requestedClassUid = std::string(kCommitment),
                                     .requestedInstanceUid = std::string(kCommitmentInstance),
                                     .actionType = kRequestStorageCommitment,
                                     .hasDataset = true}));
        MACULA_TRY_VOID(
            sendDataset(association, context->id,
                        commitmentRequestBytes(uid, transaction.instances, context->transferSyntax)));
        MACULA_TRY_VOID(awaitAnswer(association, messageId));
    }
    return {};
}

Result<void> Committing::awaitAnswer(Association& association, std::uint16_t messageId) {
    while (true) {
        MACULA_TRY(const ReceivedCommand received, receiveCommand(association));
        const Command& command = received.command;
        if (command.field == CommandField::eventReportRequest) {
            if (!takeReport(association, received)) return notWhatDicomSays();
            continue;
        }
        if (command.field != CommandField::actionResponse || command.respondsTo != messageId ||
            !command.status)
            return notWhatDicomSays();
        if (command.hasDataset) {
            MACULA_TRY(const auto ignored,
                       receiveSmallDataset(association, received.context, kMostBytesOfReport));
        }
        if (*command.status != 0 && !isWarning(*command.status))
            return errorOfStatus(Service::commit, *command.status);
        return {};
    }
}

bool Committing::takeReport(Association& association, const ReceivedCommand& request) {
    const Command& command = request.command;
    if (command.field != CommandField::eventReportRequest || !command.messageId || !command.hasDataset)
        return false;
    const AcceptedContext* context = association.contextOf(request.context);
    const Result<KeptDataset> dataset = receiveSmallDataset(association, request.context, kMostBytesOfReport);
    if (context == nullptr || !dataset) return false;
    const std::optional<CommitmentReport> report =
        dataset->isWhole ? commitmentReportOf(dataset->bytes, context->transferSyntax) : std::nullopt;
    const bool isNoted = report && note(*report);
    const Command response{.field = CommandField::eventReportResponse,
                           .respondsTo = command.messageId,
                           .sopClassUid = command.sopClassUid,
                           .sopInstanceUid = command.sopInstanceUid,
                           .eventType = command.eventType,
                           .status = isNoted ? std::uint16_t{0} : kProcessingFailure};
    return sendCommand(association, request.context, response).ok();
}

bool Committing::note(const CommitmentReport& report) {
    const std::lock_guard lock(mutex_);
    const auto found = transactions_.find(report.transactionUid);
    if (found == transactions_.end()) return false;
    if (found->second.isReported) return true;  // the same again, whose answer was lost
    found->second.isReported = true;
    for (const ReferencedInstance& instance : found->second.instances) {
        const auto refused = report.refused.find(instance.sopInstanceUid);
        const bool isCommitted = report.committed.contains(instance.sopInstanceUid);
        if (!isCommitted && refused == report.refused.end()) continue;
        const Error why = isCommitted ? Error{} : errorOfCommitment(refused->second);
        for (const std::size_t place : places_.at(instance.sopInstanceUid)) {
            Commitment& result = results_[place];
            result.state = isCommitted ? Commitment::State::committed : Commitment::State::refused;
            result.why = why.message;
            result.advice = why.hint;
        }
    }
    progress_.advance(found->second.instances.size());
    changed_.notify_all();
    return true;
}

bool Committing::isOver() const {
    return std::ranges::all_of(transactions_, [](const auto& each) { return each.second.isReported; });
}

}  // namespace macula::net

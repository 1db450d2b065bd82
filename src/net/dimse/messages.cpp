#include "net/dimse/messages.h"

#include <chrono>
#include <optional>

#include "net/dimse/failures.h"

namespace macula::net {

namespace {

constexpr std::chrono::milliseconds kPatienceAfterCancel{3000};
constexpr std::uint16_t kOutOfResources = 0xa700;

}  // namespace

Result<void> sendCommand(Association& association, std::uint8_t context, const Command& command) {
    const std::vector<unsigned char> bytes = bytesOf(command);
    return association.send({context, true, true, bytes});
}

Result<void> sendDataset(Association& association, std::uint8_t context, std::span<const unsigned char> bytes,
                         bool isLast) {
    return association.send({context, false, isLast, bytes});
}

Result<ReceivedCommand> receiveCommand(Association& association) {
    std::vector<unsigned char> bytes;
    std::optional<std::uint8_t> context;
    while (true) {
        MACULA_TRY(const Fragment fragment, association.next());
        if (!fragment.isCommand || (context && *context != fragment.context) ||
            bytes.size() + fragment.bytes.size() > kMostBytesOfCommand)
            return notWhatDicomSays();
        context = fragment.context;
        bytes.insert(bytes.end(), fragment.bytes.begin(), fragment.bytes.end());
        if (!fragment.isLast) continue;
        const std::optional<Command> command = commandOf(bytes);
        if (!command || association.contextOf(*context) == nullptr) return notWhatDicomSays();
        return ReceivedCommand{*context, *command};
    }
}

Result<void> receiveDataset(Association& association, std::uint8_t context,
                            const std::function<Result<void>(std::span<const unsigned char>)>& take) {
    while (true) {
        MACULA_TRY(const Fragment fragment, association.next());
        if (fragment.isCommand || fragment.context != context) return notWhatDicomSays();
        MACULA_TRY_VOID(take(fragment.bytes));
        if (fragment.isLast) return {};
    }
}

Result<KeptDataset> receiveSmallDataset(Association& association, std::uint8_t context, std::size_t most) {
    KeptDataset kept;
    std::size_t count = 0;
    MACULA_TRY_VOID(
        receiveDataset(association, context, [&](std::span<const unsigned char> bytes) -> Result<void> {
            count += bytes.size();
            if (count > 16 * most) return notWhatDicomSays();
            if (count <= most)
                kept.bytes.insert(kept.bytes.end(), bytes.begin(), bytes.end());
            else
                kept.isWhole = false;
            return {};
        }));
    return kept;
}

namespace {

// Reads on until the last response to the request; false if it does not come.
bool drainsTo(Association& association, std::uint16_t messageId) {
    using Clock = std::chrono::steady_clock;
    const auto until = Clock::now() + kPatienceAfterCancel;
    std::vector<unsigned char> bytes;
    std::optional<Command> offered;  // an instance that is on its way
    std::optional<std::uint8_t> offeredIn;
    while (Clock::now() < until) {
        const Result<Fragment> fragment = association.next();
        if (!fragment) return false;
        if (!fragment->isCommand) {
            if (!fragment->isLast || !offered || offeredIn != fragment->context) continue;
            const Command refusal{.field = CommandField::storeResponse,
                                  .respondsTo = offered->messageId,
                                  .sopClassUid = offered->sopClassUid,
                                  .sopInstanceUid = offered->sopInstanceUid,
                                  .status = kOutOfResources};
            offered.reset();
            if (!sendCommand(association, fragment->context, refusal)) return false;
            continue;
        }
        if (bytes.size() + fragment->bytes.size() > kMostBytesOfCommand) return false;
        bytes.insert(bytes.end(), fragment->bytes.begin(), fragment->bytes.end());
        if (!fragment->isLast) continue;
        const std::optional<Command> command = commandOf(bytes);
        bytes.clear();
        if (!command) return false;
        if (command->field == CommandField::storeRequest) {
            offered = command;
            offeredIn = fragment->context;
        }
        if (command->isResponse() && command->respondsTo == messageId &&
            !isPending(command->status.value_or(0)))
            return !command->hasDataset;
    }
    return false;
}

}  // namespace

void endRequest(Association& association, std::uint8_t context, std::uint16_t messageId) {
    if (!association.isOpen()) return;
    association.wire().finishWithin(kPatienceAfterCancel);
    const Command cancel{.field = CommandField::cancelRequest, .respondsTo = messageId};
    if (sendCommand(association, context, cancel) && drainsTo(association, messageId)) association.release();
}

}  // namespace macula::net

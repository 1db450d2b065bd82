// Messages of DIMSE over an association: a command, and a dataset that may follow it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "net/dimse/association.h"
#include "net/dimse/command.h"

namespace macula::net {

struct ReceivedCommand {
    std::uint8_t context = 0;
    Command command;
};

// More than that is no command that an archive should send.
constexpr std::size_t kMostBytesOfCommand = std::size_t{64} << 10;

Result<void> sendCommand(Association& association, std::uint8_t context, const Command& command);
Result<void> sendDataset(Association& association, std::uint8_t context, std::span<const unsigned char> bytes,
                         bool isLast = true);

// Waits for a command. Its dataset, if it has one, must be received next.
Result<ReceivedCommand> receiveCommand(Association& association);
// Hands over the parts of a dataset as they come; an error that `take` returns ends it.
Result<void> receiveDataset(Association& association, std::uint8_t context,
                            const std::function<Result<void>(std::span<const unsigned char>)>& take);
// At most `most` bytes are kept; `isWhole` tells whether those were all. A peer that sends more than
// sixteen times as many breaks the rules.
struct KeptDataset {
    std::vector<unsigned char> bytes;
    bool isWhole = true;
};
Result<KeptDataset> receiveSmallDataset(Association& association, std::uint8_t context, std::size_t most);

// After a request was cancelled, or has brought enough: tells the peer, waits a few seconds for its
// agreement, refuses what it still sends, and releases the association. Without agreement it is aborted.
void endRequest(Association& association, std::uint8_t context, std::uint16_t messageId);

}  // namespace macula::net

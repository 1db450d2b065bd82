// Commands of DIMSE (PS3.7 chapter 9 and annex E): what stands before each dataset.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace macula::net {

enum class CommandField : std::uint16_t {
    none = 0,
    storeRequest = 0x0001,
    storeResponse = 0x8001,
    getRequest = 0x0010,
    getResponse = 0x8010,
    findRequest = 0x0020,
    findResponse = 0x8020,
    moveRequest = 0x0021,
    moveResponse = 0x8021,
    echoRequest = 0x0030,
    echoResponse = 0x8030,
    eventReportRequest = 0x0100,
    eventReportResponse = 0x8100,
    actionRequest = 0x0130,
    actionResponse = 0x8130,
    cancelRequest = 0x0fff,
};

struct Command {
    CommandField field = CommandField::none;
    std::optional<std::uint16_t> messageId;   // of a request
    std::optional<std::uint16_t> respondsTo;  // of a response, and of what a cancel ends
    std::string sopClassUid;                  // affected
    std::string sopInstanceUid;               // affected
    std::string requestedClassUid;            // of an action
    std::string requestedInstanceUid;         // of an action
    std::optional<std::uint16_t> eventType;
    std::optional<std::uint16_t> actionType;
    std::string moveDestination;             // AE title
    std::optional<std::uint16_t> priority;   // 0: medium
    std::optional<std::uint16_t> status;     // of a response
    std::optional<std::uint16_t> remaining;  // of the instances that a retrieval is about
    std::optional<std::uint16_t> completed;
    std::optional<std::uint16_t> failed;
    std::optional<std::uint16_t> withWarning;
    bool hasDataset = false;

    bool isResponse() const { return (static_cast<unsigned>(field) & 0x8000u) != 0; }
};

// In Implicit VR Little Endian, as all commands are.
std::vector<unsigned char> bytesOf(const Command& command);
// Empty if the bytes are no command. A field that is malformed is left out.
std::optional<Command> commandOf(std::span<const unsigned char> bytes);

}  // namespace macula::net

// One instance of a C-STORE request, on its way from the network into a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "base/result.h"
#include "net/archive/receiver.h"
#include "net/dimse/messages.h"

namespace macula::net {

struct ArrivalLimits {
    std::uintmax_t mostBytes = 0;  // of the file
    // Asked about each fragment that is to be written; false: there is no room for it.
    std::function<bool(std::size_t bytes)> hasRoomFor;
    // How much is read over of an instance that there is no room for, so that the peer hears of it.
    std::uintmax_t mostReadOver = 0;
};

struct ArrivedInstance {
    enum class Fate {
        whole,        // the file is complete, and whoever asked must take or drop it
        nameless,     // its names are no UIDs: read over
        tooLarge,     // dropped; what is left of it may have no end
        withoutRoom,  // dropped; `error` is that of the receiver, or empty where the disk took no more
        cutOff,       // dropped; `error` says what became of the association
    };
    Fate fate = Fate::cutOff;
    bool isReadToTheEnd = false;  // the association can be used again
    std::filesystem::path file;
    std::string studyInstanceUid;  // empty where it does not stand at the beginning
    std::optional<Error> error;
};

// Statuses of the response (PS3.4 B.2.3).
inline constexpr std::uint16_t kStatusStored = 0x0000;
inline constexpr std::uint16_t kStatusNoRoom = 0xa700;
inline constexpr std::uint16_t kStatusNotWanted = 0xa900;

// Writes the dataset as it comes, fragment by fragment, behind file meta information, where the receiver
// says.
ArrivedInstance receiveInstance(Association& association, const ReceivedCommand& request, Receiver& receiver,
                                const ArrivalLimits& limits);

}  // namespace macula::net

// The thread that receives studies while the window wants it to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "study/archive/receiving.h"

namespace macula::viewer {

// What has changed since the last news.
struct ReceptionNews {
    std::uint16_t port = 0;  // at which it listens
    study::ArrivingStudies arriving;
    std::vector<study::ReceivedStudy> done;
    std::optional<Error> trouble;            // something could not be kept
    std::size_t turnedAway = 0;              // connections, in all
    std::size_t refused = 0;                 // objects that were not kept, in all
    std::size_t withoutRoom = 0;             // objects for which there was none, in all
    std::optional<Text> whyTurnedAway = {};  // of the last one
};

struct ReceptionEnd {
    std::size_t studies = 0;  // that were done
};

// Listens until `stop` or the progress is cancelled, then finishes what came. Tells that it listens, and what
// has changed since, from the calling thread. Fails as study::Receiving::start.
Result<ReceptionEnd> receiveUntilStopped(study::ReceivingOptions options, const CancelToken& stop,
                                         const Progress& progress,
                                         const std::function<void(const ReceptionNews&)>& tell);

}  // namespace macula::viewer

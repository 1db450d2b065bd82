// The study states that a StudyKeeper finds and stores.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "base/volume.h"
#include "live/model/part_digests.h"
#include "live/store/keeper_messages.h"
#include "live/store/opened_record.h"
#include "live/store/store_thread.h"

namespace macula::live {

// What the name of a document with the state of a volume ends with, after the volume's digest and a blank.
inline constexpr const char* kKeptStateName = "as it was left";

// Any thread may call both methods; what they post runs on the keeper's thread.
class KeptStates {
  public:
    KeptStates(StoreThread& thread, KeeperMessages& messages, OpenedRecord& opened, PartDigests& digests)
        : thread_(thread), messages_(messages), opened_(opened), digests_(digests) {}

    // See StudyKeeper.
    std::optional<std::string> stateOf(const std::shared_ptr<const Volume>& volume,
                                       std::chrono::milliseconds patience);
    void keepState(std::shared_ptr<const Volume> volume, std::string json, std::shared_ptr<std::string> base);

  private:
    StoreThread& thread_;
    KeeperMessages& messages_;  // only jobs use this and opened_
    OpenedRecord& opened_;
    PartDigests& digests_;
};

}  // namespace macula::live

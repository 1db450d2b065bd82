// Messages of a StudyKeeper to the user.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <utility>

#include "base/check.h"
#include "base/result.h"

namespace macula::live {

// Receives messages for the user: a sentence and advice. No patient data, except in `where`.
using KeeperListener = std::function<void(const Error&)>;

// Passes each sentence on once, and logs it. Used by the keeper's thread alone, which calls the listener.
class KeeperMessages {
  public:
    explicit KeeperMessages(KeeperListener listener) : listener_(std::move(listener)) {}

    void tell(const Error& error);
    void tellOfNoMemory(Text (*sentence)()) noexcept;
    void tellOfFault(const CheckFailure& failure) noexcept;

  private:
    const KeeperListener listener_;
    std::set<std::string> told_;  // sentences the listener has heard, in English
};

}  // namespace macula::live

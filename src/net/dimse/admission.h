// Who may make associations with this program, and how many.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "net/archive/reception.h"
#include "net/dimse/address_range.h"
#include "net/dimse/failures.h"

namespace macula::net {

// As people write who may send: TITLE, TITLE@ADDRESS or *@ADDRESS. Fails with usage where it is none of
// these.
Result<AdmittedCaller> admittedCaller(const std::string& text);

// Thread-safe.
class Admission {
  public:
    using Clock = std::chrono::steady_clock;

    // With no callers: whoever reaches a program that listens on this machine alone. `admitsAnyone`: from
    // anywhere. Fails with usage where an address cannot be read.
    static Result<std::unique_ptr<Admission>> of(const std::vector<AdmittedCaller>& callers,
                                                 bool admitsAnyone, const AdmissionLimits& limits);

    bool mayConnect(const WireAddress& from) const;
    bool mayCall(const std::string& callingAe, const WireAddress& from) const;

    // One association more; after nothing was returned, leave() must follow.
    std::optional<Rejection> enter(Clock::time_point now);
    void leave();

  private:
    struct Entry {
        std::string ae;
        std::optional<AddressRange> range;
    };

    std::vector<Entry> entries_;
    AdmissionLimits limits_;
    std::mutex mutex_;
    std::size_t open_ = 0;
    std::deque<Clock::time_point> lately_;  // within the last minute, in order
};

}  // namespace macula::net

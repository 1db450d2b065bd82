#include "net/dimse/admission.h"

#include <algorithm>
#include <utility>

namespace macula::net {

namespace {

// PS3.8 9.3.4: the rejection is transient, and the reason one of the presentation layer's.
constexpr Rejection kTooOften{.result = 2, .source = 3, .reason = 1};  // temporary congestion
constexpr Rejection kTooMany{.result = 2, .source = 3, .reason = 2};   // local limit exceeded

}  // namespace

Result<AdmittedCaller> admittedCaller(const std::string& text) {
    const std::size_t at = text.find('@');
    AdmittedCaller caller{.ae = text.substr(0, at), .address = {}};
    if (at != std::string::npos) caller.address = text.substr(at + 1);
    const bool isUseful = !caller.ae.empty() && (at == std::string::npos || !caller.address.empty());
    if (!isUseful || text == "*")
        return Error{ErrorCode::usage,
                     Text("Who may send is written as TITLE, TITLE@ADDRESS or *@ADDRESS."),
                     {},
                     Text("For example CT1@10.1.2.3, or *@10.1.0.0/16.")};
    if (caller.ae == "*") caller.ae.clear();
    return caller;
}

Result<std::unique_ptr<Admission>> Admission::of(const std::vector<AdmittedCaller>& callers,
                                                 bool admitsAnyone, const AdmissionLimits& limits) {
    auto admission = std::make_unique<Admission>();
    admission->limits_ = limits;
    for (const AdmittedCaller& caller : callers) {
        Entry entry{caller.ae, {}};
        if (!caller.address.empty()) {
            entry.range = AddressRange::of(caller.address);
            if (!entry.range)
                return Error{
                    ErrorCode::usage,
                    Text("{} is no address.", caller.address),
                    {},
                    Text("Enter an IP address or a range of them, such as 10.1.0.0/16. Host names are "
                         "not enough: somebody else could answer for them.")};
        }
        admission->entries_.push_back(std::move(entry));
    }
    if (admitsAnyone) {
        admission->entries_ = {Entry{}};
    } else if (callers.empty()) {
        for (const char* own : {"127.0.0.0/8", "::1"})
            admission->entries_.push_back({{}, AddressRange::of(own)});
    }
    return admission;
}

bool Admission::mayConnect(const WireAddress& from) const {
    return std::ranges::any_of(
        entries_, [&](const Entry& entry) { return !entry.range || entry.range->contains(from); });
}

bool Admission::mayCall(const std::string& callingAe, const WireAddress& from) const {
    return std::ranges::any_of(entries_, [&](const Entry& entry) {
        return (entry.ae.empty() || entry.ae == callingAe) && (!entry.range || entry.range->contains(from));
    });
}

std::optional<Rejection> Admission::enter(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    while (!lately_.empty() && lately_.front() <= now - std::chrono::minutes(1)) lately_.pop_front();
    const auto second = std::ranges::upper_bound(lately_, now - std::chrono::seconds(1));
    const auto inLastSecond = static_cast<std::size_t>(lately_.end() - second);
    if (open_ >= limits_.associations) return kTooMany;
    if (inLastSecond >= limits_.associationsPerSecond || lately_.size() >= limits_.associationsPerMinute)
        return kTooOften;
    lately_.push_back(now);
    ++open_;
    return {};
}

void Admission::leave() {
    const std::lock_guard lock(mutex_);
    --open_;
}

}  // namespace macula::net

#include "xr/room_state.h"

#include <array>
#include <cstddef>
#include <utility>

#include "base/check.h"

namespace macula::xr {

namespace {

template <class Value>
bool isEqual(const std::shared_ptr<const Value>& a, const std::shared_ptr<const Value>& b) {
    return a == b || (a && b && *a == *b);
}

struct Cost {
    double foveaShare;
    std::uint32_t mostSamples;
};
constexpr std::array kCosts{Cost{0.5, 4}, Cost{1.0, 16}, Cost{2.0, 64}};  // by RoomQuality
static_assert(kCosts.size() == std::size_t(RoomQuality::fine) + 1);

}  // namespace

double foveaShareOf(RoomQuality quality) {
    return kCosts.at(std::size_t(quality)).foveaShare;
}

std::uint32_t mostSamplesOf(RoomQuality quality) {
    return kCosts.at(std::size_t(quality)).mostSamples;
}

bool RoomState::operator==(const RoomState& b) const {
    return isEqual(transferFunction, b.transferFunction) && isEqual(clip, b.clip) && quality == b.quality;
}

void RoomHistory::push(RoomState next) {
    if (next == now()) return;
    if (states_.size() > kMostSteps) states_.erase(states_.begin());
    states_.push_back(std::move(next));
}

const RoomState& RoomHistory::before() const {
    MACULA_CHECK(canUndo());
    return states_[states_.size() - 2];
}

}  // namespace macula::xr

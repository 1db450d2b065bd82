#include "xr/room_state.h"

#include <utility>

#include "base/check.h"

namespace macula::xr {

namespace {

template <class Value>
bool isEqual(const std::shared_ptr<const Value>& a, const std::shared_ptr<const Value>& b) {
    return a == b || (a && b && *a == *b);
}

}  // namespace

double foveaShareOf(RoomQuality quality) {
    switch (quality) {
        case RoomQuality::fast:
            return 0.5;
        case RoomQuality::balanced:
            return 1.0;
        case RoomQuality::fine:
            return 2.0;
    }
    return 1.0;
}

std::uint32_t mostSamplesOf(RoomQuality quality) {
    switch (quality) {
        case RoomQuality::fast:
            return 4;
        case RoomQuality::balanced:
            return 16;
        case RoomQuality::fine:
            return 64;
    }
    return 16;
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

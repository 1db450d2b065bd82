#include "xr/room_choice.h"

#include <cmath>
#include <optional>

namespace macula::xr {

namespace {

constexpr double kWantedEveryS = 0.25;
constexpr double kDragGoesOnS = 1.0;

}  // namespace

Result<bool> RoomChoice::change(RoomState next, const RoomHost& host, const ShowRoom& show) {
    if (next == now()) return true;
    MACULA_TRY(const bool isShown, show(next, Lasts::forGood));
    if (!isShown) return false;
    history_.push(std::move(next));
    wasWanted_ = false;
    if (host.changed) host.changed(now());
    return true;
}

Result<void> RoomChoice::undo(const RoomHost& host, const ShowRoom& show) {
    if (!history_.canUndo()) return {};
    MACULA_TRY(const bool isShown, show(history_.before(), Lasts::forGood));
    if (!isShown) return {};
    history_.undo();
    wasWanted_ = false;
    if (host.changed) host.changed(now());
    return {};
}

Result<void> RoomChoice::takeWanted(const RoomHost& host, double seconds, const ShowRoom& show) {
    // Follows a drag in the window in several states, which become one undo step.
    if (!host.wanted || std::abs(seconds - wantedAt_) < kWantedEveryS) return {};
    std::optional<RoomState> wanted = host.wanted();
    if (!wanted) return {};
    const bool goesOn = wasWanted_ && std::abs(seconds - wantedAt_) < kDragGoesOnS;
    wantedAt_ = seconds;
    wanted->quality = now().quality;  // quality is a choice for the headset alone
    if (!wanted->transferFunction || *wanted == now()) return {};
    MACULA_TRY(const bool isShown, show(*wanted, Lasts::forGood));
    if (!isShown) return {};
    if (goesOn && history_.canUndo()) history_.undo();
    history_.push(*std::move(wanted));
    wasWanted_ = true;
    return {};
}

Result<void> RoomChoice::comeBack(const ShowRoom& show) const {
    MACULA_TRY([[maybe_unused]] const bool isShown, show(now(), Lasts::forGood));
    return {};
}

}  // namespace macula::xr

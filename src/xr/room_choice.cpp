#include "xr/room_choice.h"

#include <fmt/format.h>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "scene/transfer/edited_transfer.h"
#include "scene/transfer/own_copy.h"

namespace macula::xr {

namespace {

constexpr double kShiftShare = 0.02;  // of the range from the first to the last opacity point

std::optional<std::size_t> presetIndex(const RoomState& state, const RoomHost& host) {
    const TransferFunction& now = *state.transferFunction;
    const std::string copied = scene::copiedFrom(now);
    const std::string& name = copied.empty() ? now.name : copied;
    for (std::size_t i = 0; i < host.presets.size(); ++i)
        if (host.presets[i]->name == name) return i;
    return std::nullopt;
}

constexpr double kWantedEveryS = 0.25;
constexpr double kDragGoesOnS = 1.0;

}  // namespace

RoomState withPreset(RoomState state, const RoomHost& host, int steps) {
    const int count = int(host.presets.size());
    if (count == 0) return state;
    const auto index = presetIndex(state, host);
    // A preset that is not in the list counts as before the first.
    const int at = index ? int(*index) + steps : (steps > 0 ? 0 : count - 1);
    state.transferFunction = host.presets[std::size_t((at % count + count) % count)];
    return state;
}

RoomState withShift(RoomState state, const RoomHost& host, int steps) {
    const TransferFunction& now = *state.transferFunction;
    if (now.opacity.empty()) return state;
    const double across = now.opacity.back().value - now.opacity.front().value;
    if (!(across > 0.0)) return state;
    TransferFunction moved = scene::shifted(now, steps * kShiftShare * across);
    if (scene::copiedFrom(moved).empty()) {
        std::set<std::string> taken;
        for (const auto& preset : host.presets) taken.insert(preset->name);
        moved = scene::ownCopy(moved, taken);
    }
    state.transferFunction = std::make_shared<const TransferFunction>(std::move(moved));
    return state;
}

std::string shiftText(const RoomState& state, const RoomHost& host) {
    const TransferFunction& now = *state.transferFunction;
    const auto index = presetIndex(state, host);
    if (!index || now.opacity.empty() || host.presets[*index]->opacity.empty()) return host.words.shift;
    const double across = now.opacity.back().value - now.opacity.front().value;
    double by = now.opacity.front().value - host.presets[*index]->opacity.front().value;
    if (std::abs(by) < 1e-9 * across) by = 0.0;  // rounding of steps back and forth
    // Three digits, but without an exponent: "+1040", and not "+1.04e+03".
    const std::string number =
        std::abs(by) < 999.5 ? fmt::format("{:+.3g}", by + 0.0) : fmt::format("{:+.0f}", by);
    return fmt::format("{} {}{}", host.words.shift, host.words.ofNumber(number),
                       now.unit == Unit::hounsfield ? " HU" : "");
}

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

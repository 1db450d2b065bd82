#include "viewer/session/state_history.h"

#include <iterator>
#include <utility>

#include "base/check.h"

namespace macula::viewer {

void StateHistory::begin(app::StudyState state) {
    states_.assign(1, {.what = {}, .state = std::move(state)});
    place_ = 0;
    joining_ = false;
}

bool StateHistory::push(const QString& what, app::StudyState state, bool joins) {
    const bool goesOn = joins && joining_ && place_ > 0 && states_[place_].what == what;
    if (state == now()) {
        joining_ = joining_ && joins;  // what has not begun is not gone on with
        return false;
    }
    joining_ = joins;
    states_.erase(std::next(states_.begin(), std::ptrdiff_t(place_) + 1), states_.end());
    if (goesOn) {
        states_.back().state = std::move(state);
        return true;
    }
    states_.push_back({.what = what, .state = std::move(state)});
    if (states_.size() > kMostSteps + 1) states_.pop_front();
    place_ = states_.size() - 1;
    return true;
}

bool StateHistory::amend(app::StudyState state) {
    if (state == now()) return false;
    states_[place_].state = std::move(state);
    return true;
}

bool StateHistory::correct(const std::function<void(app::StudyState&)>& edit) {
    const app::StudyState before = now();
    std::deque<Step> left;
    std::size_t place = 0;
    bool lastIsOther = false;
    for (std::size_t i = 0; i < states_.size(); ++i) {
        Step step = states_[i];
        edit(step.state);
        const bool isOther = step.state != states_[i].state;
        const bool isStep = left.empty() || !(isOther || lastIsOther) || step.state != left.back().state;
        lastIsOther = isOther || (lastIsOther && !isStep);
        if (isStep) left.push_back(std::move(step));
        if (i == place_) place = left.size() - 1;
    }
    states_ = std::move(left);
    place_ = place;
    joining_ = false;
    return now() != before;
}

void StateHistory::undo() {
    MACULA_CHECK(canUndo());
    --place_;
    joining_ = false;
}

void StateHistory::redo() {
    MACULA_CHECK(canRedo());
    ++place_;
    joining_ = false;
}

}  // namespace macula::viewer

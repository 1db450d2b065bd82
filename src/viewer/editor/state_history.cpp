#include "viewer/editor/state_history.h"

#include <utility>

#include "base/check.h"

namespace macula::viewer {

void StateHistory::begin(scene::StudyState state) {
    states_.assign(1, {.what = {}, .state = std::move(state)});
    place_ = 0;
    joining_ = false;
    count();
}

void StateHistory::count() {
    bytes_ = {};
    for (const Step& step : states_) bytes_.add(step.state);
}

void StateHistory::forgetAfter(std::size_t place) {
    while (states_.size() > place + 1) {
        bytes_.remove(states_.back().state);
        states_.pop_back();
    }
}

void StateHistory::forgetOldest() {
    while (states_.size() > kMostSteps + 1 || (states_.size() > 2 && bytes_.total() > kMostHistoryBytes)) {
        bytes_.remove(states_.front().state);
        states_.pop_front();
    }
}

bool StateHistory::push(const QString& what, scene::StudyState state, bool joins) {
    const bool goesOn = joins && joining_ && place_ > 0 && states_[place_].what == what;
    if (state == now()) {
        joining_ = joining_ && joins;  // without a first step there is none to join
        return false;
    }
    joining_ = joins;
    forgetAfter(place_);
    if (goesOn) return amend(std::move(state));
    bytes_.add(state);
    states_.push_back({.what = what, .state = std::move(state)});
    forgetOldest();
    place_ = states_.size() - 1;
    return true;
}

bool StateHistory::amend(scene::StudyState state) {
    if (state == now()) return false;
    bytes_.remove(now());
    bytes_.add(state);
    states_[place_].state = std::move(state);
    return true;
}

bool StateHistory::correct(const std::function<void(scene::StudyState&)>& edit) {
    const scene::StudyState before = now();
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
    count();
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

// The undo history of a study's states.
#pragma once

#include <QString>
#include <cstddef>
#include <deque>
#include <functional>

#include "scene/state/state_bytes.h"
#include "scene/state/study_state.h"

namespace macula::viewer {

// States share their large members, so a step is small. The oldest are dropped beyond kMostSteps or
// kMostHistoryBytes; the state before the present one always stays.
inline constexpr std::size_t kMostSteps = 200;
inline constexpr std::size_t kMostHistoryBytes = std::size_t(64) << 20;

class StateHistory {
  public:
    StateHistory() { count(); }
    const scene::StudyState& now() const { return states_[place_].state; }

    void begin(scene::StudyState state);  // drops all earlier states
    // Returns whether the state changed. With `joins`, it replaces the last step if that was also pushed with
    // `joins` and the same `what`, and endJoining() was not called since.
    bool push(const QString& what, scene::StudyState state, bool joins = false);
    // Replaces the present state without a step. Returns whether it changed.
    bool amend(scene::StudyState state);
    // Edits every state, to remove a choice that failed, and drops steps that `edit` made equal to the one
    // before. Returns whether the present state changed.
    bool correct(const std::function<void(scene::StudyState&)>& edit);
    void endJoining() { joining_ = false; }

    bool canUndo() const { return place_ > 0; }
    bool canRedo() const { return place_ + 1 < states_.size(); }
    QString undoText() const { return canUndo() ? states_[place_].what : QString(); }
    QString redoText() const { return canRedo() ? states_[place_ + 1].what : QString(); }
    void undo();
    void redo();

    std::size_t bytes() const { return bytes_.total(); }

  private:
    struct Step {
        QString what;  // names the change that led to `state`
        scene::StudyState state;
    };
    void forgetAfter(std::size_t place);
    void forgetOldest();
    void count();

    std::deque<Step> states_{Step{}};
    scene::StateBytes bytes_;  // the memory that `states_` takes
    std::size_t place_ = 0;
    bool joining_ = false;  // a push may join the last step
};

}  // namespace macula::viewer

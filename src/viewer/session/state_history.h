// The states of a study, in the order in which a person went through them.
#pragma once

#include <QString>
#include <cstddef>
#include <deque>
#include <functional>

#include "scene/state/state_bytes.h"
#include "scene/state/study_state.h"

namespace macula::viewer {

// States share what is large in them, so a step is small. The oldest are forgotten after kMostSteps, and
// where all of them together take more than that; the one before the present always stays.
inline constexpr std::size_t kMostSteps = 200;
inline constexpr std::size_t kMostHistoryBytes = std::size_t(64) << 20;

class StateHistory {
  public:
    StateHistory() { count(); }
    const app::StudyState& now() const { return states_[place_].state; }

    void begin(app::StudyState state);  // and nothing before it
    // Whether it is another one than before. With `joins`, it takes the place of the last step where that was
    // made of the same `what` by such a push, and none has ended it.
    bool push(const QString& what, app::StudyState state, bool joins = false);
    // What comes of itself, and is no step: the state takes the place of that of now. Whether it is another.
    bool amend(app::StudyState state);
    // What is not to be had is taken out of every step: those that `edit` makes the same as the one before
    // are none. Whether the state of now is another.
    bool correct(const std::function<void(app::StudyState&)>& edit);
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
        QString what;  // led to it
        app::StudyState state;
    };
    void forgetAfter(std::size_t place);
    void forgetOldest();
    void count();

    std::deque<Step> states_{Step{}};
    app::StateBytes bytes_;  // of states_
    std::size_t place_ = 0;
    bool joining_ = false;  // the last step goes on
};

}  // namespace macula::viewer

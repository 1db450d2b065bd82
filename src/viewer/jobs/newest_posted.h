// Passes values to the UI thread, where only the newest matters.
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "viewer/jobs/post.h"

namespace macula::viewer {

// Any thread may call it; `take` runs on the thread of `home`. At most one value waits: a newer one replaces
// it, so that a busy thread does not repeat the same work. Copies share the waiting value.
template <class Value>
class NewestPosted {
  public:
    // `home` outlives all calls.
    NewestPosted(QObject* home, std::function<void(const Value&)> take)
        : home_(home), state_(std::make_shared<State>()) {
        state_->take = std::move(take);
    }

    void operator()(Value value) const {
        const std::lock_guard lock(state_->mutex);
        if (std::exchange(state_->waiting, std::move(value))) return;  // a call of take is posted already
        post(home_, [state = state_] {
            std::optional<Value> newest;
            {
                const std::lock_guard taking(state->mutex);
                newest = std::exchange(state->waiting, std::nullopt);
            }
            if (newest) state->take(*newest);
        });
    }

  private:
    struct State {
        std::mutex mutex;
        std::optional<Value> waiting;
        std::function<void(const Value&)> take;
    };

    QObject* home_;
    std::shared_ptr<State> state_;
};

}  // namespace macula::viewer

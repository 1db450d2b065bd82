// The way from other threads to the UI thread.
#pragma once

#include <functional>

class QObject;

namespace macula::viewer {

// Of any thread. `call` is made on the thread that `home` lives on, in its turn among what else is waiting
// there; not at all when `home` is gone by then. `home` lives while this is called.
void post(QObject* home, std::function<void()> call);

}  // namespace macula::viewer

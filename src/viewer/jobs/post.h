// The way from other threads to the UI thread.
#pragma once

#include <functional>

class QObject;

namespace macula::viewer {

// Queues `call` for the thread that `home` lives on; any thread may post. Calls are made in the order in
// which they were posted. A call whose `home` is destroyed before its turn is dropped. `home` must be alive
// until post() returns.
void post(QObject* home, std::function<void()> call);

}  // namespace macula::viewer

#include "viewer/jobs/post.h"

#include <QMetaObject>
#include <QObject>
#include <memory>
#include <utility>

#ifdef MACULA_TELLS_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace macula::viewer {

namespace {

// A posted call. Qt's event queue orders the sender's writes before the receiver's reads, by locks that the
// thread sanitizer does not see; release and acquire make that order visible to it. This file is compiled
// without the sanitizer, because Qt moves the call between the two.
struct Handed {
    explicit Handed(std::function<void()> made) : call(std::move(made)) {
#ifdef MACULA_TELLS_THREAD_SANITIZER
        __tsan_release(this);
#endif
    }
    Handed(const Handed&) = delete;
    Handed& operator=(const Handed&) = delete;
    // A dropped call is destroyed on the receiving thread, too.
    ~Handed() {
        receive();
    }
    void receive() {
#ifdef MACULA_TELLS_THREAD_SANITIZER
        __tsan_acquire(this);
#endif
    }

    std::function<void()> call;
};

}  // namespace

void post(QObject* home, std::function<void()> call) {
    QMetaObject::invokeMethod(
        home,
        [handed = std::make_unique<Handed>(std::move(call))] {
            handed->receive();
            handed->call();
        },
        Qt::QueuedConnection);
}

}  // namespace macula::viewer

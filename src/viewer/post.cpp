#include "viewer/post.h"

#include <QMetaObject>
#include <QObject>
#include <memory>
#include <utility>

#ifdef MACULA_TELLS_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace macula::viewer {

namespace {

// Whatever was written before a call was sent is there when it is received: Qt's queue sees to that by locks
// of its own, which the thread sanitizer has to be told of. It does not look at this file, of which Qt copies
// things in between.
struct Handed {
    explicit Handed(std::function<void()> made) : call(std::move(made)) {
#ifdef MACULA_TELLS_THREAD_SANITIZER
        __tsan_release(this);
#endif
    }
    Handed(const Handed&) = delete;
    Handed& operator=(const Handed&) = delete;
    ~Handed() {
        receive();
    }  // also where nobody is there to be called
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

#include "toolkit/quiet_toolkit.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/oflog/appender.h>
#include <dcmtk/oflog/oflog.h>
#include <dcmtk/oflog/spi/filter.h>

#include <mutex>

namespace macula {

namespace {

namespace logging = dcmtk::log4cplus;

thread_local int quiet = 0;

// Drops the events of this thread: a logger calls its appenders in the thread that logs.
class OfThisThread : public logging::spi::Filter {
  public:
    logging::spi::FilterResult decide(const logging::spi::InternalLoggingEvent& /*event*/) const override {
        return quiet > 0 ? logging::spi::DENY : logging::spi::NEUTRAL;
    }
};

bool isThere(logging::spi::FilterPtr filter) {
    for (; filter.get() != nullptr; filter = filter->next) {
        if (dynamic_cast<const OfThisThread*>(filter.get()) != nullptr) return true;
    }
    return false;
}

// Installs the filter first in the chain of each appender, because a host's appenders may come and go.
void installFilters() {
    for (const logging::SharedAppenderPtr& appender : logging::Logger::getRoot().getAllAppenders()) {
        const logging::thread::MutexGuard lock(appender->access_mutex);
        if (isThere(appender->getFilter())) continue;
        const logging::spi::FilterPtr filter(new OfThisThread);
        filter->next = appender->getFilter();
        appender->setFilter(filter);
    }
}

}  // namespace

QuietToolkit::QuietToolkit() {
    if (quiet++ == 0) installFilters();
}

QuietToolkit::~QuietToolkit() {
    --quiet;
}

void silenceToolkit() {
    static std::once_flag once;
    std::call_once(once, [] { OFLog::configure(OFLogger::OFF_LOG_LEVEL); });
}

}  // namespace macula

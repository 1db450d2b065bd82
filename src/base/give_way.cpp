#include "base/give_way.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace macula {

void giveWay([[maybe_unused]] GiveWay to) {
#ifdef __linux__
    // One that is ten steps back has a tenth of the processor of one that is not, while both want it.
    const int niceness = to == GiveWay::toTheHand ? 7 : to == GiveWay::toTheFrame ? 10 : 19;
    setpriority(PRIO_PROCESS, id_t(gettid()), niceness);  // on Linux of this thread alone
#endif
}

}  // namespace macula

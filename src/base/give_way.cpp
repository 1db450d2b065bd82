#include "base/give_way.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace macula {

void giveWay([[maybe_unused]] GiveWay to) {
#ifdef __linux__
    // A thread ten nice levels lower gets a tenth of the processor time of the other while both want it.
    const int niceness = to == GiveWay::toTheHand ? 7 : to == GiveWay::toTheFrame ? 10 : 19;
    setpriority(PRIO_PROCESS, id_t(gettid()), niceness);  // on Linux this affects the calling thread alone
#endif
}

}  // namespace macula

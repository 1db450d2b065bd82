// In place of what draws a second volume: fuzz_state asks of no state what it leaves stale.
#include "app/study/second_curve.h"
#include "base/check.h"

namespace macula::app {

bool isIn3d(const BesideState&) {
    MACULA_CHECK(false);
    return false;
}

BesideState partIn3d(BesideState state) {
    MACULA_CHECK(false);
    return state;
}

}  // namespace macula::app

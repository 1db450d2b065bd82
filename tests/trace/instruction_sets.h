// Runs native kernels with each instruction set that this processor has.
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>

namespace macula::trace {

// While it lives, native kernels use this instruction set.
class OnlyTarget {
  public:
    explicit OnlyTarget(std::int64_t target) { hwy::SetSupportedTargetsForTest(target); }
    OnlyTarget(const OnlyTarget&) = delete;
    OnlyTarget& operator=(const OnlyTarget&) = delete;
    ~OnlyTarget() { hwy::SetSupportedTargetsForTest(0); }
};

// Calls check() once for each of them, or once if kernels do not run natively.
template <class Check>
void onEachInstructionSet(bool runsNatively, const Check& check) {
    if (!runsNatively) return check();
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        SCOPED_TRACE(hwy::TargetName(target));
        const OnlyTarget only(target);
        check();
    }
}

}  // namespace macula::trace

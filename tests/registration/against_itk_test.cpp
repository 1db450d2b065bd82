// Ours beside ITK's on the same pair. bench_registration has more of them, and times.
#include <gtest/gtest.h>

#include "registration/compared_pairs.h"
#include "registration/itk_registration.h"
#include "registration/moved_volumes.h"
#include "registration/rigid_registration.h"

namespace macula::registration::test {
namespace {

constexpr double kHalfAVoxelMm = 2.1;  // of the phantom

// Two programs that share nothing but the definition come to one place, and both to the true one.
TEST(AgainstItk, BothFindWhatWasMovedBy12MmAnd7Degrees) {
    const ComparedPair pair = movedPair();
    Progress progress;
    const auto ours = registerRigid(*pair.fixed, *pair.moving, progress);
    ASSERT_TRUE(ours.ok()) << ours.error().message;
    const auto itks = registerByItk(*pair.fixed, *pair.moving);
    ASSERT_TRUE(itks.ok()) << itks.error().message;
    EXPECT_GT(errorMm(glm::dmat4(1.0), pair.truth), 4.0 * kHalfAVoxelMm) << "there was nothing to find";
    const double oursMm = errorMm(ours->movingFromFixed, pair.truth);
    const double itksMm = errorMm(itks->movingFromFixed, pair.truth);
    EXPECT_LT(oursMm, kHalfAVoxelMm);
    EXPECT_LT(itksMm, 2.0 * kHalfAVoxelMm) << "it is not set up as it should be";
    EXPECT_LT(oursMm, itksMm + kHalfAVoxelMm)
        << "ITK's is clearly better: docs/registration.md says it is not";
    EXPECT_LT(errorMm(ours->movingFromFixed, itks->movingFromFixed), 3.0 * kHalfAVoxelMm);
}

TEST(AgainstItk, WhatAnImageOfItkCannotHoldIsAnError) {
    const Scan leaning = straightScan(18.0);
    const auto moving = scanOf(leaning, glm::dmat4(1.0));
    const auto itks = registerByItk(*moving, *moving);
    ASSERT_FALSE(itks.ok());
    EXPECT_EQ(itks.error().code, ErrorCode::inputNotUsable);
}

}  // namespace
}  // namespace macula::registration::test

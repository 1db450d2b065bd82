// UIDs can be guessed: what stands for one in an object without a patient is known to who has the key alone.

#include <gtest/gtest.h>

#include <filesystem>

#include "base/sha256.h"
#include "dicom/presentation/presentation_state.h"
#include "dicom/write/uid.h"

namespace macula::dicom {
namespace {

using Uids = std::vector<std::string>;

TEST(StandInUids, CannotBeFoundByGuessing) {
    const std::string uid = "1.2.840.4711.1";
    const auto key = InstallationKey::ofUser();
    ASSERT_TRUE(key) << key.error().message;
    const std::string standIn = standInUid(*key, uid);
    EXPECT_TRUE(standIn.starts_with("2.25.")) << standIn;
    EXPECT_LE(standIn.size(), 64u);
    EXPECT_NE(standIn, uidFrom(uid)) << "which anybody can make";
    EXPECT_NE(standIn, standInUid(*key, "1.2.840.4711.2"));
    EXPECT_EQ(StandInUids().of(uid), (Uids{standIn, uidFrom(uid)})) << "and that of before there were keys";
    EXPECT_EQ(StandInUids().ofDigest(sha256Hex(uid)), StandInUids().of(uid));
    PresentedSeries series;
    series.seriesInstanceUid = standIn;
    EXPECT_TRUE(isSeries(series, sha256Hex(uid)));
    EXPECT_FALSE(isSeries(series, sha256Hex("1.2.840.4711.2")));
    std::filesystem::remove(userDataFolder() / "installation.key");
    EXPECT_FALSE(isSeries(series, sha256Hex(uid))) << "without the key nobody knows it";
    EXPECT_EQ(StandInUids().of(uid), Uids{uidFrom(uid)});
    series.seriesInstanceUid = uidFrom(uid);
    EXPECT_TRUE(isSeries(series, sha256Hex(uid))) << "of before there were keys";
    const auto another = InstallationKey::ofUser();
    ASSERT_TRUE(another);
    EXPECT_NE(standInUid(*another, uid), standIn);
}

}  // namespace
}  // namespace macula::dicom

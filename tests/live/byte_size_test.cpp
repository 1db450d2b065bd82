#include "live/store/byte_size.h"

#include <gtest/gtest.h>

namespace macula::live {
namespace {

TEST(ByteSize, IsShownInMegabytesAndGigabytes) {
    EXPECT_EQ(sizeForPeople(0), "0 MB");
    EXPECT_EQ(sizeForPeople(1), "under 0.1 MB");
    EXPECT_EQ(sizeForPeople(50'000), "0.1 MB");
    EXPECT_EQ(sizeForPeople(1'400'000), "1.4 MB");
    EXPECT_EQ(sizeForPeople(9'949'000), "9.9 MB");
    EXPECT_EQ(sizeForPeople(9'960'000), "10 MB");
    EXPECT_EQ(sizeForPeople(999'400'000), "999 MB");
    EXPECT_EQ(sizeForPeople(999'600'000), "1.0 GB");
    EXPECT_EQ(sizeForPeople(2'000'000'000), "2.0 GB");
    EXPECT_EQ(sizeForPeople(123'000'000'000), "123 GB");
}

TEST(ByteSize, IsReadWithAUnit) {
    EXPECT_EQ(bytesOfText("0B"), 0u);
    EXPECT_EQ(bytesOfText("0 MB"), 0u);
    EXPECT_EQ(bytesOfText("123456789 b"), 123'456'789u);
    EXPECT_EQ(bytesOfText("20 KB"), 20'000u);
    EXPECT_EQ(bytesOfText("2GB"), 2'000'000'000u);
    EXPECT_EQ(bytesOfText("1.5 gb"), 1'500'000'000u);
    EXPECT_EQ(bytesOfText("500MB"), 500'000'000u);
    EXPECT_EQ(bytesOfText("2 GiB"), 2'147'483'648u);
    EXPECT_EQ(bytesOfText("9000000000000000000B"), 9'000'000'000'000'000'000u);
}

TEST(ByteSize, OtherTextIsNone) {
    for (const char* text : {"", "GB", "2XB", "0", "2", "123456789", "1.5", "-1", "-1GB", "1..5GB", "nan",
                             "infGB", "2 GB more", "99999999999999999999B", "9000001TB"})
        EXPECT_EQ(bytesOfText(text), std::nullopt) << text;
}

}  // namespace
}  // namespace macula::live

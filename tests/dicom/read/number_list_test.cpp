#include "dicom/read/number_list.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace macula::dicom {
namespace {

using Values = std::vector<double>;

TEST(NumberList, AsTheStandardAsks) {
    for (const auto& [text, values] : std::vector<std::pair<std::string, Values>>{
             {"0.7\\0.7", {0.7, 0.7}}, {" 1\\ 5 ", {1, 5}}, {"-1e2\\+3.5", {-100, 3.5}}}) {
        const NumberList list = numberListOf(text, 2);
        EXPECT_EQ(list.values, values) << text;
        EXPECT_FALSE(list.isRepaired || list.isMalformed) << text;
    }
    EXPECT_FALSE(numberListOf("", 2).isMalformed) << "nothing is written";
}

TEST(NumberList, OtherSeparatorsHaveOneReading) {
    struct Case {
        std::string text;
        Values values;
    };
    for (const Case& c : std::vector<Case>{{"0.7,0.9", {0.7, 0.9}},
                                           {"0.7, 0.9", {0.7, 0.9}},
                                           {"0.7 0.9", {0.7, 0.9}},
                                           {"0.7;0.9", {0.7, 0.9}},
                                           {"0,7\\0,9", {0.7, 0.9}},
                                           {"0,7 0,9", {0.7, 0.9}},
                                           {"0,7;0,9", {0.7, 0.9}},
                                           {"0,7,0,9", {0.7, 0.9}},
                                           {"0,700\\0,900", {0.7, 0.9}},
                                           {"1 5", {1, 5}},
                                           {"-10.5,-20,98", {-10.5, -20, 98}},
                                           {"-10,-20,98", {-10, -20, 98}},
                                           {"-10,5\\-20,25\\98", {-10.5, -20.25, 98}},
                                           {"1,0,0,0,1,0", {1, 0, 0, 0, 1, 0}},
                                           {"1 0 0 0 1 0", {1, 0, 0, 0, 1, 0}},
                                           {"0,98\\0\\0,19\\0\\1\\0", {0.98, 0, 0.19, 0, 1, 0}}}) {
        const NumberList list = numberListOf(c.text, c.values.size());
        EXPECT_EQ(list.values, c.values) << c.text;
        EXPECT_TRUE(list.isRepaired) << c.text;
    }
}

TEST(NumberList, WithoutOneReadingNothingIsTaken) {
    for (const char* text : {"1,5", "0,7", "1,250\\1,250", "0.7", "0.7\\0.7\\0.7", "0.7,,0.7", "0,7,0,7,0,7",
                             "0.7/0.7", "seven\\seven", "0.7mm 0.7mm", "nan\\nan", "inf,0.7", ",", "\\"}) {
        const NumberList list = numberListOf(text, 2);
        EXPECT_FALSE(list.values.has_value()) << text;
        EXPECT_TRUE(list.isMalformed) << text;
    }
}

}  // namespace
}  // namespace macula::dicom

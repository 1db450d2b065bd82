#include "pictures/picture_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>

namespace macula::pictures {
namespace {

using Names = std::vector<std::string>;

Names namesOf(const Names& requests) {
    return pictureNames(requests);
}

TEST(PictureNames, AreWhatIsLeftOfRequests) {
    EXPECT_EQ(namesOf({"left/0001.JPG", "/home/doe/0002.png", "view.2", "", "../..", ".hidden", "a b:c"}),
              (Names{"left_0001", "0002", "view.2", "camera_0003", "camera_0004", "hidden", "a_b_c"}));
}

TEST(PictureNames, DifferAlsoWithoutTheCaseOfLetters) {
    EXPECT_EQ(namesOf({"a", "A", "a", "a_2"}), (Names{"a", "A_2", "a_3", "a_2_2"}));
}

// Whatever a file names its cameras.
TEST(PictureNames, AreSafeInAnyFolder) {
    std::mt19937 random(1);
    Names requests;
    for (int i = 0; i < 300; ++i) {
        std::string request(random() % 400, ' ');
        std::ranges::generate(request, [&] { return "/\\.:a\xc3\xa4 \n"[random() % 9]; });
        requests.push_back(request);
    }
    const Names names = namesOf(requests);
    ASSERT_EQ(names.size(), requests.size());
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    for (const std::string& name : names) {
        EXPECT_FALSE(name.empty());
        EXPECT_FALSE(name.starts_with('.'));
        EXPECT_LE(name.size(), 130u);  // and what makes it another one
        EXPECT_EQ(name.find_first_of("/\\: \n"), std::string::npos) << name;
    }
}

}  // namespace
}  // namespace macula::pictures

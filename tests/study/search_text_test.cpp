#include "study/list/search_text.h"

#include <gtest/gtest.h>

#include <utility>

namespace macula::study {
namespace {

TEST(SearchText, HasNeitherCaseNorDiacritics) {
    for (const auto& [text, folded] : std::vector<std::pair<std::string, std::string>>{
             {"DOE, John", "doe, john"},
             {"MÜLLER", "muller"},
             {"Mu\u0308ller", "muller"},
             {"Straße", "strasse"},
             {"Łukasz Wałęsa", "lukasz walesa"},
             {"Bjørn Ångström Æbelø", "bjorn angstrom aebelo"},
             {"Þórður Œuvre Ĳssel", "thordur oeuvre ijssel"},
             {"Şükrü Çağlar Iğdır", "sukru caglar igdir"},
             {"Ștefan Țuțea", "stefan tutea"},
             {"Nguyễn Thị Ưu Đức", "nguyen thi uu duc"},
             {"ΣΆΜΟΣ Σάμος", "σαμοσ σαμοσ"},
             {"ПЁТР Пётр Зайцев", "петр петр заицев"},
             {"ＣＴ\u3000ＡＢ", "ct ab"},
             {"山田^太郎", "山田^太郎"},
             {"3 × 4 ÷ 2 µm", "3 × 4 ÷ 2 µm"},
             {"😀", "😀"},
         }) {
        EXPECT_EQ(foldedForSearch(text), folded);
        EXPECT_EQ(foldedForSearch(folded), folded) << "twice is once";
    }
}

TEST(SearchText, BytesThatAreNoUtf8AreKept) {
    for (const char* text : {"\xE9", "a\xC3", "\xF0\x9F\x98", "\xFF\x80", "\xC0\xAF", "\xE0\x80"})
        EXPECT_EQ(foldedForSearch(text), text);
    EXPECT_EQ(foldedForSearch("\xC3"
                              "A"),
              "\xC3"
              "a");
}

TEST(SearchText, WordsAreSeparatedAsNamesAre) {
    using Words = std::vector<std::string>;
    EXPECT_EQ(searchWords(""), Words{});
    EXPECT_EQ(searchWords(" \t, ^="), Words{});
    EXPECT_EQ(searchWords("Doe^John"), (Words{"doe", "john"}));
    EXPECT_EQ(searchWords("  Doe, John\u3000CT "), (Words{"doe", "john", "ct"}));
    EXPECT_EQ(searchWords("2020-03-04"), Words{"2020-03-04"});
}

TEST(SearchText, AllWordsHaveToBeThere) {
    const std::string text = foldedForSearch("Müller, Jörg\nID 4711");
    EXPECT_TRUE(holdsAll(text, {}));
    EXPECT_TRUE(holdsAll(text, searchWords("jorg MULLER")));
    EXPECT_TRUE(holdsAll(text, searchWords("711")));
    EXPECT_FALSE(holdsAll(text, searchWords("müller 4712")));
}

}  // namespace
}  // namespace macula::study

// Texts in English, and in formats of another language.
#include "base/text.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

namespace macula {
namespace {

TEST(Text, PutsArgumentsIntoItsPlaces) {
    EXPECT_EQ(Text("Nothing {here} is a place.").english(), "Nothing {here} is a place.");
    EXPECT_EQ(Text("{} of {} slices", 3, std::size_t{40}).english(), "3 of 40 slices");
    EXPECT_EQ(Text("{1} before {0:.2f} mm, {{and}} {1}", 1.25, "a").english(), "a before 1.25 mm, {and} a");
    EXPECT_EQ(Text("{:>6}|{:04}|{:.1f}", std::string("left"), -7, 0.05).english(), "  left|-007|0.1");
    EXPECT_EQ(Text("A table was not looked for: {}", Text("the axes of {} differ.", "it")).english(),
              "A table was not looked for: the axes of it differ.");
    EXPECT_TRUE(Text().empty());
    EXPECT_EQ(Text().english(), "");
}

TEST(Text, FindsArgumentsByName) {
    const Text text =
        Text::of("{parts} apart: {volume:.0f} mL ({parts})",
                 {{"volume", 12.4}, {"parts", Text("{} parts", 2)}, {"unused", std::int64_t{1}}});
    EXPECT_EQ(text.english(), "2 parts apart: 12 mL (2 parts)");
}

TEST(Text, WordsOfOthersStayAsTheyAre) {
    EXPECT_EQ(Text::verbatim("{} of {0} 50 %").english(), "{} of {0} 50 %");
    EXPECT_TRUE(Text::verbatim("").empty());
    const Text list = Text::joined({Text("one"), {}, Text::verbatim("{two}")}, ", ");
    EXPECT_EQ(list.english(), "one, {two}");
    EXPECT_TRUE(Text::joined({}, ", ").empty());
    EXPECT_EQ(Text::joined({Text("alone")}, ", "), Text("alone"));
}

// Formats of a translation are not checked by the compiler.
TEST(Text, AFormatThatDoesNotFitNeverThrows) {
    const std::vector<TextArgument> arguments{{{}, std::int64_t{5}}, {"name", std::string("a")}};
    const auto english = [&](std::string_view format) { return filled(format, arguments, englishOf); };
    EXPECT_EQ(english("{} {} {}"), "5 a {}");
    EXPECT_EQ(english("{7} {other} {name}"), "{7} {other} a");
    EXPECT_EQ(english("{0:q} {name:d}"), "{:q} {:d}");
    EXPECT_EQ(english("open { at the end"), "open { at the end");
    EXPECT_EQ(english("closed } {0"), "closed } {0");
    EXPECT_EQ(english("}} {{ {0}"), "} { 5");
    EXPECT_EQ(english("{"), "{");
    EXPECT_EQ(english(""), "");
    EXPECT_EQ(english("{99999999999999999999999}"), "{99999999999999999999999}");
}

TEST(Text, HoldsAnyNumber) {
    EXPECT_EQ(Text("{}", std::numeric_limits<std::int64_t>::min()).english(), "-9223372036854775808");
    EXPECT_EQ(Text("{} {}", std::numeric_limits<double>::infinity(), 5e-324).english(), "inf 5e-324");
    EXPECT_EQ(Text("{:.1f}", std::numeric_limits<double>::quiet_NaN()).english(), "nan");
}

TEST(Text, IsTheSameOnlyWithTheSameArguments) {
    EXPECT_EQ(Text("{} mm", 2), Text("{} mm", 2));
    EXPECT_FALSE(Text("{} mm", 2) == Text("{} mm", 3));
    EXPECT_FALSE(Text("{} mm", 2) == Text("2 mm"));
    EXPECT_TRUE(Text("{} mm", 2) == std::string_view("2 mm"));
    std::ostringstream out;
    out << Text("{} mm", 2);
    EXPECT_EQ(out.str(), "2 mm");
}

}  // namespace
}  // namespace macula

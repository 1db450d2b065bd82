// What a program does not know of a document stays in it.
#include "session/json_members.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace macula::session {
namespace {

using nlohmann::json;
using Known = std::vector<std::string_view>;

json merged(const char* written, const char* before, const Known& known) {
    return json::parse(withUnknownMembers(written, before, known));
}

TEST(JsonMembers, UnknownOnesStayAndKnownOnesGo) {
    const Known known{"preset", "clip"};
    EXPECT_EQ(
        merged(R"({"preset": "b"})", R"({"preset": "a", "clip": 1, "future": [1, {"x": null}]})", known),
        json::parse(R"({"preset": "b", "future": [1, {"x": null}]})"));
}

TEST(JsonMembers, ObjectsAreLookedIntoWhereTheirMembersAreKnown) {
    const char* before = R"({"camera": {"eye": 1, "roll": 2, "lens": {"f": 3}}})";
    EXPECT_EQ(merged(R"({"camera": {"eye": 5}})", before, {"camera", "camera.eye", "camera.roll"}),
              json::parse(R"({"camera": {"eye": 5, "lens": {"f": 3}}})"));
    EXPECT_EQ(merged(R"({"camera": {"eye": 5}})", before, {"camera"}),
              json::parse(R"({"camera": {"eye": 5}})"));
    EXPECT_EQ(merged(R"({"camera": null})", before, {"camera", "camera.eye"}),
              json::parse(R"({"camera": null})"));
}

TEST(JsonMembers, TextStaysAsItIsWhereNothingIsAdded) {
    const std::string text = "{ \"b\": 1.0,\n \"a\": 2 }";
    EXPECT_EQ(withUnknownMembers(text, R"({"a": 1})", Known{}), text);
    EXPECT_EQ(withUnknownMembers(text, "broken", Known{}), text);
}

TEST(JsonMembers, OnlyObjectsWithinLimitsAreDocuments) {
    EXPECT_TRUE(isDocument("{}"));
    for (const char* text : {"", "[]", "1", "{", "{} {}", "null", "{\"a\": 1e999}", "{\"a\": \"\xff\"}"})
        EXPECT_FALSE(isDocument(text)) << text;
    const auto nested = [](int levels) {
        return "{\"a\":" + std::string(static_cast<std::size_t>(levels), '[') +
               std::string(static_cast<std::size_t>(levels), ']') + "}";
    };
    EXPECT_TRUE(isDocument(nested(kMostJsonDepth - 1)));
    EXPECT_FALSE(isDocument(nested(kMostJsonDepth + 1)));
    EXPECT_FALSE(isDocument(nested(100'000)));
    EXPECT_FALSE(isDocument("{\"a\": \"" + std::string(kMostJsonBytes, 'x') + "\"}"));
}

}  // namespace
}  // namespace macula::session

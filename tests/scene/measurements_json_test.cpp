// Measurements in the text of a state: all kinds come back, in their order, and what is hostile is refused.
#include "scene/state/measurements_json.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "scene/state/state_bytes.h"
#include "scene/state/study_state.h"

namespace macula::scene {
namespace {

using Json = nlohmann::json;
using slices::Measurement;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

StudyState with(std::vector<Measurement> measurements) {
    StudyState state;
    state.measurements = std::move(measurements);
    return state;
}

// One of each kind; new ones stand between those that older programs know.
std::vector<Measurement> all() {
    return {{.label = "Lesion 1",
             .shape = slices::Bidirectional{.firstMm = {{{1, 2, 3}, {4.5, 2, 3}}},
                                            .secondMm = {{{2, 1, 3}, {2, 3.25, 3}}},
                                            .isNode = true}},
            {.shape = slices::Distance{{glm::dvec3(1, 2, 3), {4, 5, 6}}}},
            {.label = "here", .shape = slices::Arrow{{1, 1, 1}, {2, 2, 1}}, .normal = {0, 0, -1}},
            {.shape = slices::Ellipse{.radiiMm = {3, 4}}},
            {.shape = slices::Outline{{{0, 0, 0}, {1, 0, 0}, {0.1, 1.0 / 3.0, 0}}}},
            {.shape = slices::Angle{{glm::dvec3(1, 0, 0), {0, 0, 0}, {0, 1, 0}}}},
            {.shape = slices::OpenLine{{{0, 0, 0}, {1, 0, 0}}}},
            {.shape = slices::CobbAngle{{glm::dvec3(0, 0, 0), {1, 0, 0}, {0, 5, 0}, {1, 6, 0}}}}};
}

std::vector<Measurement> read(const std::string& text) {
    const auto state = studyStateFromJson(text, "a state");
    EXPECT_TRUE(state.ok()) << (state.ok() ? "" : state.error().message.english());
    return state.ok() ? state->measurements : std::vector<Measurement>{};
}

TEST(MeasurementsJson, AllKindsComeBackInTheirOrder) {
    EXPECT_EQ(read(toJson(with(all()))), all());
    EXPECT_EQ(read(toJson(with({all()[0]}))), std::vector{all()[0]});
    EXPECT_TRUE(read(toJson(with({}))).empty());
}

// It refuses a state whose "measurements" have a kind that it does not know, and keeps keys that it does not
// know.
TEST(MeasurementsJson, AnOlderProgramCanReadWhatItKnows) {
    const Json json = Json::parse(toJson(with(all())));
    ASSERT_EQ(json["measurements"].size(), 3u);
    EXPECT_EQ(json["measurements"][0]["kind"], "distance");
    EXPECT_EQ(json["measurements"][1]["kind"], "ellipse");
    EXPECT_EQ(json["measurements"][2]["kind"], "angle");
    EXPECT_EQ(json["furtherMeasurements"].size(), 5u);
    const Json plain = Json::parse(toJson(with({all()[1], all()[3]})));
    EXPECT_FALSE(plain.contains("furtherMeasurements"));
    EXPECT_FALSE(plain.contains("measurementOrder")) << "a state is as before";

    // It removed a distance and wrote the rest as it was: the order does not fit, and nothing else is lost.
    Json changed = json;
    changed["measurements"].erase(0);
    EXPECT_EQ(read(changed.dump()).size(), all().size() - 1);
}

TEST(MeasurementsJson, AnOrderThatDoesNotFitIsIgnored) {
    for (const Json& order :
         {Json{0, 1, 2}, Json{0, 0, 1, 2, 3, 4, 5, 6}, Json{0, 1, 2, 3, 4, 5, 6, 99}, Json::array()}) {
        Json json = Json::parse(toJson(with(all())));
        json["measurementOrder"] = order;
        const auto measurements = read(json.dump());
        ASSERT_EQ(measurements.size(), all().size());
        EXPECT_EQ(measurements[0], all()[1]) << "those of the first list come first";
    }
}

TEST(MeasurementsJson, WhatIsHostileIsRefusedWithItsPlace) {
    const auto tells = [](const std::string& expected, const std::function<void(Json&)>& change) {
        Json json = Json::parse(toJson(with(all())));
        change(json["furtherMeasurements"]);
        const auto state = studyStateFromJson(json.dump(), "a state");
        ASSERT_FALSE(state.ok()) << expected;
        EXPECT_EQ(state.error().code, ErrorCode::inputNotUsable);
        const std::string said = state.error().message.english() + " " + state.error().hint.english();
        EXPECT_NE(said.find(expected), std::string::npos) << said;
    };
    Json many = Json::array();
    for (int i = 0; i < 100000; ++i) many.push_back({0.5 * i, 0.0, 0.0});
    tells("furtherMeasurements[0].pointsMm", [](Json& j) { j[0]["pointsMm"] = Json::array(); });
    tells("furtherMeasurements[2].pointsMm", [](Json& j) { j[2]["pointsMm"] = {{0, 0, 0}, {1, 1, 1}}; });
    tells("a list of 3 to 1000", [&](Json& j) { j[2]["pointsMm"] = many; });
    tells("a list of 2 to 1000", [&](Json& j) { j[3]["pointsMm"] = many; });
    tells("a list of 4", [&](Json& j) { j[0]["pointsMm"] = many; });
    tells("furtherMeasurements[3].pointsMm[1][0]", [](Json& j) { j[3]["pointsMm"][1][0] = 1e300; });
    tells("furtherMeasurements[0].node", [](Json& j) { j[0]["node"] = "yes"; });
    tells("node is unknown", [](Json& j) { j[1]["node"] = true; });
    tells("\"bidirectional\"", [](Json& j) { j[0]["kind"] = "tridirectional"; });
}

TEST(MeasurementsJson, WhatTheReaderWouldRefuseIsNotWritten) {
    slices::Outline far{{{0, 0, 0}, {1, 0, 0}, {0, kNaN, 0}}};
    slices::Outline many;
    for (std::size_t i = 0; i <= kMostDrawnPoints; ++i) many.pointsMm.emplace_back(double(i), 0.0, 0.0);
    const std::vector<Measurement> bad{{.shape = far},
                                       {.shape = many},
                                       {.shape = slices::Outline{}},
                                       {.shape = slices::OpenLine{}},
                                       {.shape = slices::Arrow{{kNaN, 0, 0}, {}}},
                                       {.shape = slices::Bidirectional{.firstMm = {{{kNaN, 0, 0}, {}}}}}};
    EXPECT_TRUE(read(toJson(with(bad))).empty());
    many.pointsMm.pop_back();
    EXPECT_EQ(read(toJson(with({{.shape = many}}))).size(), 1u);
    std::vector<Measurement> most(kMostMeasurements + 5, all()[0]);
    most[0] = all()[1];
    EXPECT_EQ(read(toJson(with(most))).size(), kMostMeasurements);
}

TEST(StateBytesTest, CountThePointsOfAnOutline) {
    slices::Outline outline;
    outline.pointsMm.assign(1000, glm::dvec3(0.0));
    StateBytes bytes, without;
    bytes.add(with({{.shape = outline}}));
    without.add(with({{.shape = slices::Outline{}}}));
    EXPECT_EQ(bytes.total() - without.total(), 1000 * sizeof(glm::dvec3));
}

}  // namespace
}  // namespace macula::scene

// What was measured on other studies, read from a real store in a folder of the test.
#include "live/store/kept_measurements.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/sha256.h"
#include "live/store/kept_states.h"
#include "scene/state/study_state.h"

namespace macula::live {
namespace {

namespace fs = std::filesystem;

class KeptMeasurementsTest : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "macula-measured-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
        auto opened = session::Store::open({.folder = folder_ / "sessions"});
        ASSERT_TRUE(opened) << opened.error().message.english();
        store_.emplace(*std::move(opened));
    }
    void TearDown() override {
        store_.reset();
        fs::remove_all(folder_);
    }

    static std::string digestOf(const std::string& what) { return sha256Hex(what); }
    // As KeptStates keeps it, with the name of a volume.
    void keep(const std::string& study, const std::string& volume, const std::string& json,
              const std::string& name = kKeptStateName) {
        ASSERT_TRUE(
            store_->recordOpened({.study = study, .series = digestOf(study + volume), .volume = volume}));
        ASSERT_TRUE(store_->putDocument({.study = study, .name = volume + " " + name}, 1, json, {}));
    }
    static std::string stateWith(const std::string& label) {
        scene::StudyState state;
        state.measurements = {{.label = label, .shape = slices::Distance{{glm::dvec3(0.0), {7.0, 0.0, 0.0}}}},
                              {.shape = slices::Outline{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}};
        return toJson(state);
    }

    fs::path folder_;
    std::optional<session::Store> store_;
};

TEST_F(KeptMeasurementsTest, AreThoseOfAllVolumesOfTheStudiesThatAreAskedFor) {
    const std::string now = digestOf("now"), prior = digestOf("prior"), other = digestOf("somebody else");
    keep(now, digestOf("a"), stateWith("on screen"));
    keep(now, digestOf("b"), stateWith("other series"));
    keep(prior, digestOf("c"), stateWith("liver"));
    keep(prior, digestOf("d"), stateWith("set aside"),
         std::string(kKeptStateName) + ", of another window 1234");
    keep(other, digestOf("e"), stateWith("of another patient"));
    const auto kept = keptMeasurements(
        *store_, std::vector<StudyToRead>{{now, digestOf("a")}, {prior}, {digestOf("never opened")}, {}});
    ASSERT_TRUE(kept) << kept.error().message.english();
    ASSERT_EQ(kept->size(), 4u);
    ASSERT_EQ((*kept)[0].measurements.size(), 2u);
    EXPECT_EQ((*kept)[0].measurements[0].label, "other series");
    EXPECT_EQ((*kept)[0].volumes, 1u);
    ASSERT_EQ((*kept)[1].measurements.size(), 2u);
    EXPECT_EQ((*kept)[1].measurements[0].label, "liver");
    EXPECT_EQ((*kept)[2].volumes, 0u);
    EXPECT_EQ((*kept)[3].volumes, 0u);
}

TEST_F(KeptMeasurementsTest, CountsStatesThatItCannotRead) {
    const std::string study = digestOf("study");
    keep(study, digestOf("a"), R"({"version": 99})");
    keep(study, digestOf("b"), stateWith("liver"));
    const auto kept = keptMeasurements(*store_, std::vector<StudyToRead>{{study}});
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->front().unreadable, 1u);
    EXPECT_EQ(kept->front().volumes, 1u);
    EXPECT_EQ(kept->front().measurements.size(), 2u);
}

TEST_F(KeptMeasurementsTest, KnowWhichLesionsAPersonCalledGone) {
    const std::string study = digestOf("study");
    keep(study, digestOf("b"), stateWith("liver"));
    const auto gone = [&] {
        const auto kept = keptMeasurements(*store_, std::vector<StudyToRead>{{study}});
        EXPECT_TRUE(kept);
        return kept ? kept->front().gone : std::vector<std::string>{};
    };
    using Lesions = std::vector<std::string>;
    EXPECT_TRUE(gone().empty());
    ASSERT_TRUE(keepGone(*store_, study, Lesions{"lung 1", "größe"}));
    EXPECT_EQ(gone(), (Lesions{"lung 1", "größe"}));
    ASSERT_TRUE(keepGone(*store_, study, Lesions{"lung 1"}));
    EXPECT_EQ(gone(), Lesions{"lung 1"});
    ASSERT_TRUE(keepGone(*store_, study, Lesions{}));
    EXPECT_TRUE(gone().empty());
    // What another program wrote there is not believed.
    for (const char* text :
         {R"({"gone": 7})", R"({"gone": [1, "", null, {"a": 1}]})", R"({"lost": ["a"]})"}) {
        ASSERT_TRUE(store_->putDocument(
            {.kind = session::DocumentKind::measurement, .study = study, .name = "follow-up"}, 1, text, {}));
        EXPECT_TRUE(gone().empty()) << text;
    }
}

}  // namespace
}  // namespace macula::live

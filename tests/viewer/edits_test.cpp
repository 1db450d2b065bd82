// Every kind of edit of a study, in any order: undone, done again, saved, and read back as it was.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "scene/choice/catalogue.h"
#include "scene/state/parameters.h"
#include "scene/state/study_state.h"
#include "scene/transfer/same_transfer.h"
#include "viewer/editor/study_editor.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}

    std::size_t below(std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_);
    }
    bool coin() { return below(2) == 0; }
    double number(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    glm::dvec3 pointMm() { return {number(-200, 200), number(-200, 200), number(-200, 200)}; }
    template <class List>
    const auto& of(const List& list) {
        return list[below(list.size())];
    }

  private:
    std::mt19937_64 engine_;
};

DisplayWindow aWindow(Dice& dice) {
    return {.center = dice.number(-1000, 3000),
            .width = dice.number(1, 4000),
            .explanation = {},
            .function = "LINEAR_EXACT"};
}

slices::Measurement aMeasurement(Dice& dice) {
    slices::Measurement made{.label = dice.coin() ? "Läsion \"1\"\n" : "", .shape = slices::Distance{}};
    switch (dice.below(5)) {
        case 0:
            made.shape = slices::Distance{.endsMm = {dice.pointMm(), dice.pointMm()}};
            break;
        case 1:
            made.shape = slices::Angle{.pointsMm = {dice.pointMm(), dice.pointMm(), dice.pointMm()}};
            break;
        case 2:
            made.shape = slices::Bidirectional{.firstMm = {dice.pointMm(), dice.pointMm()},
                                               .secondMm = {dice.pointMm(), dice.pointMm()},
                                               .isNode = dice.coin()};
            break;
        case 3:
            made.shape = slices::CobbAngle{
                .pointsMm = {dice.pointMm(), dice.pointMm(), dice.pointMm(), dice.pointMm()}};
            break;
        default: {
            slices::Ellipse ellipse;
            ellipse.plane.centreMm = dice.pointMm();
            ellipse.radiiMm = {dice.number(0.1, 80), dice.number(0.1, 80)};
            made.shape = ellipse;
        }
    }
    return made;
}

void editPreset(scene::StudyState& next, const scene::Catalogue& catalogue, Dice& dice) {
    auto made = std::make_shared<TransferFunction>(*dice.of(catalogue.presets));
    if (dice.coin()) {  // one of a person's own
        made->name = "own";
        made->title = "Eigenes & \"neu\"";
        made->density = dice.number(0.1, 10);
    }
    next.preset = std::move(made);
}

void editClip(scene::StudyState& next, const scene::Catalogue& catalogue, Dice& dice) {
    next.clip.reset();
    if (dice.below(3) > 0) next.clip = *dice.of(catalogue.clips);
}

scene::OptionalClip aClip(const scene::Catalogue& catalogue, Dice& dice) {
    return dice.coin() ? scene::OptionalClip(*dice.of(catalogue.clips)) : std::nullopt;
}

scene::Cuts someCuts(Dice& dice) {
    scene::Cuts cuts;
    Camera camera;
    camera.positionMm = dice.pointMm() + glm::dvec3(0.0, -900.0, 0.0);
    if (dice.coin()) camera.parallelHeightMm = dice.number(1, 900);
    if (dice.coin()) {
        scene::EyeCut eye;
        eye.plane = {.normal = glm::normalize(camera.targetMm - camera.positionMm),
                     .offsetMm = dice.number(-200, 200)};
        eye.fromMiddleMm = dice.number(-200, 200);
        eye.followsCamera = dice.coin();
        cuts.eye = eye;
    }
    for (std::size_t i = dice.below(3); i > 0; --i) {
        scene::ScissorCut cut;
        cut.camera = camera;
        cut.outline = {{dice.number(-1, 0), -0.5}, {dice.number(0.1, 1), -0.4}, {0.0, dice.number(0, 1)}};
        cut.removesOutside = dice.coin();
        cuts.scissors.push_back(cut);
    }
    return cuts;
}

void editCuts(scene::StudyState& next, const scene::Catalogue&, Dice& dice) {
    next.cuts = someCuts(dice);
}

void editNamedClips(scene::StudyState& next, const scene::Catalogue& catalogue, Dice& dice) {
    if (!next.namedClips.empty() && dice.below(3) == 0) {
        next.namedClips.pop_back();
        return;
    }
    scene::NamedClip named;
    named.name = "Kürzer & \"" + std::to_string(next.namedClips.size());
    named.clip = aClip(catalogue, dice);
    named.cuts = someCuts(dice);
    next.namedClips.push_back(named);
}

void editLights(scene::StudyState& next, const scene::Catalogue& catalogue, Dice& dice) {
    next.lights = dice.coin() ? nullptr : dice.of(catalogue.lights);
}

void editLook(scene::StudyState& next, const scene::Catalogue&, Dice& dice) {
    next.settings.look = dice.of(trace::kLooks).look;
    next.settings.shading = dice.coin() ? trace::Shading::headlight : trace::Shading::none;
}

void editNumber(scene::StudyState& next, const scene::Catalogue&, Dice& dice) {
    const scene::Parameter& parameter = dice.of(scene::parameters());
    const double value = dice.number(parameter.low, parameter.high);
    parameter.set(next.settings, parameter.isWhole ? std::floor(value) : value);
}

void editWindow(scene::StudyState& next, const scene::Catalogue&, Dice& dice) {
    const std::size_t look = dice.below(trace::kLooks.size());
    if (!trace::isProjection(trace::kLooks[look].look)) return;
    next.windows.at(look).reset();
    if (dice.below(4) > 0) next.windows.at(look) = aWindow(dice);
}

void editCamera(scene::StudyState& next, const scene::Catalogue&, Dice& dice) {
    Camera camera;
    camera.positionMm = dice.pointMm() + glm::dvec3(0.0, -900.0, 0.0);
    camera.targetMm = dice.pointMm();
    camera.verticalFovDeg = dice.number(10, 90);
    if (dice.coin()) camera.parallelHeightMm = dice.number(1, 900);
    next.camera = camera;
}

void editMarks(scene::StudyState& next, const scene::Catalogue&, Dice&) {
    next.showsMarks = !next.showsMarks;
}

void editBackground(scene::StudyState& next, const scene::Catalogue&, Dice& dice) {
    next.background.reset();
    if (dice.below(4) > 0)
        next.background = scene::BackgroundColour(dice.below(256), dice.below(256), dice.below(256));
}

void editPanes(scene::StudyState& next, const scene::Catalogue&, Dice& dice) {
    next.layout = dice.of(scene::kLayouts);
}

void editSlices(scene::StudyState& next, const scene::Catalogue&, Dice& dice) {
    scene::SliceState& slices = next.slices;
    switch (dice.below(5)) {
        case 0:
            slices.window = aWindow(dice);
            return;
        case 1:
            slices.slab = {.thicknessMm = dice.number(0.5, 50), .projection = slices::Projection::maximum};
            return;
        case 2:
            slices.isInverted = !slices.isInverted;
            return;
        case 3:
            slices.asAcquired = !slices.asAcquired;
            return;
        default:
            slices.crosshairMm = dice.pointMm();
    }
}

void editMeasurements(scene::StudyState& next, const scene::Catalogue&, Dice& dice) {
    if (!next.measurements.empty() && dice.below(3) == 0) {
        next.measurements.erase(next.measurements.begin() +
                                std::ptrdiff_t(dice.below(next.measurements.size())));
    } else {
        next.measurements.push_back(aMeasurement(dice));
    }
}

void editSegments(scene::StudyState& next, const scene::Catalogue&, Dice& dice) {
    const std::string digest(64, "0a"[dice.below(2)]);
    scene::SegmentationSettings choice = scene::choiceOf(next.segmentations, digest);
    choice.isShown = dice.coin();
    scene::choose(next.segmentations, choice);
    scene::SegmentSettings segment = scene::choiceOf(choice, std::uint16_t(1 + dice.below(5)));
    segment.isVisible = dice.coin();
    segment.opacity = dice.number(0, 1);
    segment.in3d = dice.of(scene::kIn3d);
    if (dice.coin()) segment.rgb = {std::uint8_t(dice.below(256)), 7, 255};
    scene::choose(next.segmentations, digest, segment);
}

void editSecond(scene::StudyState& next, const scene::Catalogue&, Dice& dice) {
    next.secondVolume.reset();
    if (dice.below(4) == 0) return;
    scene::SecondVolumeState beside;
    beside.seriesDigest = std::string(64, 'b');
    if (dice.coin()) beside.volume = std::size_t(dice.number(0, 20));
    beside.link = dice.of(scene::kSecondVolumeLinks);
    beside.view = dice.of(scene::kSecondVolumePlaces);
    if (beside.link != scene::SecondVolumeLink::sameFrame) {
        const double turn = dice.number(-0.5, 0.5);
        beside.secondFromStudy[0] = {std::cos(turn), std::sin(turn), 0.0, 0.0};
        beside.secondFromStudy[1] = {-std::sin(turn), std::cos(turn), 0.0, 0.0};
        beside.secondFromStudy[3] = glm::dvec4(dice.pointMm(), 1.0);
    }
    if (beside.link == scene::SecondVolumeLink::registered) beside.boundMm = dice.number(0, 5);
    if (dice.coin()) beside.window = aWindow(dice);
    beside.opacity = dice.number(0, 1);
    next.secondVolume = beside;
}

void editTable(scene::StudyState& next, const scene::Catalogue&, Dice&) {
    next.leavesTableOut = !next.leavesTableOut;
}

using Edit = void (*)(scene::StudyState&, const scene::Catalogue&, Dice&);
constexpr std::array<Edit, 17> kEdits{
    editPreset,   editClip,         editLights, editLook,       editNumber,    editWindow,
    editCamera,   editMarks,        editPanes,  editSlices,     editTable,     editSecond,
    editSegments, editMeasurements, editCuts,   editNamedClips, editBackground};

class EditsTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        auto catalogue = scene::builtInCatalogue();
        ASSERT_TRUE(catalogue.ok());
        session_.emplace(*std::move(catalogue));
        session_->show(smallStudy(), {});
    }
    void TearDown() override {
        session_.reset();
        OffscreenTest::TearDown();
    }
    // Whether something was changed.
    bool edit(Dice& dice) {
        const scene::StudyState before = session_->state();
        session_->change(QStringLiteral("Edit"), [&](scene::StudyState& next) {
            kEdits[dice.below(kEdits.size())](next, session_->catalogue(), dice);
        });
        return !(session_->state() == before);
    }

    std::optional<StudyEditor> session_;
};

TEST_F(EditsTest, EachIsUndoneAndDoneAgain) {
    Dice dice(1);
    std::vector<scene::StudyState> states{session_->state()};
    while (states.size() < 150) {  // fewer than are remembered
        if (edit(dice)) states.push_back(session_->state());
    }
    for (std::size_t i = states.size() - 1; i-- > 0;) {
        ASSERT_TRUE(session_->canUndo());
        session_->undo();
        ASSERT_EQ(session_->state(), states[i]) << i;
    }
    EXPECT_FALSE(session_->canUndo());
    // Back and forth, as somebody who compares.
    std::size_t at = 0;
    for (int step = 0; step < 500; ++step) {
        const bool back = dice.below(5) < 2;
        if (back && at > 0) {
            session_->undo();
            --at;
        } else if (!back && at + 1 < states.size()) {
            session_->redo();
            ++at;
        }
        ASSERT_EQ(session_->state(), states[at]) << step;
    }
}

TEST_F(EditsTest, EachIsSavedAndReadBack) {
    Dice dice(2);
    std::set<std::string> keys;
    for (int step = 0; step < 400; ++step) {
        edit(dice);
        const std::string text = toJson(session_->state());
        const auto read = scene::studyStateFromJson(text, {});
        ASSERT_TRUE(read.ok()) << read.error().message << " " << read.error().hint << "\n" << text;
        const scene::StudyState& state = session_->state();
        ASSERT_EQ(read->preset == nullptr, state.preset == nullptr);
        EXPECT_TRUE(!state.preset || scene::isSame(*read->preset, *state.preset));
        ASSERT_TRUE(*read == state) << (read->clip == state.clip) << (read->settings == state.settings)
                                    << (read->windows == state.windows) << (read->camera == state.camera)
                                    << (read->slices == state.slices)
                                    << (read->measurements == state.measurements)
                                    << (read->segmentations == state.segmentations)
                                    << (read->secondVolume == state.secondVolume)
                                    << (read->cuts == state.cuts) << (read->namedClips == state.namedClips)
                                    << " " << text;
        const nlohmann::json json = nlohmann::json::parse(text);
        for (const auto& [key, value] : json.items()) keys.insert(key);
    }
    // A part of the state that no edit above changes would be tested by nothing.
    for (const char* ofTheStudy : {"series", "grid"}) keys.insert(ofTheStudy);
    for (const std::string& key : scene::stateKeys()) EXPECT_TRUE(keys.contains(key)) << key;
}

}  // namespace
}  // namespace macula::viewer

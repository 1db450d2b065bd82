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
#include "scene/state/state_keys.h"
#include "scene/transfer/same_transfer.h"
#include "viewer/offscreen.h"
#include "viewer/session/viewer_session.h"

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
    switch (dice.below(3)) {
        case 0:
            made.shape = slices::Distance{.endsMm = {dice.pointMm(), dice.pointMm()}};
            break;
        case 1:
            made.shape = slices::Angle{.pointsMm = {dice.pointMm(), dice.pointMm(), dice.pointMm()}};
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

void editPreset(app::StudyState& next, const app::Catalogue& catalogue, Dice& dice) {
    auto made = std::make_shared<TransferFunction>(*dice.of(catalogue.presets));
    if (dice.coin()) {  // one of a person's own
        made->name = "own";
        made->title = "Eigenes & \"neu\"";
        made->density = dice.number(0.1, 10);
    }
    next.preset = std::move(made);
}

void editClip(app::StudyState& next, const app::Catalogue& catalogue, Dice& dice) {
    next.clip.reset();
    if (dice.below(3) > 0) next.clip = *dice.of(catalogue.clips);
}

app::ClipChoice aClip(const app::Catalogue& catalogue, Dice& dice) {
    return dice.coin() ? app::ClipChoice(*dice.of(catalogue.clips)) : std::nullopt;
}

app::Cuts someCuts(Dice& dice) {
    app::Cuts cuts;
    Camera camera;
    camera.positionMm = dice.pointMm() + glm::dvec3(0.0, -900.0, 0.0);
    if (dice.coin()) camera.parallelHeightMm = dice.number(1, 900);
    if (dice.coin()) {
        app::EyeCut eye;
        eye.plane = {.normal = glm::normalize(camera.targetMm - camera.positionMm),
                     .offsetMm = dice.number(-200, 200)};
        eye.fromMiddleMm = dice.number(-200, 200);
        eye.followsCamera = dice.coin();
        cuts.eye = eye;
    }
    for (std::size_t i = dice.below(3); i > 0; --i) {
        app::ScissorCut cut;
        cut.camera = camera;
        cut.outline = {{dice.number(-1, 0), -0.5}, {dice.number(0.1, 1), -0.4}, {0.0, dice.number(0, 1)}};
        cut.removesOutside = dice.coin();
        cuts.scissors.push_back(cut);
    }
    return cuts;
}

void editCuts(app::StudyState& next, const app::Catalogue&, Dice& dice) {
    next.cuts = someCuts(dice);
}

void editNamedClips(app::StudyState& next, const app::Catalogue& catalogue, Dice& dice) {
    if (!next.namedClips.empty() && dice.below(3) == 0) {
        next.namedClips.pop_back();
        return;
    }
    app::NamedClip named;
    named.name = "Kürzer & \"" + std::to_string(next.namedClips.size());
    named.clip = aClip(catalogue, dice);
    named.cuts = someCuts(dice);
    next.namedClips.push_back(named);
}

void editLights(app::StudyState& next, const app::Catalogue& catalogue, Dice& dice) {
    next.lights = dice.coin() ? nullptr : dice.of(catalogue.lights);
}

void editLook(app::StudyState& next, const app::Catalogue&, Dice& dice) {
    next.settings.look = dice.of(trace::kLooks).look;
    next.settings.shading = dice.coin() ? trace::Shading::headlight : trace::Shading::none;
}

void editNumber(app::StudyState& next, const app::Catalogue&, Dice& dice) {
    const app::Parameter& parameter = dice.of(app::parameters());
    const double value = dice.number(parameter.low, parameter.high);
    parameter.set(next.settings, parameter.isWhole ? std::floor(value) : value);
}

void editWindow(app::StudyState& next, const app::Catalogue&, Dice& dice) {
    const std::size_t look = dice.below(trace::kLooks.size());
    if (!trace::isProjection(trace::kLooks[look].look)) return;
    next.windows.at(look).reset();
    if (dice.below(4) > 0) next.windows.at(look) = aWindow(dice);
}

void editCamera(app::StudyState& next, const app::Catalogue&, Dice& dice) {
    Camera camera;
    camera.positionMm = dice.pointMm() + glm::dvec3(0.0, -900.0, 0.0);
    camera.targetMm = dice.pointMm();
    camera.verticalFovDeg = dice.number(10, 90);
    if (dice.coin()) camera.parallelHeightMm = dice.number(1, 900);
    next.camera = camera;
}

void editMarks(app::StudyState& next, const app::Catalogue&, Dice&) {
    next.showsMarks = !next.showsMarks;
}

void editBackground(app::StudyState& next, const app::Catalogue&, Dice& dice) {
    next.background.reset();
    if (dice.below(4) > 0)
        next.background = app::BackgroundColour(dice.below(256), dice.below(256), dice.below(256));
}

void editPanes(app::StudyState& next, const app::Catalogue&, Dice& dice) {
    next.layout = dice.of(app::kLayouts);
}

void editSlices(app::StudyState& next, const app::Catalogue&, Dice& dice) {
    app::SliceState& slices = next.slices;
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

void editMeasurements(app::StudyState& next, const app::Catalogue&, Dice& dice) {
    if (!next.measurements.empty() && dice.below(3) == 0) {
        next.measurements.erase(next.measurements.begin() +
                                std::ptrdiff_t(dice.below(next.measurements.size())));
    } else {
        next.measurements.push_back(aMeasurement(dice));
    }
}

void editSegments(app::StudyState& next, const app::Catalogue&, Dice& dice) {
    const std::string digest(64, "0a"[dice.below(2)]);
    app::SegmentationChoice choice = app::choiceOf(next.segmentations, digest);
    choice.isShown = dice.coin();
    app::choose(next.segmentations, choice);
    app::SegmentChoice segment = app::choiceOf(choice, std::uint16_t(1 + dice.below(5)));
    segment.isVisible = dice.coin();
    segment.opacity = dice.number(0, 1);
    segment.in3d = dice.of(app::kIn3d);
    if (dice.coin()) segment.rgb = {std::uint8_t(dice.below(256)), 7, 255};
    app::choose(next.segmentations, digest, segment);
}

void editBeside(app::StudyState& next, const app::Catalogue&, Dice& dice) {
    next.beside.reset();
    if (dice.below(4) == 0) return;
    app::BesideState beside;
    beside.seriesDigest = std::string(64, 'b');
    if (dice.coin()) beside.volume = std::size_t(dice.number(0, 20));
    beside.link = dice.of(app::kBesideLinks);
    beside.view = dice.of(app::kBesideViews);
    if (beside.link != app::BesideLink::sameFrame) {
        const double turn = dice.number(-0.5, 0.5);
        beside.secondFromStudy[0] = {std::cos(turn), std::sin(turn), 0.0, 0.0};
        beside.secondFromStudy[1] = {-std::sin(turn), std::cos(turn), 0.0, 0.0};
        beside.secondFromStudy[3] = glm::dvec4(dice.pointMm(), 1.0);
    }
    if (beside.link == app::BesideLink::registered) beside.boundMm = dice.number(0, 5);
    if (dice.coin()) beside.window = aWindow(dice);
    beside.opacity = dice.number(0, 1);
    next.beside = beside;
}

void editTable(app::StudyState& next, const app::Catalogue&, Dice&) {
    next.leavesTableOut = !next.leavesTableOut;
}

using Edit = void (*)(app::StudyState&, const app::Catalogue&, Dice&);
constexpr std::array<Edit, 17> kEdits{
    editPreset,   editClip,         editLights, editLook,       editNumber,    editWindow,
    editCamera,   editMarks,        editPanes,  editSlices,     editTable,     editBeside,
    editSegments, editMeasurements, editCuts,   editNamedClips, editBackground};

class EditsTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        auto catalogue = app::builtInCatalogue();
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
        const app::StudyState before = session_->state();
        session_->change(QStringLiteral("Edit"), [&](app::StudyState& next) {
            kEdits[dice.below(kEdits.size())](next, session_->catalogue(), dice);
        });
        return !(session_->state() == before);
    }

    std::optional<ViewerSession> session_;
};

TEST_F(EditsTest, EachIsUndoneAndDoneAgain) {
    Dice dice(1);
    std::vector<app::StudyState> states{session_->state()};
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
        const std::string text = app::toJson(session_->state());
        const auto read = app::studyStateFromJson(text, {});
        ASSERT_TRUE(read.ok()) << read.error().message << " " << read.error().hint << "\n" << text;
        const app::StudyState& state = session_->state();
        ASSERT_EQ(read->preset == nullptr, state.preset == nullptr);
        EXPECT_TRUE(!state.preset || app::isSame(*read->preset, *state.preset));
        ASSERT_TRUE(*read == state) << (read->clip == state.clip) << (read->settings == state.settings)
                                    << (read->windows == state.windows) << (read->camera == state.camera)
                                    << (read->slices == state.slices)
                                    << (read->measurements == state.measurements)
                                    << (read->segmentations == state.segmentations)
                                    << (read->beside == state.beside) << (read->cuts == state.cuts)
                                    << (read->namedClips == state.namedClips) << " " << text;
        const nlohmann::json json = nlohmann::json::parse(text);
        for (const auto& [key, value] : json.items()) keys.insert(key);
    }
    // A part of the state that no edit above changes would be tested by nothing.
    for (const char* ofTheStudy : {"series", "grid"}) keys.insert(ofTheStudy);
    for (const std::string& key : app::stateKeys()) EXPECT_TRUE(keys.contains(key)) << key;
}

}  // namespace
}  // namespace macula::viewer

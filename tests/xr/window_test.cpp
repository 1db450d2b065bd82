// The window's share of a headset: begun, mirrored, chosen from, ended, begun again. Without a display.
#include "viewer/headset/headset_show.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/phantom.h"
#include "scene/choice/catalogue.h"
#include "scene/drawing/drawing_of.h"
#include "viewer/offscreen.h"
#include "viewer/wait_until.h"
#include "xr/runtime/script.h"
#include "xr/wrist_panel.h"

namespace macula::viewer {
namespace {

class HeadsetWindowTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        setenv("XR_RUNTIME_JSON", MACULA_XR_MANIFEST, 1);
        auto catalogue = scene::builtInCatalogue();
        ASSERT_TRUE(catalogue.ok());
        catalogue_ = *std::move(catalogue);
        volume_ =
            std::make_shared<const Volume>(phantom::make({.size = {24, 20, 16}, .spacingMm = {12, 12, 18}}));
        show_.emplace(nullptr);
        QObject::connect(&*show_, &HeadsetShow::mirrored, &*show_, [this](const QImage& picture) {
            ++mirrored_;
            picture_ = picture;
        });
        QObject::connect(&*show_, &HeadsetShow::chosen, &*show_,
                         [this](const HeadsetSelection& choice) { chosen_ = choice; });
        QObject::connect(&*show_, &HeadsetShow::failed, &*show_,
                         [this](const Error& error) { error_ = error; });
        QObject::connect(&*show_, &HeadsetShow::ended, &*show_, [this](const QString& figures) {
            ++ended_;
            figures_ = figures;
        });
    }
    void TearDown() override {
        show_.reset();
        for (const std::string& violation : xr_script::record().violations) ADD_FAILURE() << violation;
        EXPECT_EQ(xr_script::record().instances, 0);
        OffscreenTest::TearDown();
    }

    HeadsetShowRequest request() const {
        scene::StudyState state;
        state.preset = scene::presetFor(catalogue_, *volume_);
        HeadsetShowRequest made;
        made.volume = volume_;
        made.drawing = scene::drawingOf(state, catalogue_, scene::SeriesWindows(), volume_, nullptr);
        made.presets = {state.preset, scene::findPreset(catalogue_, "ct-bone").ok()
                                          ? *scene::findPreset(catalogue_, "ct-bone")
                                          : catalogue_.presets.front()};
        return made;
    }
    // After a second and a half of the headset's time the next preset is pressed once.
    static std::optional<xr_script::Hand> hand(double seconds, int which) {
        using xr::WristPanel;
        const xr::Pose fist{{0.0, 1.35, -0.56}, glm::angleAxis(glm::radians(90.0), glm::dvec3(1, 0, 0))};
        xr_script::Hand made;
        made.pose = {fist.positionM, fist.orientation};
        if (which == 0) return made;
        const glm::dvec3 from(0.1, 1.4, -0.2);
        const glm::dvec3 to =
            WristPanel::poseOf(WristPanel::poseAt(fist), WristPanel::middleOf(xr::PanelButton::presetNext))
                .positionM;
        made.pose = {from, {1, 0, 0, 0}};
        made.aim = xr_script::Pose{from, glm::quatLookAt(glm::normalize(to - from), glm::dvec3(0, 1, 0))};
        made.trigger = seconds > 1.5 && seconds < 2.0 ? 1.0f : 0.0f;
        return made;
    }

    scene::Catalogue catalogue_;
    std::shared_ptr<const Volume> volume_;
    std::optional<HeadsetShow> show_;
    int mirrored_ = 0;
    int ended_ = 0;
    QImage picture_;
    QString figures_;
    std::optional<HeadsetSelection> chosen_;
    std::optional<Error> error_;
};

TEST_F(HeadsetWindowTest, IsMirroredChosenFromEndedAndBegunAgain) {
    xr_script::Script script;
    script.hand = hand;
    xr_script::follow(script);
    const HeadsetShowRequest asked = request();
    show_->start(asked);
    EXPECT_TRUE(show_->isRunning());
    ASSERT_TRUE(waitUntil([this] { return mirrored_ >= 1 || ended_ > 0; }));
    ASSERT_FALSE(error_) << error_->message;
    EXPECT_EQ(picture_.size(), QSize(64, 64));
    ASSERT_TRUE(waitUntil([this] { return chosen_.has_value() || ended_ > 0; }));
    ASSERT_TRUE(chosen_);
    EXPECT_NE(chosen_->transferFunction, asked.drawing.transferFunction);
    show_->start(asked);  // nothing happens while it is there
    show_->stop();
    ASSERT_TRUE(waitUntil([this] { return ended_ > 0; }));
    EXPECT_FALSE(error_);
    EXPECT_TRUE(figures_.contains(QStringLiteral("Scripted headset"))) << figures_.toStdString();
    EXPECT_EQ(xr_script::record().sessions, 0);
    EXPECT_FALSE(show_->isRunning());

    mirrored_ = 0;
    show_->start(asked);
    ASSERT_TRUE(waitUntil([this] { return mirrored_ >= 1 || ended_ > 1; }));
    show_->stop();
    ASSERT_TRUE(waitUntil([this] { return ended_ > 1; }));
    EXPECT_FALSE(error_);
}

TEST_F(HeadsetWindowTest, AHeadsetThatIsUnpluggedForAMomentIsFoundAgain) {
    QString noted;
    QObject::connect(&*show_, &HeadsetShow::noted, &*show_,
                     [&](const QString& sentence) { noted = sentence; });
    xr_script::follow({});
    show_->start(request());
    ASSERT_TRUE(waitUntil([this] { return mirrored_ >= 1 || ended_ > 0; }));
    xr_script::Script gone;
    gone.hasHeadset = false;
    gone.loseAt = "xrEndFrame";
    gone.answer = -17;  // XR_ERROR_SESSION_LOST
    xr_script::follow(gone);
    ASSERT_TRUE(waitUntil([&] { return noted.contains(QStringLiteral("begun again")) || ended_ > 0; }));
    ASSERT_EQ(ended_, 0) << "it may come back";
    xr_script::follow({});
    mirrored_ = 0;
    ASSERT_TRUE(waitUntil([this] { return mirrored_ >= 1 || ended_ > 0; }));
    EXPECT_FALSE(error_);
    // Nobody has to wait for one that does not come back.
    xr_script::follow(gone);
    noted.clear();
    ASSERT_TRUE(waitUntil([&] { return noted.contains(QStringLiteral("begun again")) || ended_ > 0; }));
    show_->stop();
    ASSERT_TRUE(waitUntil([this] { return ended_ > 0; }));
    EXPECT_FALSE(error_);
}

TEST_F(HeadsetWindowTest, WithoutAHeadsetASentenceIsSaidAndItCanBeTriedAgain) {
    xr_script::Script script;
    script.hasHeadset = false;
    xr_script::follow(script);
    show_->start(request());
    ASSERT_TRUE(waitUntil([this] { return ended_ > 0; }));
    ASSERT_TRUE(error_);
    EXPECT_EQ(error_->code, ErrorCode::deviceNotUsable);
    EXPECT_NE(error_->message.english().find("No headset is connected"), std::string::npos);
    EXPECT_FALSE(error_->hint.empty());
    error_.reset();
    setenv("XR_RUNTIME_JSON", "/nonexistent/runtime.json", 1);
    show_->start(request());
    ASSERT_TRUE(waitUntil([this] { return ended_ > 1; }));
    ASSERT_TRUE(error_);
    EXPECT_NE(error_->message.english().find("XR_RUNTIME_JSON"), std::string::npos);
    setenv("XR_RUNTIME_JSON", MACULA_XR_MANIFEST, 1);
    xr_script::follow({});
    error_.reset();
    show_->start(request());
    ASSERT_TRUE(waitUntil([this] { return mirrored_ >= 1 || ended_ > 2; }));
    EXPECT_FALSE(error_);
}

}  // namespace
}  // namespace macula::viewer

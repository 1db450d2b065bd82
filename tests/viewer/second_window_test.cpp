// The whole window with a second volume.
#include <QAction>
#include <stdexcept>

#include "study/found_by_hand.h"
#include "viewer/browser/study_browser.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/second/second_volume_loader.h"
#include "viewer/second/slice_pair.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

using slices::Orientation;

class SecondWindowTest : public WindowTest {
  protected:
    SecondWindowTest() { layout_ = scene::Layout::fourPanes; }
    QAction& action(const char* name) {
        auto* found = window_->findChild<QAction*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    static study::OpenedStudy named(const char* digest) {
        study::OpenedStudy study = smallStudy(Unit::hounsfield);
        study.seriesDigest = digest;
        return study;
    }
};

TEST_F(SecondWindowTest, ASecondVolumeHasTwoColumnsAFlipAndAnEnd) {
    EXPECT_FALSE(action("flip").isEnabled());
    window_->secondVolume().open(std::filesystem::path("/no/such/folder"));
    EXPECT_FALSE(window_->message().isEmpty()) << "there is no study that it could be beside";
    window_->showStudy(named("current"));
    window_->secondVolume().offer(named("second"));
    SlicePair& axial = window_->pair(Orientation::axial);
    EXPECT_TRUE(axial.showsBoth());
    EXPECT_EQ(window_->panes().shownLayout(), scene::Layout::axial) << "large enough to compare";
    EXPECT_TRUE(axial.second().isVisible());
    // It has one value only: the window says so, and it is linked by hand.
    ASSERT_TRUE(waitUntil([&] { return !window_->secondVolume().isWorking(); }));
    EXPECT_TRUE(window_->message().contains("same value everywhere")) << window_->message().toStdString();
    ASSERT_TRUE(waitUntil([&] { return axial.second().isUpToDate(); }));
    EXPECT_FALSE(axial.second().tags().isEmpty());

    action("flip").trigger();
    EXPECT_FALSE(axial.showsBoth());
    ASSERT_TRUE(waitUntil([&] { return axial.study().isUpToDate(); }));
    EXPECT_EQ(axial.study().tags(), axial.second().tags());
    action("flip").trigger();
    EXPECT_TRUE(axial.showsBoth());
    EXPECT_TRUE(window_->state().secondVolume);

    action("close-second").trigger();
    EXPECT_FALSE(axial.showsBoth());
    EXPECT_FALSE(window_->state().secondVolume);
    EXPECT_FALSE(action("flip").isEnabled());
    window_->secondVolume().offer(named("second"));
    window_->showStudy(named("third"));
    EXPECT_EQ(window_->secondVolume().second(), nullptr) << "it was beside another study";
    EXPECT_FALSE(axial.showsBoth());
}

// While another folder is opened, or after that failed, the list is not that of the study.
TEST_F(SecondWindowTest, ARowOfTheListIsOfTheFolderThatTheListShows) {
    window_->showStudy(named("current"));
    auto* browser = window_->findChild<StudyBrowser*>();
    ASSERT_NE(browser, nullptr);
    browser->setFound(study::test::twoPatients(), std::nullopt);
    Q_EMIT browser->secondAsked(0);
    EXPECT_TRUE(window_->secondVolume().isWorking());
    window_->secondVolume().cancel();
}

// Refused, cancelled, one of several, gone: what is said is true of each.
TEST_F(SecondWindowTest, ASecondVolumeThatIsNotOpenIsTold) {
    window_->showStudy(named("current"));
    scene::StudyState state = window_->state();
    state.secondVolume.emplace();
    state.secondVolume->seriesDigest = "second";
    window_->secondVolume().open(std::filesystem::path("/no/such/folder"));
    ASSERT_TRUE(window_->setState(state).ok());
    EXPECT_FALSE(window_->notes().contains("is not open")) << "it is on its way";
    window_->secondVolume().cancel();
    ASSERT_TRUE(waitUntil([&] { return !window_->secondVolume().isWorking(); }));
    EXPECT_EQ(window_->secondVolume().state(), nullptr);
    EXPECT_TRUE(window_->notes().contains("beside this study is not open")) << window_->notes().toStdString();
    EXPECT_FALSE(window_->notes().contains("folder")) << "nobody knows where it is";
}

}  // namespace
}  // namespace macula::viewer

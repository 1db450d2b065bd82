// Whose picture it is: at every moment what is on screen names that.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDropEvent>
#include <QMimeData>
#include <QTemporaryDir>
#include <QUrl>

#include "base/paths.h"
#include "viewer/covered_by.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

const study::Identity kDoe{.patientName = "DOE^JOHN",
                           .patientId = "4711",
                           .studyDate = "20200304",
                           .studyDescription = "Chest",
                           .series = Text("CT, series 3: Lung")};
const study::Identity kPhantom{.series = Text("Built-in phantom"), .isOfNobody = true};

class NamesTest : public WindowTest {
  protected:
    study::OpenedStudy ofDoe() const {
        study::OpenedStudy study = smallStudy(Unit::hounsfield);
        study.identity = kDoe;
        return study;
    }
    bool isNamed(const study::Identity& identity) { return WindowTest::isNamed(picture(), identity); }
    QString title() const { return window_->windowTitle(); }
};

TEST_F(NamesTest, StandOverThePictureAndInTheTitleUntilAKeyHidesThem) {
    EXPECT_EQ(title(), QStringLiteral("Macula"));
    window_->showStudy(ofDoe());
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(waitUntil([&] { return isNamed(kDoe); }));
    EXPECT_TRUE(title().startsWith(QStringLiteral("DOE, JOHN \u00b7 4711 \u00b7 2020-03-04, Chest")))
        << title().toStdString();
    auto* shown = window_->findChild<QAction*>(QStringLiteral("names"));
    ASSERT_TRUE(shown != nullptr && shown->isChecked());

    // At once, with no other picture.
    const int before = frames_;
    pressKey(Qt::Key_N);
    EXPECT_TRUE(waitUntil([&] { return !isNamed(kDoe); }));
    EXPECT_FALSE(shown->isChecked());
    EXPECT_EQ(title(), QStringLiteral("Macula"));
    shown->trigger();
    EXPECT_TRUE(waitUntil([&] { return isNamed(kDoe); }));
    EXPECT_TRUE(title().startsWith(QStringLiteral("DOE, JOHN")));
    EXPECT_EQ(frames_, before);

    // Another size of window, another width of the text.
    window_->resize(window_->size() + QSize(80, 40));
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(waitUntil([&] { return isNamed(kDoe); }));
}

TEST_F(NamesTest, GoWithThePicture) {
    window_->showStudy(ofDoe());
    ASSERT_TRUE(waitForConverged());
    ASSERT_TRUE(waitUntil([&] { return isNamed(kDoe); }));
    window_->showStudy(studyThatCannotBeShown());
    ASSERT_TRUE(waitUntil([&] { return !window_->message().isEmpty(); }));
    EXPECT_TRUE(waitUntil([&] { return !isNamed(kDoe); }));
    EXPECT_TRUE(title().startsWith(QStringLiteral("Second"))) << "that is what is open";
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(waitUntil([&] { return isNamed(kPhantom); }));
    EXPECT_TRUE(title().startsWith(QStringLiteral("Built-in phantom")));
}

TEST_F(NamesTest, AFailedOpenLeavesNoDoubtWhosePictureItIs) {
    window_->showStudy(ofDoe());
    ASSERT_TRUE(waitForConverged());
    window_->open("/no/such/folder");
    ASSERT_TRUE(waitUntil([&] { return !window_->message().isEmpty(); }));
    EXPECT_TRUE(window_->message().contains(QStringLiteral("still of the study that was open before")));
    EXPECT_FALSE(window_->message().contains(QStringLiteral("DOE")));
    EXPECT_TRUE(waitUntil([&] { return isNamed(kDoe); }));
    EXPECT_TRUE(title().startsWith(QStringLiteral("DOE, JOHN")));
}

TEST_F(NamesTest, LongNamesAreCutShortAndDirectionMarksLeftOut) {
    const QSize picture(320, 240);
    const auto painted = [&](std::vector<std::string> names) {
        return paintText({.names = std::move(names)}, picture, 1.0);
    };
    const std::string longName(300, 'W');
    EXPECT_TRUE(QRect(QPoint(0, 0), picture).contains(test::coveredBy(*painted({longName, "short"}))));
    // The end, which tells one number from the next, is there.
    EXPECT_NE(painted({longName + "1"})->rgba, painted({longName + "2"})->rgba);
    EXPECT_EQ(painted({"DOE,\u202e JO\u2066HN\n"})->rgba, painted({"DOE, JOHN"})->rgba);
    EXPECT_EQ(painted({}), nullptr);
    EXPECT_EQ(painted({"DOE"})->of.width, 0u) << "it stands over a picture of any size";
    EXPECT_EQ(paintText({.names = {"DOE"}}, QSize(4, 240), 1.0), nullptr);
}

// A box for each line would hide a forehead: letters and their rim take less than half of it.
TEST_F(NamesTest, ThePictureIsSeenBetweenTheLetters) {
    const auto text = paintText({.names = {"DOE, JOHN", "ID 4711"}}, QSize(640, 480), 1.0);
    const QRect all = test::coveredBy(*text);
    double covered = 0.0;
    for (const VkRect2D& box : text->boxes) covered += double(box.extent.width) * box.extent.height;
    EXPECT_GT(covered, 0.2 * all.width() * all.height());
    EXPECT_LT(covered, 0.75 * all.width() * all.height());
    EXPECT_LT(text->boxes.size(), 200u) << "each is copied when a picture is shown";
}

TEST_F(NamesTest, InALowPictureTheLastLinesGoAndNeverTheNameOrAWarning) {
    const LinesOver four{.names = {"DOE, JOHN", "ID 4711", "2020-03-04, Chest", "CT, series 3: Lung"}};
    LinesOver two = four;
    two.names.resize(2);
    LinesOver one = four;
    one.names.resize(1);
    const auto rgba = [](const LinesOver& lines, int high) {
        return paintText(lines, QSize(400, high), 1.0)->rgba;
    };
    EXPECT_NE(rgba(four, 480), rgba(two, 480));
    EXPECT_EQ(rgba(four, 170), rgba(two, 170));
    EXPECT_EQ(rgba(four, 60), rgba(one, 60));
    LinesOver noted = one;
    noted.notes = {"With PT of another day"};
    EXPECT_NE(rgba(noted, 60), rgba(one, 60));
}

class ThreeStudiesTest : public NamesTest {
  protected:
    ThreeStudiesTest() {
        refusesRaw_ = false;
        usesModel_ = true;
    }
};

// Three studies dropped on the window one after the other, with one that cannot be opened in between, and a
// hand that drags all the while.
TEST_F(ThreeStudiesTest, EveryPictureOfThreeStudiesNamesItsOwn) {
    const std::filesystem::path data = macula::test::sharedFolder() / "data";
    if (!std::filesystem::exists(data)) GTEST_SKIP() << "shared data is not here";
    QTemporaryDir empty;
    std::vector<study::Identity> identities;
    const std::filesystem::path paths[] = {data / "mr_head_sag_hfs", empty.path().toStdString(),
                                           data / "odd/nonisotropic_perslice_slope",
                                           data / "odd/gantry_tilt_4slices"};
    for (const auto& path : paths) {
        Progress progress;
        const auto study = study::openStudy(path, progress);
        if (study.ok()) identities.push_back(study->identity);
    }
    ASSERT_EQ(identities.size(), 3u);
    identities.push_back(kPhantom);

    int pictures = 0;
    int seen = -1;  // whose picture was on screen last; they come in this order, and none comes back
    const auto look = [&] {
        const QImage now = picture();
        QSet<QRgb> colours;
        for (int x = 0; x < now.width(); ++x) colours.insert(now.pixel(x, now.height() / 2));
        if (colours.size() < 5) return;
        ++pictures;
        int named = -1;
        for (int i = 0; i < int(identities.size()); ++i) {
            // While a message takes some of the height, there is room for the first two lines only.
            if (WindowTest::isNamed(now, identities[std::size_t(i)], 2)) named = i;
        }
        ASSERT_NE(named, -1) << "a picture that names nobody";
        EXPECT_GE(named, seen);
        seen = named;
    };
    const auto drop = [&](const std::filesystem::path& path) {
        QMimeData what;
        what.setUrls({QUrl::fromLocalFile(QString::fromStdString(path.string()))});
        QDropEvent event({9, 9}, Qt::CopyAction, &what, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window_->viewport().window(), &event);
    };
    int wanted = -1;
    for (const auto& path : paths) {
        drop(path);
        int x = 100;
        sendMouse(QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton, Qt::LeftButton);
        ASSERT_TRUE(waitUntil([&] {
            sendMouse(QEvent::MouseMove, {x++ % 200 + 20.0, 100}, Qt::NoButton, Qt::LeftButton);
            look();
            return !window_->loading() || HasFatalFailure();
        }));
        sendMouse(QEvent::MouseButtonRelease, {100, 100}, Qt::LeftButton, Qt::NoButton);
        if (window_->message().isEmpty()) ++wanted;
        last_.reset();
        pressKey(Qt::Key_L);
        // The first has a model, the next two are left at their first pictures, the last comes to rest.
        const auto isFarEnough = [&](const live::FrameShown& frame) {
            if (frame.stage == live::Stage::converged) return true;
            if (&path == std::begin(paths)) return frame.model.steps > 0;
            return &path + 1 != std::end(paths);
        };
        ASSERT_TRUE(waitUntil([&] {
            look();
            return (last_ && isFarEnough(*last_)) || HasFatalFailure();
        }));
        const study::Identity& identity = identities[std::size_t(wanted)];
        EXPECT_TRUE(waitUntil([&] { return isNamed(identity); }));
        const QString named = QString::fromStdString(titleOf(identity).english()).simplified();
        EXPECT_TRUE(waitUntil([&] { return title().startsWith(named); }));
    }
    EXPECT_EQ(wanted, 2);
    EXPECT_GT(pictures, 10);
}

}  // namespace
}  // namespace macula::viewer

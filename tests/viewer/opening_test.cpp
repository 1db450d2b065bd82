// Ways to open a study, and what is said meanwhile.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QMessageBox>
#include <QMimeData>
#include <QUrl>
#include <algorithm>

#include "base/paths.h"
#include "hostile_studies.h"
#include "support.h"
#include "unpack/made_archive.h"
#include "unpack/unpacked_archive.h"
#include "viewer/browser/recent_menu.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

class OpeningTest : public WindowTest {
  protected:
    OpeningTest() { refusesRaw_ = false; }

    QComboBox* box(const char* accessibleName) {
        for (QComboBox* found : window_->findChildren<QComboBox*>()) {
            if (found->accessibleName() == QLatin1String(accessibleName)) return found;
        }
        return nullptr;
    }
    void choosePreset(const char* name) {
        QComboBox* presets = box("Preset");
        const int index = presets->findData(QString::fromLatin1(name), Qt::ToolTipRole);
        ASSERT_GE(index, 0) << name;
        presets->setCurrentIndex(index);
        Q_EMIT presets->activated(index);
    }
    static study::OpenedStudy ofUnit(Unit unit, const char* modality) {
        std::vector<std::uint16_t> values(512);
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::uint16_t(i);
        auto volume =
            Volume::create({.size = glm::ivec3(8), .unit = unit, .modality = modality}, std::move(values));
        return {.volume = std::make_shared<const Volume>(*std::move(volume)),
                .identity = {.series = Text::verbatim(modality), .isOfNobody = true}};
    }
    QImage pictureOf(const char* action) {
        window_->findChild<QAction*>(QString::fromLatin1(action))->trigger();
        EXPECT_TRUE(waitForConverged());
        return middle();
    }
};

TEST_F(OpeningTest, AStudyThatCannotBeOpenedAtTheStartLeavesNoUnfinishedWork) {
    window_->open("/no/such/folder");
    ASSERT_TRUE(waitUntil([&] { return !window_->message().isEmpty(); }));
    EXPECT_TRUE(waitUntil([&] { return window_->fidelity() == QStringLiteral("No study is open"); }))
        << window_->fidelity().toStdString();
    EXPECT_FALSE(window_->message().contains(QStringLiteral("open before")));
}

TEST_F(OpeningTest, ADialogEndsADrag) {
    window_->showStudy(smallStudy(Unit::hounsfield));
    ASSERT_TRUE(waitForConverged());
    sendMouse(QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton, Qt::LeftButton);
    sendMouse(QEvent::MouseMove, {130, 100}, Qt::NoButton, Qt::LeftButton);
    pressKey(Qt::Key_O, Qt::ControlModifier);
    auto* dialog = window_->findChild<QFileDialog*>();
    ASSERT_TRUE(dialog != nullptr);
    // The button went up over the dialog: nobody holds the picture any more.
    EXPECT_TRUE(waitForConverged());
    const double azimuth = window_->viewport().camera().azimuthDeg;
    sendMouse(QEvent::MouseMove, {60, 100}, Qt::NoButton, Qt::NoButton);
    EXPECT_EQ(window_->viewport().camera().azimuthDeg, azimuth);
    dialog->reject();
}

// Identifiers made anew for each slice: the window asks, and opens them as one series after a yes.
TEST_F(OpeningTest, ImagesThatMayBeOneSeriesAreAskedAbout) {
    const dicom::test::TemporaryFolder folder;
    const auto& studies = dicom::test::hostileStudies();
    std::ranges::find(studies, "series-uid-per-slice", &dicom::test::HostileStudy::name)
        ->write(folder.path());
    window_->open(folder.path());
    QMessageBox* box = nullptr;
    ASSERT_TRUE(waitUntil([&] { return (box = window_->findChild<QMessageBox*>()) != nullptr; }));
    EXPECT_TRUE(box->text().contains(QStringLiteral("one series?"))) << box->text().toStdString();
    EXPECT_EQ(frames_, 0);
    bool isShown = false;
    QObject::connect(&*window_, &MainWindow::studyShown, &*window_, [&] { isShown = true; });
    for (QAbstractButton* button : box->buttons()) {
        if (box->buttonRole(button) == QMessageBox::AcceptRole) button->click();
    }
    ASSERT_TRUE(waitUntil([&] { return isShown; }));
    EXPECT_TRUE(waitForConverged());
}

TEST_F(OpeningTest, AButtonThatWentUpElsewhereEndsADrag) {
    window_->showStudy(smallStudy(Unit::hounsfield));
    ASSERT_TRUE(waitForConverged());
    sendMouse(QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton, Qt::LeftButton);
    sendMouse(QEvent::MouseMove, {130, 100}, Qt::NoButton, Qt::LeftButton);
    const double azimuth = window_->viewport().camera().azimuthDeg;
    sendMouse(QEvent::MouseMove, {60, 100}, Qt::NoButton, Qt::NoButton);
    EXPECT_EQ(window_->viewport().camera().azimuthDeg, azimuth);
    EXPECT_TRUE(waitForConverged());
}

TEST_F(OpeningTest, TwoFoldersAtOnceAreAnsweredAndNothingIsEverMoved) {
    QMimeData two;
    two.setUrls({QUrl::fromLocalFile(QStringLiteral("/a")), QUrl::fromLocalFile(QStringLiteral("/b"))});
    for (QObject* target :
         {static_cast<QObject*>(&window_->viewport().window()), static_cast<QObject*>(&*window_)}) {
        QDragEnterEvent enter({5, 5}, Qt::CopyAction | Qt::MoveAction, &two, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(target, &enter);
        EXPECT_TRUE(enter.isAccepted());
        QDropEvent drop({5, 5}, Qt::CopyAction | Qt::MoveAction, &two, Qt::LeftButton, Qt::NoModifier);
        drop.setDropAction(Qt::MoveAction);
        QCoreApplication::sendEvent(target, &drop);
        EXPECT_TRUE(window_->message().contains(QStringLiteral("Only one")))
            << window_->message().toStdString();
        EXPECT_FALSE(window_->loading());
        EXPECT_EQ(drop.dropAction(), Qt::CopyAction);
        // Who offers nothing but to move it keeps it.
        QDragEnterEvent move({5, 5}, Qt::MoveAction, &two, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(target, &move);
        EXPECT_FALSE(move.isAccepted());
    }
}

// A ZIP file is dropped, and its study shown; the private copy goes with the study.
TEST_F(OpeningTest, ADroppedArchiveOpensLikeItsFolder) {
    const auto copies = [] {
        std::error_code none;
        return std::distance(std::filesystem::directory_iterator(unpack::unpackedFolder(), none),
                             std::filesystem::directory_iterator());
    };
    const dicom::test::TemporaryFolder folder;
    dicom::test::write(dicom::test::smallVolume(), folder / "study");
    const std::filesystem::path archive = folder / "study.zip";
    unpack::test::writeArchive(archive, unpack::test::Format::zip, folder / "study");
    int shown = 0;
    QObject::connect(&*window_, &MainWindow::studyShown, &*window_, [&] { ++shown; });
    QMimeData dropped;
    dropped.setUrls({QUrl::fromLocalFile(QString::fromStdString(archive.string()))});
    QDragEnterEvent enter({5, 5}, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&*window_, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop({5, 5}, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&*window_, &drop);
    ASSERT_TRUE(waitUntil([&] { return shown == 1; })) << window_->message().toStdString();
    EXPECT_TRUE(waitForConverged());
    EXPECT_EQ(copies(), 1);
    const auto* recent = window_->findChild<RecentMenu*>();
    ASSERT_NE(recent, nullptr);
    ASSERT_FALSE(recent->paths().empty());
    EXPECT_EQ(recent->paths().front(), archive);
    window_->open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return shown == 2; }));
    EXPECT_TRUE(waitUntil([&] { return copies() == 0; }));
}

TEST_F(OpeningTest, AFileThatOnlyPretendsToBeAnArchiveIsToldInASentence) {
    const dicom::test::TemporaryFolder folder;
    unpack::test::writeBytes(folder / "letter.zip", "Dear colleague");
    window_->open(folder / "letter.zip");
    ASSERT_TRUE(waitUntil([&] { return !window_->message().isEmpty(); }));
    EXPECT_TRUE(window_->message().contains(QStringLiteral("no archive that Macula can open")))
        << window_->message().toStdString();
}

TEST_F(OpeningTest, APresetForOtherValuesIsWarnedOfWhenItIsChosen) {
    window_->showStudy(ofUnit(Unit::hounsfield, "CT"));
    EXPECT_EQ(window_->notes(), QString());
    choosePreset("cinematic-bone");
    EXPECT_EQ(window_->notes(), QString());
    window_->showStudy(ofUnit(Unit::raw, "MR"));
    choosePreset("cinematic-bone");
    EXPECT_TRUE(window_->notes().contains(QStringLiteral("made for values in HU")))
        << window_->notes().toStdString();
    choosePreset("cinematic-mr");
    EXPECT_FALSE(window_->notes().contains(QStringLiteral("is made for")));
    // The right unit, and another modality.
    window_->showStudy(ofUnit(Unit::raw, "OT"));
    choosePreset("cinematic-mr");
    EXPECT_TRUE(window_->notes().contains(QStringLiteral("made for MR"))) << window_->notes().toStdString();
}

// What somebody chose in one study says nothing about the next one, nor about one that comes back.
TEST_F(OpeningTest, APresetThatWasChosenIsOfThatStudyAlone) {
    const auto presetNow = [&] { return window_->state().preset->name; };
    window_->showStudy(ofUnit(Unit::hounsfield, "CT"));
    const std::string automatic = presetNow();
    ASSERT_NE(automatic, "cinematic-soft-tissue");
    choosePreset("cinematic-soft-tissue");
    window_->findChild<QAction*>(QStringLiteral("look-mip"))->trigger();
    EXPECT_EQ(presetNow(), "cinematic-soft-tissue");
    window_->showStudy(smallStudy(Unit::hounsfield));
    EXPECT_EQ(presetNow(), automatic);
    EXPECT_EQ(window_->state().settings.look, trace::Look::cinematic);
    EXPECT_EQ(box("Preset")->currentData(Qt::ToolTipRole).toString().toStdString(), automatic);
}

TEST_F(OpeningTest, TheWindowOfAProjectionDoesNotDependOnHowThePresetWasChosen) {
    window_->showStudy(ofUnit(Unit::hounsfield, "CT"));
    pictureOf("look-mip");
    const QString found = window_->fidelity();
    pictureOf("look-cinematic");
    QComboBox* presets = box("Preset");
    Q_EMIT presets->activated(presets->currentIndex());  // the same once more
    pictureOf("look-mip");
    EXPECT_EQ(window_->fidelity(), found);
}

TEST_F(OpeningTest, APictureInWhichNothingCanBeSeenSaysWhyAndWhatWouldShowSomething) {
    // 0 to 511 HU.
    window_->showStudy(ofUnit(Unit::hounsfield, "CT"));
    const auto notes = [&](const char* text) { return window_->notes().contains(QString::fromUtf8(text)); };
    EXPECT_FALSE(notes("Nothing of this volume"));
    choosePreset("ct-lung");
    EXPECT_TRUE(notes("Nothing of this volume can be seen with the preset"))
        << window_->notes().toStdString();
    EXPECT_TRUE(notes("its values are 0 to 511 HU"));
    EXPECT_TRUE(notes("Presets that show something of it: "));
    ASSERT_TRUE(waitForConverged());
    // Projections show values; those above the window are all white.
    window_->findChild<QAction*>(QStringLiteral("look-mip"))->trigger();
    EXPECT_FALSE(notes("this volume"));
    choosePreset("ct-lung");
    EXPECT_TRUE(notes("All of this volume is white in the window")) << window_->notes().toStdString();
    pressKey(Qt::Key_R, Qt::ControlModifier);
    EXPECT_FALSE(notes("this volume"));
}

TEST_F(OpeningTest, TheRateIsThatOfPicturesInMotionAndGoesWithThem) {
    window_->showStudy(smallStudy(Unit::hounsfield));
    ASSERT_TRUE(waitForConverged());
    EXPECT_FALSE(window_->rate().contains(QStringLiteral("/s"))) << window_->rate().toStdString();
    sendMouse(QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton, Qt::LeftButton);
    int x = 100;
    ASSERT_TRUE(waitUntil([&] {
        sendMouse(QEvent::MouseMove, {double(++x % 200), 100}, Qt::NoButton, Qt::LeftButton);
        return window_->rate().contains(QStringLiteral("/s"));
    }));
    // The hand holds still.
    EXPECT_TRUE(waitUntil([&] { return !window_->rate().contains(QStringLiteral("/s")); }));
    EXPECT_TRUE(window_->rate().contains(QStringLiteral("\u00d7")));
    sendMouse(QEvent::MouseButtonRelease, {double(x % 200), 100}, Qt::LeftButton, Qt::NoButton);
}

TEST_F(OpeningTest, OfSeveralVolumesAnotherOneCanBeChosen) {
    const std::filesystem::path folder = macula::test::sharedFolder() / "data/odd/mixed_flat_folder";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "shared data is not here";
    window_->resize(1000, window_->height());  // else it is behind the » of the tool bar
    window_->open(folder);
    ASSERT_TRUE(waitForConverged());
    QComboBox* volumes = box("Volume");
    ASSERT_TRUE(volumes != nullptr);
    EXPECT_TRUE(waitUntil([&] { return volumes->isVisible(); }));
    ASSERT_EQ(volumes->count(), 2);
    const int first = volumes->currentIndex();
    EXPECT_TRUE(volumes->currentText().startsWith(QStringLiteral("%1 of 2: ").arg(first + 1)));
    const QString title = window_->windowTitle();
    // As a person does; until it is open, the list names what is on screen.
    volumes->setCurrentIndex(1 - first);
    Q_EMIT volumes->activated(1 - first);
    EXPECT_EQ(volumes->currentIndex(), first);
    ASSERT_TRUE(waitUntil([&] { return !window_->loading(); }));
    EXPECT_EQ(window_->message(), QString());
    EXPECT_EQ(volumes->currentIndex(), 1 - first);
    ASSERT_TRUE(waitForConverged());
    EXPECT_NE(window_->windowTitle(), title);
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    EXPECT_FALSE(volumes->isVisible());
}

}  // namespace
}  // namespace macula::viewer

// A window that is closed while a picture is being drawn to a file.
#include <gtest/gtest.h>

#include <QAction>
#include <QFile>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <filesystem>

#include "scene/drawing/drawing_of.h"
#include "scene/drawing/projection_windows.h"
#include "viewer/output/picture_dialog.h"
#include "viewer/output/pictures_controller.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

class QuitTest : public WindowTest {
  protected:
    QString file() const { return folder_.filePath(QStringLiteral("picture.png")); }
    // It is under way until the event loop is told that it is done.
    void drawPicture(const QString& file, int sidePx, const char* quality) {
        auto* exporter = window_->findChild<PictureExport*>();
        ASSERT_NE(exporter, nullptr);
        const StudyEditor& session = window_->session();
        exporter->start({.volume = session.study().volume,
                         .seriesDigest = session.study().seriesDigest,
                         .drawing = scene::drawingOf(session.state(), session.catalogue(), windows_,
                                                     session.study().volume, nullptr),
                         .camera = *window_->state().camera,
                         .sizePx = glm::ivec2(sidePx),
                         .effort = {.quality = quality},
                         .output = file.toStdString(),
                         .isOfNobody = true});
    }
    QMessageBox* question() { return window_->findChild<QMessageBox*>(QStringLiteral("quit-question")); }
    void closeWhileDrawing(const QString& file, int sidePx = 64, const char* quality = "draft") {
        window_->open(std::nullopt);
        ASSERT_TRUE(waitUntil([&] { return window_->hasStudy(); }));
        drawPicture(file, sidePx, quality);
        EXPECT_FALSE(window_->close());
        EXPECT_TRUE(window_->isVisible());
        ASSERT_NE(question(), nullptr);
        EXPECT_TRUE(question()->text().contains(QStringLiteral("picture is still being drawn")));
    }
    void answer(QMessageBox::ButtonRole role) {
        for (QAbstractButton* button : question()->buttons())
            if (question()->buttonRole(button) == role) return button->click();
        FAIL() << "there is no such button";
    }

    QTemporaryDir folder_;
    scene::SeriesWindows windows_;
};

TEST_F(QuitTest, FinishesThePictureFirstWhereThatIsChosen) {
    closeWhileDrawing(file());
    EXPECT_FALSE(window_->close()) << "one question is enough";
    EXPECT_EQ(window_->findChildren<QMessageBox*>().size(), 1);
    answer(QMessageBox::AcceptRole);
    EXPECT_TRUE(waitUntil([&] { return !window_->isVisible(); }));
    EXPECT_TRUE(QFile::exists(file()));
}

TEST_F(QuitTest, LeavesNoFileWhereThatIsChosen) {
    closeWhileDrawing(file(), 1024, "high");  // not done before it is given up
    answer(QMessageBox::DestructiveRole);
    EXPECT_TRUE(waitUntil([&] { return !window_->isVisible(); }));
    window_.reset();
    EXPECT_FALSE(QFile::exists(file()));
}

TEST_F(QuitTest, GoesOnWhereThatIsChosenAndThePictureIsDrawn) {
    closeWhileDrawing(file());
    answer(QMessageBox::RejectRole);
    EXPECT_TRUE(waitUntil([&] { return window_->message().contains(QStringLiteral("is written")); }));
    EXPECT_TRUE(window_->isVisible());
    EXPECT_TRUE(QFile::exists(file()));
    EXPECT_TRUE(window_->close()) << "nothing is under way any more";
}

// Else nobody would read why.
TEST_F(QuitTest, StaysOpenWhereThePictureCouldNotBeDrawn) {
    closeWhileDrawing(folder_.filePath(QStringLiteral("missing/picture.png")));
    answer(QMessageBox::AcceptRole);
    ASSERT_TRUE(waitUntil([&] { return !window_->message().isEmpty() && !window_->isWriting(); }));
    for (int i = 0; i < 10; ++i) QCoreApplication::processEvents();
    EXPECT_TRUE(window_->isVisible());
    EXPECT_FALSE(window_->message().contains(QStringLiteral("is written")))
        << window_->message().toStdString();
}

// Of slices alone no picture is saved without a word that it is another one.
TEST_F(QuitTest, APictureOf3dThatIsNotShownIsSaidToBeThat) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return window_->hasStudy(); }));
    for (const auto layout : {scene::Layout::fourPanes, scene::Layout::axial}) {
        window_->session().change(QStringLiteral("Panes"),
                                  [&](scene::StudyState& next) { next.layout = layout; });
        window_->findChild<QAction*>(QStringLiteral("save-picture"))->trigger();
        auto* dialog = window_->findChild<PictureDialog*>();
        ASSERT_NE(dialog, nullptr);
        const auto* hidden = dialog->findChild<QLabel*>(QStringLiteral("3d-is-hidden"));
        ASSERT_NE(hidden, nullptr);
        EXPECT_EQ(hidden->isVisible(), layout == scene::Layout::axial);
        EXPECT_GT(dialog->sizePx().width(), 100);
        EXPECT_GT(dialog->sizePx().height(), 100);
        dialog->reject();
        delete dialog;
    }
}

}  // namespace
}  // namespace macula::viewer

// A pane of slices under a real hand, on Qt's platform without a screen.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QImage>
#include <QPixmap>
#include <QTest>
#include <QThread>
#include <QWheelEvent>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "viewer/slice_volume.h"
#include "viewer/slices/slice_view.h"
#include "viewer/wait_until.h"

namespace macula::viewer {

class SliceViewTest : public testing::Test {
  protected:
    SliceViewTest() {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        application_.emplace(argc_, argv_);
        session_.emplace(scene::Catalogue{});
    }

    void showStudy(VolumeOptions options = test::sliceVolumeOptions()) {
        session_->show({.volume = test::sliceVolume(std::move(options))}, {});
    }
    std::unique_ptr<SliceView> pane(slices::Orientation orientation) {
        auto view = std::make_unique<SliceView>(*session_, orientation);
        view->setLines({});  // they would lie over what is looked at
        view->resize(400, 400);
        view->show();
        EXPECT_TRUE(!session_->hasStudy() || settled(*view));
        return view;
    }
    static bool settled(const SliceView& view) {
        return waitUntil([&] { return view.isUpToDate(); });
    }

    const scene::StudyState& state() const { return session_->state(); }
    glm::dvec3 crosshair() const { return state().slices.crosshairMm.value_or(glm::dvec3(0.0)); }

    static void move(QWidget& to, QPoint place, Qt::MouseButtons buttons) {
        QMouseEvent event(QEvent::MouseMove, place, to.mapToGlobal(place), Qt::NoButton, buttons,
                          Qt::NoModifier);
        QApplication::sendEvent(&to, &event);
    }
    static void drag(QWidget& in, Qt::MouseButton button, QPoint from, QPoint to) {
        QTest::mousePress(&in, button, {}, from);
        move(in, (from + to) / 2, button);
        move(in, to, button);
        QTest::mouseRelease(&in, button, {}, to);
    }
    static void click(QWidget& in, QPoint at) {
        QTest::mousePress(&in, Qt::LeftButton, {}, at);
        QTest::mouseRelease(&in, Qt::LeftButton, {}, at);
    }
    static void turnWheel(QWidget& over, int notches, Qt::KeyboardModifiers modifiers = {},
                          QPoint at = {200, 200}) {
        QWheelEvent event(at, over.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&over, &event);
    }
    static QPoint placeOf(const SliceView& view, const glm::dvec3& mm) {
        const glm::dvec2 px = view.shownFrame()->pictureFromWorld(mm) / view.devicePixelRatioF();
        return {int(std::floor(px.x)), int(std::floor(px.y))};
    }
    static QImage pictureOf(SliceView& view) {
        return view.grab().toImage().convertToFormat(QImage::Format_RGB32);
    }
    // Of what is plain white, as nothing is that is drawn over a slice.
    static glm::dvec2 middleOfWhite(const QImage& image) {
        glm::dvec2 sum(0.0);
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (image.pixel(x, y) == qRgb(255, 255, 255)) {
                    sum += glm::dvec2(x + 0.5, y + 0.5);
                    ++count;
                }
        EXPECT_GT(count, 100) << "the block is not there";
        return sum / double(std::max(count, 1));
    }

    int argc_ = 1;
    char name_[5] = "test";
    char* argv_[2] = {name_, nullptr};
    std::optional<QApplication> application_;
    std::optional<StudyEditor> session_;
};

}  // namespace macula::viewer

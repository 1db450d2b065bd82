// A study with two panes of slices, beside which a second volume is opened. On Qt's platform without a
// screen.
#pragma once

#include <gtest/gtest.h>

#include <QTest>
#include <QWheelEvent>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "viewer/offscreen.h"
#include "viewer/second/second_volume_loader.h"
#include "viewer/second/slice_pair.h"
#include "viewer/slice_volume.h"

namespace macula::viewer {

// Turned by a quarter about the patient's long axis, and moved: not to be mistaken for anything else.
inline const glm::dmat4 kMoved = affine({0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {40, -30, 100});

inline study::OpenedStudy studyOf(std::shared_ptr<const Volume> volume, std::string digest,
                                  std::string date) {
    study::OpenedStudy study;
    study.volume = std::move(volume);
    study.seriesDigest = std::move(digest);
    study.identity = {.patientName = "Doe^Jane",
                      .patientId = "17",
                      .birthDate = "19700101",
                      .sex = "F",
                      .studyDate = std::move(date),
                      .studyDescription = "Thorax",
                      .series = Text("CT, series 3: Miller")};
    return study;
}

class SecondVolumeTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        session_.emplace(scene::Catalogue{});
        secondVolume_.emplace(*session_);
        pair_.emplace(*session_, slices::Orientation::axial);
        QObject::connect(&*secondVolume_, &SecondVolumeLoader::secondChanged, &*secondVolume_, [this] {
            pair_->setSecond(secondVolume_->second());
            follow();
        });
        QObject::connect(&*session_, &StudyEditor::changed, &*secondVolume_, [this] { follow(); });
        QObject::connect(&*secondVolume_, &SecondVolumeLoader::failed, &*secondVolume_,
                         [this](const Error& e) { error_ = e; });
        QObject::connect(&*secondVolume_, &SecondVolumeLoader::askedAboutPatient, &*secondVolume_,
                         [this](const QStringList& differs) { asked_ = differs; });
        pair_->resize(800, 400);
        pair_->show();
        current_ = studyOf(test::sliceVolume(), "current", "20240301");
        session_->show(current_, {});
        ASSERT_TRUE(settled());
    }
    void TearDown() override {
        pair_.reset();
        secondVolume_.reset();
        session_.reset();
        OffscreenTest::TearDown();
    }
    // As the window does it.
    void follow() {
        const auto* state = secondVolume_->state();
        pair_->setBoth(state != nullptr && state->view == scene::SecondVolumePlace::beside);
    }

    // The same body, elsewhere in the scanner.
    static study::OpenedStudy prior() {
        VolumeOptions options = test::sliceVolumeOptions();
        options.worldFromVoxel = kMoved * options.worldFromVoxel;
        return studyOf(test::sliceVolume(std::move(options)), "prior", "20220301");
    }
    // With the right link, which takes a while to find by itself.
    void openLinked(study::OpenedStudy second = prior()) {
        secondVolume_->offer(second);
        secondVolume_->cancel();
        session_->change("Link", [](scene::StudyState& next) {
            next.secondVolume->link = scene::SecondVolumeLink::registered;
            next.secondVolume->secondFromStudy = kMoved;
            next.layout = scene::Layout::fourPanes;
            next.slices.crosshairMm = test::kBlockCentreMm;
        });
        ASSERT_TRUE(settled());
    }

    SliceView& study() { return pair_->study(); }
    SliceView& second() { return pair_->second(); }
    bool settled() {
        settle();  // sizes come with events
        return waitUntil(
            [&] { return study().isUpToDate() && (!pair_->showsBoth() || second().isUpToDate()); });
    }
    static QImage pictureOf(SliceView& view) {
        return view.grab().toImage().convertToFormat(QImage::Format_RGB32);
    }
    static QPoint placeOf(const SliceView& view, const glm::dvec3& mm) {
        const glm::dvec2 px = view.shownFrame()->pictureFromWorld(mm) / view.devicePixelRatioF();
        return {int(std::floor(px.x)), int(std::floor(px.y))};
    }
    // Beside the middle, where the cross-hair leaves the picture free.
    static QRgb colourAt(SliceView& view, const glm::dvec3& mm) {
        return pictureOf(view).pixel(placeOf(view, mm));
    }
    static QRgb colourOfBlock(SliceView& view) {
        return colourAt(view, test::kBlockCentreMm + glm::dvec3(1, 1, 0));
    }
    static QRgb colourOfWater(SliceView& view) { return colourAt(view, glm::dvec3(11, 6, 12)); }
    static void turnWheel(QWidget& over, int notches, Qt::KeyboardModifiers modifiers = {}) {
        const QPoint at(150, 200);
        QWheelEvent event(at, over.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&over, &event);
    }
    static void moveTo(QWidget& to, QPoint place) {
        QMouseEvent event(QEvent::MouseMove, place, to.mapToGlobal(place), Qt::NoButton, Qt::NoButton, {});
        QApplication::sendEvent(&to, &event);
    }
    const scene::StudyState& state() const { return session_->state(); }

    std::optional<StudyEditor> session_;
    std::optional<SecondVolumeLoader> secondVolume_;
    std::optional<SlicePair> pair_;
    study::OpenedStudy current_;
    std::optional<Error> error_;
    std::optional<QStringList> asked_;
};

}  // namespace macula::viewer

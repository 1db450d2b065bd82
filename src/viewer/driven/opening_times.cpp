#include "viewer/driven/opening_times.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <cmath>
#include <string>

#include "live/frame/times_report.h"
#include "viewer/slices/slice_view.h"

namespace macula::viewer {

OpeningTimes::OpeningTimes(MainWindow& window, QObject* parent) : QObject(parent) {
    connect(&window.viewport().window(), &VulkanWindow::exposed, this, [this] { note(windowMs_); });
    connect(&window, &MainWindow::studyShown, this, [this] { note(studyReadMs_); });
    for (const auto orientation :
         {slices::Orientation::axial, slices::Orientation::coronal, slices::Orientation::sagittal})
        connect(&window.slices(orientation), &SliceView::pictureShown, this, [this] { note(sliceMs_); });
    connect(&window, &MainWindow::frameShown, this, [this](const live::FrameShown& frame) {
        note(pictureMs_);
        if (frame.picture == live::OnScreen::model) noteModel(frame.model);
    });
    // At rest it is not on screen, but a hand would see it now.
    connect(&window.viewport(), &Viewport::rendered, this, [this](const live::RenderEvent& event) {
        const auto* spent = std::get_if<live::TimeSpent>(&event);
        if (spent != nullptr && modelMs_ < 0.0) spent_ = spent->stages;
        const auto* changed = std::get_if<live::ModelChanged>(&event);
        if (changed != nullptr && hybrid::isFitToBeShown(changed->model)) noteModel(changed->model);
    });
}

void OpeningTimes::noteModel(const hybrid::ModelNews& model) {
    if (modelMs_ >= 0.0) return;
    note(modelMs_);
    modelOrigin_ = QString::fromUtf8(nameOf(model.origin).data());
}

void OpeningTimes::note(double& ms) const {
    if (ms < 0.0 && clock_.isValid()) ms = double(clock_.nsecsElapsed()) / 1e6;
}

QJsonObject OpeningTimes::toJson() const {
    const std::string times = live::toJson(spent_).dump();
    return {{"windowMs", std::round(windowMs_)},
            {"studyReadMs", std::round(studyReadMs_)},
            {"sliceMs", std::round(sliceMs_)},
            {"pictureMs", std::round(pictureMs_)},
            {"modelMs", std::round(modelMs_)},
            {"modelOrigin", modelOrigin_},
            {"renderThread", QJsonDocument::fromJson(QByteArray::fromStdString(times)).array()}};
}

}  // namespace macula::viewer

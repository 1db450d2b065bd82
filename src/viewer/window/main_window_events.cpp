// What the window tells of what comes from the render thread.
#include <utility>
#include <variant>

#include "viewer/language/core_words.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/status/status_texts.h"
#include "viewer/window/main_window.h"
#include "viewer/window/study_texts.h"

namespace macula::viewer {

void MainWindow::showStudyTexts() {
    const StudyTexts texts = textsOf(study(), viewport_->namesShown());
    setWindowTitle(texts.title);
    volumeText_->setFullText(texts.voxels);
    description_->setFullText(texts.description, texts.whyThisOne);
    volumesInBar_->setVisible(texts.listsVolumes);
}

// What is told of the picture in 3D is told only while that is shown, and of no other study.
void MainWindow::tellOfPicture() {
    const bool isShown = panes_->isShown(Pane::volume);
    const live::FrameShown* frame = isShown ? viewport_->frameOnScreen() : nullptr;
    if (frame != nullptr) return tellOfFrame(*frame);
    rateEnds_.stop();
    badge_->hide();
    pictureText_->setFullText({});
    modelText_->setFullText({});
    fidelity_->setFullText(!study().volume  ? tr("No study is open")
                           : !isShown       ? withoutVolumeText(panes_->shownLayout())
                           : pictureFailed_ ? tr("No picture")
                                            : tr("The picture in 3D is being made…"));
}

void MainWindow::onRendered(const live::RenderEvent& event) {
    // What was prepared is there; or other words take the place of those.
    if (std::holds_alternative<live::FrameShown>(event) ||
        std::holds_alternative<live::RenderFailure>(event) ||
        std::holds_alternative<live::DeviceReady>(event) ||
        std::holds_alternative<live::DeviceRestarting>(event))
        prepares_.stop();
    if (const auto* frame = std::get_if<live::FrameShown>(&event)) {
        onFrame(*frame);
    } else if (const auto* ready = std::get_if<live::DeviceReady>(&event)) {
        deviceText_->setFullText(QString::fromStdString(ready->name));
        deviceText_->setToolTip(QString::fromStdString(ready->description));
        isFirstStart_ = ready->isFirstStart;
        if (!study().volume || !panes_->isShown(Pane::volume)) tellOfPicture();  // nothing else comes
    } else if (std::holds_alternative<live::DeviceRestarting>(event)) {
        badge_->hide();
        fidelity_->setFullText(tr("Starting the graphics device again…"));
        deviceNote_ =
            tr("The graphics device stopped responding and is started again; the picture is made "
               "anew. If this comes back, update the graphics driver.");
        deviceIsBack_ = false;
        showNotes();
    } else if (const auto* changed = std::get_if<live::ModelChanged>(&event)) {
        if (changed->study == viewport_->study()) onModel(changed->model);
    } else if (const auto* preparing = std::get_if<live::Preparing>(&event)) {
        preparing_ = inWindowsLanguage(preparing->what) + QStringLiteral("…");
        if (!prepares_.isActive()) prepares_.start();
    } else if (std::holds_alternative<live::PictureRemoved>(event)) {
        tellOfPicture();
    } else if (const auto* failure = std::get_if<live::RenderFailure>(&event)) {
        pictureFailed_ = true;
        if (!std::exchange(deviceIsBack_, true)) {
            deviceNote_.clear();  // the error says what became of it
            showNotes();
        }
        tellOfPicture();
        messages_->showError(failure->error);
        emit failed(failure->error);
    }
}

void MainWindow::onModel(const hybrid::ModelNews& model) {
    if (hybrid::isFitToBeShown(model)) isFirstStart_ = false;  // what it takes is compiled now
    if (panes_->isShown(Pane::volume))
        modelText_->setFullText(modelText(model, isFirstStart_), aboutModel(model, isFirstStart_));
}

void MainWindow::onFrame(const live::FrameShown& frame) {
    pictureFailed_ = false;
    QStringList about;
    for (const Message& message : frame.messages) about << inWindowsLanguage(message);
    // Only when it is news: who has dismissed it has read it.
    if (const QString note = about.join(QLatin1Char(' ')); note != pictureNote_) {
        pictureNote_ = note;
        showNotes();
    }
    if (!std::exchange(deviceIsBack_, true)) {
        deviceNote_ =
            tr("The graphics device stopped responding and was started again. If this comes back, "
               "update the graphics driver.");
        if (notes_->isVisible()) showNotes();  // else it was read and dismissed
    }
    tellOfPicture();
    emit frameShown(frame);
}

void MainWindow::tellOfFrame(const live::FrameShown& frame) {
    QString text = fidelityText(frame);
    if (frame.samplesLeftOut > 0) text += tr(", %n samples left out", nullptr, int(frame.samplesLeftOut));
    if (!frame.messages.empty())
        text += tr(", less than the full resolution");  // also when the note is dismissed
    fidelity_->setFullText(text);
    badge_->setFidelity(live::fidelityOf(frame));
    onModel(frame.model);
    QString pictureText = QStringLiteral("%1×%2").arg(frame.width).arg(frame.height);
    if (frame.framesPerSecond > 0.0 && frame.stage == live::Stage::moving) {
        pictureText += tr(", %1/s").arg(withLocalNumbers(QString::number(frame.framesPerSecond, 'f', 1)));
        rateEnds_.start();
    }
    pictureText_->setFullText(pictureText);
}

}  // namespace macula::viewer

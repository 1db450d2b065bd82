// What the window tells of what comes from the render thread.
#include <QStatusBar>
#include <utility>
#include <variant>

#include "viewer/language/core_words.h"
#include "viewer/main_window.h"
#include "viewer/slices/slice_texts.h"
#include "viewer/status_texts.h"

namespace macula::viewer {

void MainWindow::setStudyTexts(const app::OpenedStudy& study) {
    const glm::ivec3 size = study.volume->size();
    const glm::dvec3 spacing = study.volume->spacingMm();
    const auto mm = [](double length) { return withLocalNumbers(QString::number(length, 'f', 2)); };
    const QString text = QStringLiteral("%1 %2×%3×%4, %5×%6×%7 mm")
                             .arg(QString::fromStdString(study.volume->modality()))
                             .arg(size.x)
                             .arg(size.y)
                             .arg(size.z)
                             .arg(mm(spacing.x), mm(spacing.y), mm(spacing.z));
    volumeText_->setFullText(study.volume->provenance().isCalibrated ? text : notCalibrated(text));
    const QString why = inWindowsLanguage(study.whyThisSeries);
    // The description of a series may name a patient.
    if (options_.namesPatient) description_->setFullText(listInWindowsLanguage(study.description), why);
    description_->setStatusTip(why);
}

// Names what is on screen, no sooner and no later.
void MainWindow::setTitle(const QString& ofPicture) {
    QString title = ofPicture.simplified();
    if (!options_.namesPatient) title.clear();
    title.replace(QLatin1String("[*]"), QLatin1String("[*][*]"));  // Qt's mark for what is not saved
    setWindowTitle(title.isEmpty() ? QStringLiteral("Macula") : title + QStringLiteral(" \u2013 Macula"));
}

void MainWindow::clearStudyTexts() {
    rateEnds_.stop();
    volumeText_->setFullText({});
    description_->setFullText({});
    description_->setStatusTip({});
    pictureText_->setFullText({});
    modelText_->setFullText({});
}

void MainWindow::onRendered(const app::RenderEvent& event) {
    // What was prepared is there; or other words take the place of those.
    if (std::holds_alternative<app::FrameShown>(event) || std::holds_alternative<app::RenderFailure>(event) ||
        std::holds_alternative<app::DeviceReady>(event) ||
        std::holds_alternative<app::DeviceRestarting>(event))
        prepares_.stop();
    if (const auto* frame = std::get_if<app::FrameShown>(&event)) {
        onFrame(*frame);
    } else if (const auto* ready = std::get_if<app::DeviceReady>(&event)) {
        deviceText_->setFullText(QString::fromStdString(ready->name));
        deviceText_->setToolTip(QString::fromStdString(ready->description));
        if (!study().volume) fidelity_->setFullText(tr("No study is open"));  // nothing else comes
    } else if (std::holds_alternative<app::DeviceRestarting>(event)) {
        badge_->hide();
        fidelity_->setFullText(tr("Starting the graphics device again…"));
        deviceNote_ =
            tr("The graphics device stopped responding and is started again; the picture is made "
               "anew. If this comes back, update the graphics driver.");
        deviceIsBack_ = false;
        showNotes();
    } else if (const auto* changed = std::get_if<app::ModelChanged>(&event)) {
        if (changed->study == viewport_->study()) onModel(changed->model);
    } else if (const auto* preparing = std::get_if<app::Preparing>(&event)) {
        preparing_ = inWindowsLanguage(preparing->what) + QStringLiteral("…");
        if (!prepares_.isActive()) prepares_.start();
    } else if (std::holds_alternative<app::PictureRemoved>(event)) {
        badge_->hide();
        setTitle({});
    } else if (const auto* failure = std::get_if<app::RenderFailure>(&event)) {
        clearStudyTexts();
        setTitle({});
        if (!std::exchange(deviceIsBack_, true)) {
            deviceNote_.clear();  // the error says what became of it
            showNotes();
        }
        badge_->hide();
        fidelity_->setFullText(tr("No picture"));
        messages_->showError(failure->error);
        emit failed(failure->error);
    }
}

void MainWindow::onModel(const hybrid::ModelNews& model) {
    modelText_->setFullText(modelText(model), aboutModel(model));
}

void MainWindow::onFrame(const app::FrameShown& frame) {
    QString text = fidelityText(frame);
    if (frame.samplesLeftOut > 0) text += tr(", %n samples left out", nullptr, int(frame.samplesLeftOut));
    QStringList about;
    for (const Message& message : frame.messages) about << inWindowsLanguage(message);
    if (!about.isEmpty()) text += tr(", less than the full resolution");  // also when the note is dismissed
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
    fidelity_->setFullText(text);
    badge_->setFidelity(app::fidelityOf(frame));
    onModel(frame.model);
    QString pictureText = QStringLiteral("%1×%2").arg(frame.width).arg(frame.height);
    if (frame.framesPerSecond > 0.0 && frame.stage == app::Stage::moving) {
        pictureText += tr(", %1/s").arg(withLocalNumbers(QString::number(frame.framesPerSecond, 'f', 1)));
        rateEnds_.start();
    }
    pictureText_->setFullText(pictureText);
    setStudyTexts(study());
    setTitle(QString::fromStdString(titleOf(study().identity)));
    emit frameShown(frame);
}

}  // namespace macula::viewer

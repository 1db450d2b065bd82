// The end of the program: what is being written is finished first, unless a person says otherwise.
#include <QCloseEvent>
#include <QMessageBox>
#include <QTimer>

#include "viewer/output/model_export.h"
#include "viewer/output/movie_export.h"
#include "viewer/output/presentation_files.h"
#include "viewer/window/main_window.h"
#include "viewer/window/quit_question.h"

namespace macula::viewer {

// What of it goes wrong is to be read: the window stays.
void MainWindow::connectQuit() {
    const auto quitIfDone = [this] {
        if (quitsWhenDone_ && unfinishedWork().isEmpty()) QTimer::singleShot(0, this, &QWidget::close);
    };
    const auto stay = [this] { quitsWhenDone_ = false; };
    connect(export_, &PictureExport::written, this, quitIfDone);
    connect(movieExport_, &MovieExport::written, this, quitIfDone);
    connect(modelExport_, &ModelExport::written, this, quitIfDone);
    connect(presentations_, &PresentationFiles::saved, this, quitIfDone);
    connect(this, &MainWindow::failed, this, stay);
    for (const WorkBar* bar : {exporting_, filming_, savingModel_})
        connect(bar, &WorkBar::cancelClicked, this, stay);
}

QStringList MainWindow::unfinishedWork() const {
    QStringList unfinished;
    if (export_->running()) unfinished << tr("A picture is still being drawn.");
    if (movieExport_->running()) unfinished << tr("A movie is still being drawn.");
    if (modelExport_->running()) unfinished << tr("A model is still being written.");
    if (presentations_->saving()) unfinished << tr("A presentation state is still being written.");
    return unfinished;
}

void MainWindow::closeEvent(QCloseEvent* event) {
    const QStringList unfinished = unfinishedWork();
    if (unfinished.isEmpty()) return QMainWindow::closeEvent(event);
    event->ignore();
    if (auto* asked = findChild<QMessageBox*>(QStringLiteral("quit-question"))) return asked->raise();
    viewport_->window().endDrag();  // the dialog will see the button go up
    askToQuit(
        this, unfinished,
        [this] {
            quitsWhenDone_ = true;
            if (unfinishedWork().isEmpty()) close();  // it was done while the question stood
        },
        [this] {
            export_->cancel();
            movieExport_->cancel();
            modelExport_->cancel();
            presentations_->cancelSaving();
            close();
        });
}

}  // namespace macula::viewer

#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/output/quit_controller.h"

#include <QMainWindow>
#include <QMessageBox>
#include <QTimer>

#include "viewer/output/quit_question.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

// If a file fails, the window stays open, so that a person can read the error.
QuitController::QuitController(const WindowContext& context) : QObject(&context.window), context_(context) {
    connect(&context_.notifications, &Notifications::failed, this, &QuitController::stay);
}

void QuitController::quitIfDone() {
    if (quitsWhenDone_ && unfinished().isEmpty()) QTimer::singleShot(0, &context_.window, &QWidget::close);
}

QStringList QuitController::unfinished() const {
    QStringList sentences;
    for (const Writing& each : writers_)
        if (const QString sentence = each.unfinished(); !sentence.isEmpty()) sentences << sentence;
    return sentences;
}

bool QuitController::mayClose() {
    QMainWindow& window = context_.window;
    const QStringList sentences = unfinished();
    if (sentences.isEmpty()) return true;
    if (auto* asked = window.findChild<QMessageBox*>(QStringLiteral("quit-question"))) {
        asked->raise();
        return false;
    }
    context_.viewport.window().endDrag();  // the dialog gets the button's release
    askToQuit(
        &window, sentences,
        [this] {
            quitsWhenDone_ = true;
            if (unfinished().isEmpty()) context_.window.close();  // it was finished before the answer
        },
        [this] {
            for (const Writing& each : writers_) each.cancel();
            context_.window.close();
        });
    return false;
}

}  // namespace macula::viewer

#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/output/quit_controller.h"

#include <QCoreApplication>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <utility>

#include "viewer/status/notifications.h"

namespace macula::viewer {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(QuitQuestion)
};

// Asks, and returns at once. `unfinished`, `ifNow`: sentences. Calls `wait` to quit after the work, `quit` to
// quit now, and neither after Cancel.
void askToQuit(QWidget* parent, const QStringList& unfinished, const QString& ifNow,
               std::function<void()> wait, std::function<void()> quit) {
    auto* box = new QMessageBox(QMessageBox::Question, Words::tr("Quit?"), unfinished.join(QLatin1Char(' ')),
                                QMessageBox::Cancel, parent);
    box->setObjectName(QStringLiteral("quit-question"));
    box->setInformativeText(ifNow);
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* finish = box->addButton(Words::tr("&Finish, Then Quit"), QMessageBox::AcceptRole);
    QPushButton* now = box->addButton(Words::tr("&Quit Now"), QMessageBox::DestructiveRole);
    box->setDefaultButton(finish);
    box->setEscapeButton(QMessageBox::Cancel);
    QObject::connect(box, &QMessageBox::finished, box,
                     [box, finish, now, wait = std::move(wait), quit = std::move(quit)] {
                         if (box->clickedButton() == finish) wait();
                         if (box->clickedButton() == now) quit();
                     });
    box->open();  // exec() would run a second event loop
}

}  // namespace

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

QString QuitController::ifQuitNow() const {
    for (const Writing& each : writers_)
        if (!each.keepsRest && !each.unfinished().isEmpty())
            return Words::tr("If you quit now, no file of it is left.");
    return Words::tr(
        "If you quit now, only what is stored by then has arrived; the queue keeps what it has.");
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
        &window, sentences, ifQuitNow(),
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

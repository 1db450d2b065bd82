#include "viewer/archive/waiting_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMap>
#include <QPushButton>

#include "viewer/language/harmless_text.h"
#include "viewer/menus/controls.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

namespace {

int waitingOf(const study::OutboxEntry& entry) {
    if (entry.state != study::OutboxState::waiting) return 0;
    return int(entry.record.files.size() - entry.record.refused());
}

}  // namespace

int waitingCount(const std::vector<study::OutboxEntry>& entries) {
    int count = 0;
    for (const study::OutboxEntry& entry : entries) count += waitingOf(entry);
    return count;
}

WaitingBar::WaitingBar(QWidget* parent) : QWidget(parent), text_(new QLabel(this)) {
    setAutoFillBackground(true);
    makePlain(*text_, "waiting-text");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 4, 4);
    row->addWidget(text_, 1);
    const auto button = [&](const QString& title, const char* name, const QString& tip) {
        auto* made = new QPushButton(title, this);
        describe(*made, name, title, tip);
        row->addWidget(made);
        return made;
    };
    auto* send = button(tr("Send Now"), "waiting-send", tr("Send all that waits"));
    auto* show = button(tr("Show"), "waiting-show", tr("What waits, of whom, and why"));
    auto* later =
        button(tr("Later"), "waiting-later", tr("It stays in the queue: File, Waiting for Archives"));
    connect(send, &QPushButton::clicked, this, &WaitingBar::sendAsked);
    connect(show, &QPushButton::clicked, this, &WaitingBar::queueAsked);
    connect(later, &QPushButton::clicked, this, &QWidget::hide);
    hide();
}

void WaitingBar::offer(const std::vector<study::OutboxEntry>& entries) {
    QMap<QString, int> counts;
    for (const study::OutboxEntry& entry : entries) {
        if (const int waiting = waitingOf(entry); waiting > 0)
            counts[harmless(QString::fromStdString(entry.record.archive))] += waiting;
    }
    QStringList sentences;
    for (auto count = counts.begin(); count != counts.end(); ++count)
        sentences.append(tr("%n objects wait for %1.", nullptr, count.value()).arg(count.key()));
    text_->setText(sentences.join(QLatin1Char(' ')));
    recolour();
    setVisible(!sentences.isEmpty());
}

QString WaitingBar::text() const {
    return isVisible() ? text_->text() : QString();
}

void WaitingBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange) recolour();
    QWidget::changeEvent(event);
}

// The buttons keep their own colours.
void WaitingBar::recolour() {
    const ThemeColours& colours = themeColours();
    QPalette ground;
    ground.setColor(QPalette::Window, QColor(colours.note));
    setPalette(ground);
    QPalette words;
    words.setColor(QPalette::WindowText, QColor(colours.barText));
    text_->setPalette(words);
}

}  // namespace macula::viewer

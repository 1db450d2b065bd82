#include "viewer/status_widgets.h"

#include <QFontMetrics>
#include <QHBoxLayout>
#include <QToolButton>
#include <algorithm>

namespace macula::viewer {

namespace {

constexpr int kNarrowestLabelPx = 40;
constexpr int kProgressSteps = 1000;

}  // namespace

ElidingLabel::ElidingLabel(const QString& what, QWidget* parent) : QLabel(parent), what_(what) {
    setTextFormat(Qt::PlainText);
    setToolTip(what);
}

void ElidingLabel::setFullText(const QString& text, const QString& more) {
    if (text == full_ && more == more_) return;
    full_ = text;
    more_ = more;
    QString tip = full_.isEmpty() ? what_ : what_ + QStringLiteral(": ") + full_;
    if (!more_.isEmpty()) tip += QStringLiteral("\n") + more_;
    setToolTip(tip);
    elide();
    updateGeometry();
}

QSize ElidingLabel::sizeHint() const {
    const QSize hint = QLabel::sizeHint();
    return {std::max(kNarrowestLabelPx, fontMetrics().horizontalAdvance(full_) + 2), hint.height()};
}

QSize ElidingLabel::minimumSizeHint() const {
    return {kNarrowestLabelPx, QLabel::minimumSizeHint().height()};
}

void ElidingLabel::resizeEvent(QResizeEvent*) {
    elide();
}

void ElidingLabel::elide() {
    setText(fontMetrics().elidedText(full_, Qt::ElideRight, width()));
}

MessageBar::MessageBar(QWidget* parent) : QWidget(parent), text_(new QLabel(this)) {
    setAttribute(Qt::WA_StyledBackground);
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* dismiss = new QToolButton(this);
    dismiss->setText(QStringLiteral("✕"));
    dismiss->setAutoRaise(true);
    dismiss->setToolTip(tr("Dismiss this message"));
    dismiss->setAccessibleName(tr("Dismiss"));
    connect(dismiss, &QToolButton::clicked, this, &QWidget::hide);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 4, 4);
    row->addWidget(text_, 1);
    row->addWidget(dismiss, 0, Qt::AlignTop);
    hide();
}

void MessageBar::showError(const Error& error) {
    QString text = QString::fromStdString(error.message);
    if (!error.where.empty()) text += QStringLiteral(" (%1)").arg(QString::fromStdString(error.where));
    if (!error.hint.empty()) text += QStringLiteral(" ") + QString::fromStdString(error.hint);
    show(text, true);
}

void MessageBar::showNote(const QString& text) {
    show(text, false);
}

void MessageBar::show(const QString& text, bool isError) {
    text_->setText(text);
    // Readable on light and dark desktops alike: both colours are set.
    setStyleSheet(isError ? QStringLiteral("background: #7a1f1f; color: white;")
                          : QStringLiteral("background: #5c4a12; color: white;"));
    setVisible(true);
}

WorkBar::WorkBar(QWidget* parent)
    : QWidget(parent),
      stage_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(this)) {
    bar_->setMaximumHeight(fontMetrics().height() + 4);
    bar_->setMinimumWidth(120);
    cancel_->setText(tr("Cancel"));
    cancel_->setToolTip(tr("Stop; what is shown now stays"));
    connect(cancel_, &QPushButton::clicked, this, &WorkBar::cancelClicked);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(stage_);
    row->addWidget(bar_, 1);
    row->addWidget(cancel_);
    hide();
}

void WorkBar::begin(const QString& stage) {
    stage_->setText(stage);
    bar_->setRange(0, 0);  // busy: nobody knows yet how much there is
    setVisible(true);
}

void WorkBar::setProgress(const QString& stage, double fraction) {
    stage_->setText(stage);
    bar_->setRange(0, kProgressSteps);
    bar_->setValue(int(std::clamp(fraction, 0.0, 1.0) * kProgressSteps));
}

}  // namespace macula::viewer

#include "viewer/status_widgets.h"

#include <QFontMetrics>
#include <QHBoxLayout>
#include <QToolButton>
#include <algorithm>

namespace macula::viewer {

namespace {

constexpr int kNarrowestLabelPx = 40;
constexpr int kBetweenPx = 8;       // at most, in any style
constexpr double kMostOfRow = 0.6;  // for the label that is kept longest
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
    const int wanted = isKeptLongest_ ? std::min(sizeHint().width(), roomPx()) : 0;
    return {std::max(kNarrowestLabelPx, wanted), QLabel::minimumSizeHint().height()};
}

void ElidingLabel::keepLongest() {
    isKeptLongest_ = true;
    updateGeometry();
}

// Never all that its parent has: that could then not be made narrower any more.
int ElidingLabel::roomPx() const {
    const QWidget* row = parentWidget();
    if (row == nullptr) return 0;
    int left = row->width();
    for (const QWidget* other : row->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
        if (other != this && other->isVisible()) left -= other->minimumSizeHint().width() + kBetweenPx;
    }
    return std::min(left, int(kMostOfRow * row->width()));
}

void ElidingLabel::resizeEvent(QResizeEvent*) {
    elide();
    if (isKeptLongest_) updateGeometry();
}

void ElidingLabel::elide() {
    setText(fontMetrics().elidedText(full_, Qt::ElideRight, width()));
}

FidelityBadge::FidelityBadge(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    hide();
}

void FidelityBadge::setFidelity(const app::Fidelity& fidelity) {
    setText(fidelity.isFinal ? tr("Final") : tr("Preliminary"));
    setStyleSheet(QStringLiteral("border: 1px solid %1; border-radius: 3px; padding: 0 4px")
                      .arg(fidelity.isFinal ? QStringLiteral("#4a9a5c") : QStringLiteral("#c08a2d")));
    QStringList because;
    for (const std::string& reason : fidelity.because) because << QString::fromStdString(reason);
    const QString reasons = because.join(QStringLiteral(", "));
    const QString is = fidelity.isFinal ? tr("Nothing will change any more") : tr("The picture gets better");
    setToolTip(reasons.isEmpty() ? is : QStringLiteral("%1: %2").arg(is, reasons));
    show();
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

#include "viewer/status/status_widgets.h"

#include <QEvent>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>
#include <algorithm>

#include "viewer/language/window_language.h"
#include "viewer/theme/theme.h"

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

// Never the parent's whole width: the parent could then not be made narrower any more.
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
    setContentsMargins(5, 1, 5, 1);
    hide();
}

void FidelityBadge::setFidelity(const live::Fidelity& fidelity) {
    isFinal_ = fidelity.isFinal;
    setText(isFinal_ ? tr("Final") : tr("Preliminary"));
    update();  // the text may be the same
    const QString reasons = inWindowsLanguage(fidelity.because).join(QStringLiteral(", "));
    const QString is = isFinal_ ? tr("Nothing will change any more") : tr("The picture gets better");
    setToolTip(reasons.isEmpty() ? is : QStringLiteral("%1: %2").arg(is, reasons));
    show();
}

void FidelityBadge::paintEvent(QPaintEvent* event) {
    const ThemeColours& colours = themeColours();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QColor(isFinal_ ? colours.finalBadge : colours.preliminaryBadge));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
    painter.end();
    QLabel::paintEvent(event);
}

MessageBar::MessageBar(QWidget* parent) : QWidget(parent), text_(new QLabel(this)) {
    setAutoFillBackground(true);
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
    QString text = inWindowsLanguage(error.message);
    if (!error.where.empty()) text += QStringLiteral(" (%1)").arg(QString::fromStdString(error.where));
    if (!error.hint.empty()) text += QStringLiteral(" ") + inWindowsLanguage(error.hint);
    show(text, true);
}

void MessageBar::showNote(const QString& text) {
    show(text, false);
}

void MessageBar::show(const QString& text, bool isError) {
    text_->setText(text);
    isError_ = isError;
    recolour();
    setVisible(true);
}

void MessageBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange) recolour();
    QWidget::changeEvent(event);
}

void MessageBar::recolour() {
    const ThemeColours& colours = themeColours();
    QPalette palette;
    palette.setColor(QPalette::Window, QColor(isError_ ? colours.error : colours.note));
    for (const QPalette::ColorRole text : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(text, QColor(colours.barText));
    setPalette(palette);
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
    bar_->setRange(0, 0);  // busy, until the amount of work is known
    setVisible(true);
}

void WorkBar::setProgress(const QString& stage, double fraction) {
    stage_->setText(stage);
    bar_->setRange(0, kProgressSteps);
    bar_->setValue(int(std::clamp(fraction, 0.0, 1.0) * kProgressSteps));
}

}  // namespace macula::viewer

#include "viewer/archive/series_strip.h"

#include <QEvent>
#include <QListWidget>
#include <QScrollBar>
#include <QVBoxLayout>
#include <utility>

#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr int kLines = 3;
constexpr int kPaddingPx = 8;
constexpr int kItemWidthPx = 104;

// An archive may send anything, and a tip shows markup.
QString toolTipOf(const QString& text) {
    return text.toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br>"));
}

}  // namespace

SeriesStrip::SeriesStrip(QWidget* parent) : QWidget(parent), list_(new QListWidget(this)) {
    describe(*list_, "archive-series", tr("Series of the selected study"),
             tr("What the archive has of the selected study, before it is fetched"));
    list_->setViewMode(QListView::IconMode);
    list_->setFlow(QListView::LeftToRight);
    list_->setWrapping(false);
    list_->setMovement(QListView::Static);
    list_->setWordWrap(true);
    list_->setTextElideMode(Qt::ElideRight);
    list_->setIconSize(QSize(kSeriesPicturePx, kSeriesPicturePx));
    list_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setGridSize(itemSize());
    list_->setFixedHeight(itemSize().height() + list_->horizontalScrollBar()->sizeHint().height() +
                          kPaddingPx);
    list_->viewport()->installEventFilter(this);
    connect(list_->horizontalScrollBar(), &QScrollBar::valueChanged, this, &SeriesStrip::viewChanged);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(list_);
    hide();
}

void SeriesStrip::setSeries(std::vector<net::FoundSeries> series) {
    series_ = std::move(series);
    list_->clear();
    for (const net::FoundSeries& each : series_) {
        auto* item = new QListWidgetItem(textOf(each), list_);
        item->setToolTip(toolTipOf(textOf(each)));
        item->setSizeHint(itemSize());
        item->setTextAlignment(Qt::AlignHCenter | Qt::AlignTop);
    }
    setVisible(!series_.empty());
}

// The same with a picture and without one: they come one by one.
QSize SeriesStrip::itemSize() const {
    return {kItemWidthPx, kSeriesPicturePx + kLines * fontMetrics().lineSpacing() + kPaddingPx};
}

void SeriesStrip::setPicture(std::size_t series, const QImage& picture) {
    QListWidgetItem* item = list_->item(int(series));
    if (item == nullptr || picture.isNull()) return;
    item->setIcon(QIcon(QPixmap::fromImage(picture)));
}

void SeriesStrip::showNames(bool shown) {
    namesShown_ = shown;
    for (std::size_t i = 0; i < series_.size(); ++i) {
        const QString text = textOf(series_[i]);
        list_->item(int(i))->setText(text);
        list_->item(int(i))->setToolTip(toolTipOf(text));
    }
}

QString SeriesStrip::textOf(const net::FoundSeries& series) const {
    QString text = QString::fromStdString(series.modality);
    if (series.instanceCount)
        text += QStringLiteral(", ") + tr("%n images", nullptr, int(*series.instanceCount));
    const QString description = QString::fromStdString(series.description).simplified();
    if (namesShown_ && !description.isEmpty()) text += QLatin1Char('\n') + description;
    return text;
}

std::vector<std::size_t> SeriesStrip::inView() const {
    std::vector<std::size_t> seen;
    if (!list_->isVisible()) return seen;
    const QRect view = list_->viewport()->rect();
    for (int i = 0; i < list_->count(); ++i)
        if (list_->visualItemRect(list_->item(i)).intersects(view)) seen.push_back(std::size_t(i));
    return seen;
}

bool SeriesStrip::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show) Q_EMIT viewChanged();
    return QWidget::eventFilter(watched, event);
}

}  // namespace macula::viewer

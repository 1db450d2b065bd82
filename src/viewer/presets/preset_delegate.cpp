#include "viewer/presets/preset_delegate.h"

#include <QAbstractItemView>
#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <numbers>

#include "pictures/preset_thumbnail.h"
#include "viewer/presets/preset_list_model.h"

namespace macula::viewer {

namespace {

constexpr int kMarginPx = 5;
constexpr int kStarPx = 14;
constexpr int kTitleLines = 2;  // enough for the titles of the built-in presets

QPainterPath star(const QPointF& centre, double radius) {
    QPainterPath path;
    for (int i = 0; i < 10; ++i) {
        const double angle = std::numbers::pi * (i / 5.0 - 0.5);
        const double r = i % 2 == 0 ? radius : 0.45 * radius;
        const QPointF corner = centre + r * QPointF(std::cos(angle), std::sin(angle));
        i == 0 ? path.moveTo(corner) : path.lineTo(corner);
    }
    path.closeSubpath();
    return path;
}

// Breaks the text between words into at most kTitleLines lines of `width`; the rest ends in an ellipsis.
QStringList wrapped(const QString& text, const QFontMetrics& metrics, int width) {
    QStringList lines;
    QString rest = text.simplified();
    while (lines.size() + 1 < kTitleLines && metrics.horizontalAdvance(rest) > width) {
        qsizetype end = rest.lastIndexOf(QLatin1Char(' '));
        while (end > 0 && metrics.horizontalAdvance(rest.left(end)) > width)
            end = rest.lastIndexOf(QLatin1Char(' '), end - 1);
        if (end <= 0) break;  // one long word
        lines << rest.left(end);
        rest = rest.mid(end + 1);
    }
    return lines << metrics.elidedText(rest, Qt::ElideMiddle, width);
}

void paintHeading(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) {
    QFont font = option.font;
    font.setBold(true);
    painter.setFont(font);
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    const QPalette& palette = option.palette;
    if (isSelected) painter.fillRect(option.rect, palette.highlight());
    QStyleOption arrow;
    const int side = option.fontMetrics.height() * 2 / 3;
    arrow.rect = QRect(option.rect.left() + kMarginPx, option.rect.center().y() - side / 2, side, side);
    arrow.palette = palette;
    arrow.state = QStyle::State_Enabled;
    const QStyle* style = option.widget->style();
    style->drawPrimitive(index.data(PresetListModel::isExpandedRole).toBool()
                             ? QStyle::PE_IndicatorArrowDown
                             : QStyle::PE_IndicatorArrowRight,
                         &arrow, &painter, option.widget);
    painter.setPen(palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text));
    painter.drawText(option.rect.adjusted(2 * kMarginPx + side, 0, -kMarginPx, 0),
                     Qt::AlignVCenter | Qt::AlignLeft, index.data().toString());
}

void paintPreset(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) {
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    const QPalette& palette = option.palette;
    if (isSelected) painter.fillRect(option.rect, palette.highlight());
    const QRect cell = option.rect.adjusted(kMarginPx, kMarginPx, -kMarginPx, -kMarginPx);
    const QRect square(cell.left(), cell.top(), pictures::kPresetThumbnailPx, pictures::kPresetThumbnailPx);
    painter.fillRect(square, Qt::black);
    const auto picture = index.data(Qt::DecorationRole).value<QImage>();
    if (!picture.isNull()) painter.drawImage(square, picture);
    if (index.data(PresetListModel::isShownRole).toBool()) {
        painter.setPen(QPen(palette.color(QPalette::Text), 2.0));
        painter.drawRect(square.adjusted(0, 0, -1, -1));
    }
    if (index.data(PresetListModel::isFavouriteRole).toBool()) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(Qt::black, 1.0));
        painter.setBrush(palette.text());
        painter.drawPath(
            star(QPointF(square.right() - kStarPx * 0.7, square.top() + kStarPx * 0.7), kStarPx / 2.0));
    }
    const QFontMetrics& metrics = option.fontMetrics;
    const auto line = [&](int number, const QString& text, QPalette::ColorRole role) {
        const QRect place(cell.left(), square.bottom() + 3 + number * metrics.lineSpacing(), cell.width(),
                          metrics.lineSpacing());
        painter.setPen(palette.color(isSelected ? QPalette::HighlightedText : role));
        painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, text);
    };
    int number = 0;
    for (const QString& text : wrapped(index.data().toString(), metrics, cell.width()))
        line(number++, text, QPalette::Text);
    line(number,
         metrics.elidedText(index.data(PresetListModel::aboutRole).toString(), Qt::ElideRight, cell.width()),
         QPalette::PlaceholderText);
}

}  // namespace

PresetDelegate::PresetDelegate(QObject* parent) : QStyledItemDelegate(parent) {}

void PresetDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
    painter->save();
    painter->setFont(option.font);
    if (index.data(PresetListModel::isHeadingRole).toBool()) {
        paintHeading(*painter, option, index);
    } else {
        paintPreset(*painter, option, index);
    }
    painter->restore();
    if (!option.state.testFlag(QStyle::State_HasFocus)) return;
    QStyleOptionFocusRect focus;
    focus.QStyleOption::operator=(option);
    focus.rect = option.rect;
    option.widget->style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, painter, option.widget);
}

QSize PresetDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const QFontMetrics& metrics = option.fontMetrics;
    if (index.data(PresetListModel::isHeadingRole).toBool()) {
        const auto* view = qobject_cast<const QAbstractItemView*>(option.widget);
        const int width = view ? view->viewport()->width() - 1 : 200;
        return {width, metrics.lineSpacing() + 2 * kMarginPx};
    }
    return {pictures::kPresetThumbnailPx + 2 * kMarginPx,
            pictures::kPresetThumbnailPx + 3 + (kTitleLines + 1) * metrics.lineSpacing() + 2 * kMarginPx};
}

}  // namespace macula::viewer

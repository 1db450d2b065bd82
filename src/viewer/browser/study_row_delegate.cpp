#include "viewer/browser/study_row_delegate.h"

#include <QApplication>
#include <QFontMetrics>
#include <QImage>
#include <QPainter>
#include <QStyle>
#include <QTextLayout>
#include <algorithm>

#include "viewer/browser/study_tree_model.h"

namespace macula::viewer {

namespace {

constexpr int kPicturePx = 96;  // logical, as all here
constexpr int kMarginPx = 4;
constexpr int kLeastTextPx = 80;

// In a narrow list the text matters more than the picture.
bool showsPicture(const QModelIndex& index, int widthPx) {
    return index.data(StudyTreeModel::hasPictureRole).toBool() &&
           widthPx >= kPicturePx + 2 * kMarginPx + kLeastTextPx;
}

// How many characters fit into a line, up to a space.
qsizetype firstLineOf(const QString& text, const QFont& font, int widthPx) {
    QTextLayout layout(text, font);
    layout.beginLayout();
    QTextLine line = layout.createLine();
    line.setLineWidth(std::max(widthPx, 1));
    layout.endLayout();
    return line.textLength();
}

// Never mirrors the picture, even where text runs from right to left.
void paintPicture(QPainter* painter, const QRect& box, const QImage& picture, const QPalette& palette) {
    if (picture.isNull()) {
        painter->setPen(palette.color(QPalette::Mid));
        painter->drawRect(box.adjusted(0, 0, -1, -1));
        return;
    }
    const QSizeF size = QSizeF(picture.size()).scaled(QSizeF(box.size()), Qt::KeepAspectRatio);
    QRectF target(QPointF(0.0, 0.0), size);
    target.moveCenter(QRectF(box).center());
    painter->drawImage(target, picture);
}

struct Ink {
    QColor title;
    QColor details;
};

Ink inkOf(const QStyleOptionViewItem& option, bool isGreyed) {
    const bool isSelected = (option.state & QStyle::State_Selected) != 0;
    const auto group = (option.state & QStyle::State_Active) != 0 ? QPalette::Active : QPalette::Inactive;
    const QColor text = option.palette.color(group, isSelected ? QPalette::HighlightedText : QPalette::Text);
    if (!isGreyed || isSelected) return {text, text};
    const QColor grey = option.palette.color(QPalette::Disabled, QPalette::Text);
    return {grey, grey};
}

void paintLines(QPainter* painter, QRect room, const QStyleOptionViewItem& option, const QModelIndex& index) {
    const QString whyNot = index.data(StudyTreeModel::whyNotRole).toString();
    const Ink ink = inkOf(option, !whyNot.isEmpty());
    const Qt::Alignment align = QStyle::visualAlignment(option.direction, Qt::AlignLeft | Qt::AlignTop);
    const auto line = [&](const QString& text) {
        const QFontMetrics metrics(painter->font());
        painter->drawText(room, int(align) | Qt::TextSingleLine,
                          metrics.elidedText(text, Qt::ElideRight, room.width()));
        room.setTop(room.top() + metrics.lineSpacing());
    };
    QFont bold = option.font;
    bold.setBold(true);
    painter->setFont(index.data(StudyTreeModel::isOpenRole).toBool() ? bold : option.font);
    painter->setPen(ink.title);
    const QString title = index.data(Qt::DisplayRole).toString();
    // A title may take two lines, for which sizeHint() leaves room: descriptions of series often differ only
    // at their end.
    const qsizetype first = index.data(StudyTreeModel::hasPictureRole).toBool()
                                ? firstLineOf(title, painter->font(), room.width())
                                : title.size();
    line(title.left(first).trimmed());
    if (first < title.size()) line(title.mid(first).trimmed());
    painter->setFont(option.font);
    painter->setPen(ink.details);
    for (const QString& text : index.data(StudyTreeModel::detailsRole).toStringList()) line(text);
    if (!whyNot.isEmpty() && room.height() > 0)
        painter->drawText(room, int(align) | Qt::TextWordWrap, whyNot);
}

}  // namespace

void StudyRowDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                             const QModelIndex& index) const {
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    option.text.clear();
    const QStyle* style = option.widget != nullptr ? option.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);

    painter->save();
    painter->setClipRect(option.rect);
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    QRect room = option.rect.adjusted(kMarginPx, kMarginPx, -kMarginPx, -kMarginPx);
    if (showsPicture(index, room.width())) {
        const QRect box(room.topLeft(), QSize(kPicturePx, kPicturePx));
        paintPicture(painter, QStyle::visualRect(option.direction, option.rect, box),
                     index.data(StudyTreeModel::pictureRole).value<QImage>(), option.palette);
        room.setLeft(box.right() + 1 + 2 * kMarginPx);
    }
    paintLines(painter, QStyle::visualRect(option.direction, option.rect, room), option, index);
    painter->restore();
}

QSize StudyRowDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const bool hasPicture = index.data(StudyTreeModel::hasPictureRole).toBool();
    const int lines = index.data(StudyTreeModel::lineCountRole).toInt() + (hasPicture ? 1 : 0);
    const int text = lines * option.fontMetrics.lineSpacing();
    const int height = std::max(text, hasPicture ? kPicturePx : 0);
    return {(hasPicture ? kPicturePx + 2 * kMarginPx : 0) + kLeastTextPx, height + 2 * kMarginPx};
}

}  // namespace macula::viewer

// Paints the rows of the study browser.
#pragma once

#include <QStyledItemDelegate>

namespace macula::viewer {

// For a StudyTreeModel: lines of text beside the row's thumbnail, if it has one.
class StudyRowDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& given, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace macula::viewer

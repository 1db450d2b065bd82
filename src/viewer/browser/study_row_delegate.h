// How a row of the study browser is painted.
#pragma once

#include <QStyledItemDelegate>

namespace macula::viewer {

// Lines of text, beside a picture where the row has one. Of a StudyTreeModel.
class StudyRowDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& given, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace macula::viewer

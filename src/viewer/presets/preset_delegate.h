// Draws the gallery's headings and presets.
#pragma once

#include <QStyledItemDelegate>

namespace macula::viewer {

// A heading fills a row; a preset is a picture with two lines below it. Uses the colours of the palette.
class PresetDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    explicit PresetDelegate(QObject* parent = nullptr);

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace macula::viewer

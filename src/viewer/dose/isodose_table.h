// The levels of the isodoses, with their colours.
#pragma once

#include <QTableWidget>
#include <optional>

#include "scene/second/dose_lines.h"
#include "scene/second/isodoses.h"

namespace macula::viewer {

// A person edits a level by a double click or F2, and its colour by a double click on it or Enter.
class IsodoseTable : public QTableWidget {
    Q_OBJECT

  public:
    explicit IsodoseTable(QWidget* parent = nullptr);

    // `unit` is that of the dose.
    void show(const scene::Isodoses& isodoses, const std::optional<study::DoseReference>& reference,
              const QString& unit);
    const scene::Isodoses& isodoses() const { return isodoses_; }
    // The row that a person chose, else the last; nothing without a row.
    std::optional<std::size_t> current() const;

  Q_SIGNALS:
    void levelEntered(std::size_t row, double level);  // is usable
    void colourAsked(std::size_t row);

  private:
    void fill();
    QTableWidgetItem& cellAt(int row, int column);
    void onChanged(QTableWidgetItem* item);

    scene::Isodoses isodoses_;
    std::optional<study::DoseReference> reference_;
    QString unit_;
    bool isFilling_ = false;
};

}  // namespace macula::viewer

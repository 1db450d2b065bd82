// The series of the selected study, side by side, each with a picture where there is one.
#pragma once

#include <QImage>
#include <QString>
#include <QWidget>
#include <cstddef>
#include <vector>

#include "net/archive/query.h"

class QListWidget;

namespace macula::viewer {

inline constexpr int kSeriesPicturePx = 72;

// Hidden while there are no series. Lives on the UI thread.
class SeriesStrip : public QWidget {
    Q_OBJECT

  public:
    explicit SeriesStrip(QWidget* parent = nullptr);

    void setSeries(std::vector<net::FoundSeries> series);
    const std::vector<net::FoundSeries>& series() const { return series_; }
    void setPicture(std::size_t series, const QImage& picture);
    void showNames(bool shown);               // otherwise descriptions are hidden, which may hold one
    std::vector<std::size_t> inView() const;  // indices of series

  Q_SIGNALS:
    void viewChanged();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QString textOf(const net::FoundSeries& series) const;
    QSize itemSize() const;

    QListWidget* list_;
    std::vector<net::FoundSeries> series_;
    bool namesShown_ = true;
};

}  // namespace macula::viewer

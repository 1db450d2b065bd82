// Says that a study has appeared in a folder that is watched, or was sent to this program, until a person
// opens it or says that it was seen.
#pragma once

#include <QWidget>
#include <deque>
#include <optional>

#include "study/watch/watched_folder.h"

class QLabel;
class QPushButton;

namespace macula::viewer {

// One study at a time, those that came first before the others. Lives on the UI thread.
class ArrivalBar : public QWidget {
    Q_OBJECT

  public:
    explicit ArrivalBar(QWidget* parent = nullptr);

    void add(const study::ArrivedStudy& study);  // in place of an earlier message about the same study
    void dropFolder(const std::filesystem::path& folder);
    void showNames(bool shown);
    std::size_t waiting() const { return waiting_.size(); }
    QString text() const;

  Q_SIGNALS:
    void openAsked(const macula::study::ArrivedStudy& study);

  private:
    void next();
    void refresh();
    QString whereItArrived(const study::ArrivedStudy& study) const;

    std::deque<study::ArrivedStudy> waiting_;
    bool namesShown_ = true;
    QLabel* text_;
    QPushButton* open_;
    QPushButton* seen_;
};

}  // namespace macula::viewer

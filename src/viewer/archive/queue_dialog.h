// Shows what waits for archives, and why; sends it again, or removes it.
#pragma once

#include <QDialog>
#include <QStringList>
#include <vector>

#include "study/outbox/outbox.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace macula::viewer {

// Lives on the UI thread.
class QueueDialog : public QDialog {
    Q_OBJECT

  public:
    explicit QueueDialog(QWidget* parent = nullptr);

    void setEntries(std::vector<study::OutboxEntry> entries);
    void showNames(bool shown);  // otherwise patients are hidden
    void setSending(bool sending);

  Q_SIGNALS:
    // What the archive refused before goes, too: a person chose it.
    void sendAsked(const std::vector<macula::study::OutboxEntry>& entries);
    void removeAsked(const std::vector<macula::study::OutboxEntry>& entries);

  private:
    void fill();
    void tellWhy();
    void askWhetherToRemove();
    std::vector<study::OutboxEntry> chosen() const;

    std::vector<study::OutboxEntry> entries_;
    bool namesShown_ = true;
    bool isSending_ = false;
    QTreeWidget* list_;
    QLabel* why_;
    QPushButton* send_;
    QPushButton* remove_;
};

}  // namespace macula::viewer

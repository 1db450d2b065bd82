// Offers to send what waits for an archive.
#pragma once

#include <QWidget>
#include <vector>

#include "study/outbox/outbox.h"

class QLabel;
class QPushButton;

namespace macula::viewer {

// "2 objects wait for Hospital." Shown until a person sends them or dismisses it. Names nobody. Lives on the
// UI thread.
class WaitingBar : public QWidget {
    Q_OBJECT

  public:
    explicit WaitingBar(QWidget* parent = nullptr);

    // Hides itself where nothing waits.
    void offer(const std::vector<study::OutboxEntry>& entries);
    QString text() const;

  Q_SIGNALS:
    void sendAsked();
    void queueAsked();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void recolour();

    QLabel* text_;
};

// How many objects wait, without those that were refused.
int waitingCount(const std::vector<study::OutboxEntry>& entries);

}  // namespace macula::viewer

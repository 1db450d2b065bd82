// Small widgets of the main window.
#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>

#include "base/result.h"
#include "live/frame/fidelity.h"

namespace macula::viewer {

// A label that elides text without room and shows it in the tool tip, so that a long device name never widens
// the window and its picture.
class ElidingLabel : public QLabel {
    Q_OBJECT

  public:
    explicit ElidingLabel(const QString& what, QWidget* parent = nullptr);

    // Only the tool tip shows `more`.
    void setFullText(const QString& text, const QString& more = {});
    QString fullText() const { return full_; }
    // Makes the labels beside it elide first, until it has most of their parent's width.
    void keepLongest();
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void elide();
    int roomPx() const;

    bool isKeptLongest_ = false;
    QString what_;
    QString full_;
    QString more_;
};

// Shows in a word whether the picture is final; the tool tip says why not. Empty without a picture.
class FidelityBadge : public QLabel {
    Q_OBJECT

  public:
    explicit FidelityBadge(QWidget* parent = nullptr);

    void setFidelity(const live::Fidelity& fidelity);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    bool isFinal_ = false;
};

// Shows an error and a hint until it is dismissed. Never blocks anything else.
class MessageBar : public QWidget {
    Q_OBJECT

  public:
    explicit MessageBar(QWidget* parent = nullptr);

    void showError(const Error& error);
    void showNote(const QString& text);
    QString text() const { return text_->text(); }

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void show(const QString& text, bool isError);
    void recolour();

    QLabel* text_ = nullptr;
    bool isError_ = false;
};

// Shows background work: its stage, its progress, and a cancel button.
class WorkBar : public QWidget {
    Q_OBJECT

  public:
    explicit WorkBar(QWidget* parent = nullptr);

    void begin(const QString& stage);
    void setProgress(const QString& stage, double fraction);

  Q_SIGNALS:
    void cancelClicked();

  private:
    QLabel* stage_ = nullptr;
    QProgressBar* bar_ = nullptr;
    QPushButton* cancel_ = nullptr;
};

}  // namespace macula::viewer

// Small widgets of the main window.
#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>

#include "base/result.h"
#include "live/frame/fidelity.h"

namespace macula::viewer {

// A label that gives way: what does not fit is cut short with an ellipsis and told by the tool tip, so that a
// long device name never widens the window and with it the picture.
class ElidingLabel : public QLabel {
    Q_OBJECT

  public:
    explicit ElidingLabel(const QString& what, QWidget* parent = nullptr);

    // `more` is told by the tool tip only.
    void setFullText(const QString& text, const QString& more = {});
    QString fullText() const { return full_; }
    // The labels beside it give way first, until it has most of their parent's width.
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

// Whether what is on screen is as good as it gets, in a word; why not, in the tool tip. Nothing without a
// picture.
class FidelityBadge : public QLabel {
    Q_OBJECT

  public:
    explicit FidelityBadge(QWidget* parent = nullptr);

    void setFidelity(const app::Fidelity& fidelity);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    bool isFinal_ = false;
};

// One sentence about what went wrong and one about what to do, until it is dismissed. Never in the way of
// anything else.
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

// What work in the background is doing, how far it is, and a way out.
class WorkBar : public QWidget {
    Q_OBJECT

  public:
    explicit WorkBar(QWidget* parent = nullptr);

    void begin(const QString& stage);
    void setProgress(const QString& stage, double fraction);

  signals:
    void cancelClicked();

  private:
    QLabel* stage_ = nullptr;
    QProgressBar* bar_ = nullptr;
    QPushButton* cancel_ = nullptr;
};

}  // namespace macula::viewer

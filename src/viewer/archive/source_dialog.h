// Sets up archives: their addresses, a test of each step, and their removal.
#pragma once

#include <QDialog>
#include <optional>
#include <vector>

#include "net/archive/archive.h"
#include "net/sources/source_list.h"
#include "net/web/device_sign_in.h"
#include "viewer/jobs/background_job.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QStackedWidget;

namespace macula::viewer {

// Settings that this dialog does not show stay as they are. Lives on the UI thread.
class SourceDialog : public QDialog {
    Q_OBJECT

  public:
    // `sources` outlives it.
    explicit SourceDialog(net::SourceList& sources, QWidget* parent = nullptr);

  private:
    QWidget* makeDimse();
    QWidget* makeWeb();
    QWidget* makeButtons();
    void listSources(const QString& chosen);
    void showSource(const std::optional<net::Source>& source);
    void showPeer(const net::DimsePeer& peer);
    void showPeer(const net::WebPeer& peer);
    net::Source source() const;
    net::DimsePeer dimsePeer() const;
    net::WebPeer webPeer() const;
    net::Secrets secrets() const;
    bool save();
    void test();
    void remove();
    void signIn();
    void showCode(const net::DeviceCode& code);
    void showButtons();
    void say(const Result<void>& outcome, const QString& told);
    void showSteps(const std::vector<net::TestStep>& steps);

    net::SourceList& sources_;
    net::Source shown_;  // as it was read; the form changes a copy
    net::Secrets kept_;  // of it
    QComboBox* chosen_;
    QLineEdit* name_;
    QComboBox* kind_;
    QStackedWidget* peers_;
    QLineEdit* host_ = nullptr;
    QSpinBox* port_ = nullptr;
    QLineEdit* calledAe_ = nullptr;
    QLineEdit* callingAe_ = nullptr;
    QComboBox* retrieve_ = nullptr;
    QSpinBox* receiverPort_ = nullptr;
    QCheckBox* tls_ = nullptr;
    QLineEdit* url_ = nullptr;
    QLineEdit* user_ = nullptr;
    QLineEdit* password_ = nullptr;
    QPushButton* test_ = nullptr;
    QPushButton* save_ = nullptr;
    QPushButton* remove_ = nullptr;
    QPushButton* signInButton_ = nullptr;
    QLabel* remark_;
    BackgroundJob<std::vector<net::TestStep>> job_;
    BackgroundJob<net::Secrets> signIn_;
};

}  // namespace macula::viewer

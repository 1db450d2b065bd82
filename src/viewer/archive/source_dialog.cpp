#include "viewer/archive/source_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <QUrl>
#include <QVBoxLayout>
#include <nlohmann/json.hpp>
#include <utility>

#include "net/connect.h"
#include "net/sources/source_json.h"
#include "viewer/jobs/newest_posted.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr int kHighestPort = 65535;
constexpr int kRemarkLines = 6;

QLineEdit* field(QFormLayout& form, const QString& label, const char* name, const QString& tip) {
    auto* line = new QLineEdit;
    describe(*line, name, label, tip);
    form.addRow(label, line);
    return line;
}

QSpinBox* portField(QFormLayout& form, const QString& label, const char* name, const QString& tip) {
    auto* port = new QSpinBox;
    describe(*port, name, label, tip);
    port->setRange(0, kHighestPort);
    form.addRow(label, port);
    return port;
}

std::string textOf(const QLineEdit& line) {
    return line.text().trimmed().toStdString();
}

void setText(QLineEdit& line, const std::string& text) {
    line.setText(QString::fromStdString(text));
}

}  // namespace

SourceDialog::SourceDialog(net::SourceList& sources, QWidget* parent)
    : QDialog(parent),
      sources_(sources),
      chosen_(new QComboBox(this)),
      name_(new QLineEdit(this)),
      kind_(new QComboBox(this)),
      peers_(new QStackedWidget(this)),
      remark_(new QLabel(this)),
      job_(this, {.ended =
                      [this](const Result<std::vector<net::TestStep>>& steps) {
                          test_->setEnabled(true);
                          if (steps)
                              showSteps(*steps);
                          else
                              remark_->setText(inWindowsLanguage(steps.error()));
                      }}),
      signIn_(this, {.ended = [this](const Result<net::Secrets>& secrets) {
                  showButtons();
                  if (!secrets) return remark_->setText(inWindowsLanguage(secrets.error()));
                  kept_ = *secrets;
                  say(sources_.keep(shown_, kept_), tr("Signed in."));
              }}) {
    setWindowTitle(tr("Archives"));
    describe(*chosen_, "source-chosen", tr("Archive"), tr("Which archive is changed here"));
    describe(*name_, "source-name", tr("Name"), tr("What you call it"));
    describe(*kind_, "source-kind", tr("It speaks"),
             tr("Which of the two the archive offers; its administrator knows"));
    kind_->addItems({tr("DICOM (DIMSE)"), tr("DICOMweb")});
    peers_->addWidget(makeDimse());
    peers_->addWidget(makeWeb());
    makePlain(*remark_, "source-remark");
    remark_->setMinimumHeight(kRemarkLines * fontMetrics().lineSpacing());
    remark_->setAlignment(Qt::AlignTop);
    auto* form = new QFormLayout;
    form->addRow(tr("Archive"), chosen_);
    form->addRow(tr("Name"), name_);
    form->addRow(tr("It speaks"), kind_);
    auto* column = new QVBoxLayout(this);
    column->addLayout(form);
    column->addWidget(peers_);
    column->addWidget(remark_, 1);
    column->addWidget(makeButtons());
    connect(kind_, &QComboBox::currentIndexChanged, peers_, &QStackedWidget::setCurrentIndex);
    connect(chosen_, &QComboBox::activated, this, [this](int index) {
        if (index == 0) return showSource(std::nullopt);
        if (const auto found = sources_.find(chosen_->currentText().toStdString())) showSource(*found);
    });
    listSources({});
}

QWidget* SourceDialog::makeDimse() {
    auto* page = new QWidget(this);
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 0, 0, 0);
    host_ = field(*form, tr("Host"), "source-host", tr("Name or address of the archive's machine"));
    port_ = portField(*form, tr("Port"), "source-port", tr("Usually 104 or 11112"));
    calledAe_ = field(*form, tr("Its AE title"), "source-called", tr("1 to 16 characters"));
    callingAe_ = field(*form, tr("Our AE title"), "source-calling",
                       tr("As the archive knows this program; tell its administrator"));
    retrieve_ = new QComboBox(this);
    describe(*retrieve_, "source-retrieve", tr("Images come by"),
             tr("C-GET needs no port of ours; C-MOVE needs one, which the archive must know"));
    retrieve_->addItems({tr("what it accepts"), tr("C-GET"), tr("C-MOVE")});
    form->addRow(tr("Images come by"), retrieve_);
    receiverPort_ = portField(*form, tr("Our port"), "source-receiver-port",
                              tr("For C-MOVE: where Macula receives while a study is fetched; 0: nowhere"));
    tls_ = new QCheckBox(tr("Encrypt the connection (TLS)"), this);
    describe(*tls_, "source-tls", tls_->text(), tr("The archive must offer it at this port"));
    form->addRow(QString(), tls_);
    return page;
}

QWidget* SourceDialog::makeWeb() {
    auto* page = new QWidget(this);
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 0, 0, 0);
    url_ = field(*form, tr("Address"), "source-url",
                 tr("Of the DICOMweb service, as https://pacs.example.org/dicom-web"));
    user_ = field(*form, tr("User"), "source-user", tr("Empty: nobody signs in"));
    password_ = field(*form, tr("Password"), "source-password", tr("Kept in a file that only you can read"));
    password_->setEchoMode(QLineEdit::Password);
    return page;
}

QWidget* SourceDialog::makeButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    test_ = buttons->addButton(tr("Test"), QDialogButtonBox::ActionRole);
    save_ = buttons->addButton(tr("Save"), QDialogButtonBox::ApplyRole);
    remove_ = buttons->addButton(tr("Remove"), QDialogButtonBox::ActionRole);
    signInButton_ = buttons->addButton(tr("Sign In…"), QDialogButtonBox::ActionRole);
    signInButton_->setObjectName(QStringLiteral("source-sign-in"));
    signInButton_->setToolTip(tr("Sign in at this archive by a browser"));
    connect(signInButton_, &QPushButton::clicked, this, &SourceDialog::signIn);
    test_->setObjectName(QStringLiteral("source-test"));
    save_->setObjectName(QStringLiteral("source-save"));
    remove_->setObjectName(QStringLiteral("source-remove"));
    test_->setToolTip(tr("Try the archive step by step"));
    save_->setToolTip(tr("Keep these settings"));
    remove_->setToolTip(tr("Forget this archive and its password; what was fetched stays"));
    connect(test_, &QPushButton::clicked, this, &SourceDialog::test);
    connect(save_, &QPushButton::clicked, this, &SourceDialog::save);
    connect(remove_, &QPushButton::clicked, this, &SourceDialog::remove);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    return buttons;
}

void SourceDialog::listSources(const QString& chosen) {
    chosen_->clear();
    chosen_->addItem(tr("A new one"));
    for (const net::Source& source : sources_.all()) chosen_->addItem(QString::fromStdString(source.name));
    const int place = std::max(0, chosen_->findText(chosen));
    chosen_->setCurrentIndex(place);
    const auto found = sources_.find(chosen.toStdString());
    showSource(place > 0 && found ? std::optional(*found) : std::nullopt);
}

void SourceDialog::showSource(const std::optional<net::Source>& source) {
    job_.cancel();
    signIn_.cancel();
    test_->setEnabled(true);
    shown_ = source.value_or(net::Source());
    kept_ = {};
    remark_->clear();
    if (source) {
        auto secrets = sources_.secretsOf(*source);
        if (secrets)
            kept_ = *std::move(secrets);
        else
            remark_->setText(inWindowsLanguage(secrets.error()));
    }
    setText(*name_, shown_.name);
    const auto* web = std::get_if<net::WebPeer>(&shown_.peer);
    kind_->setCurrentIndex(web != nullptr ? 1 : 0);
    showPeer(web != nullptr ? net::DimsePeer() : std::get<net::DimsePeer>(shown_.peer));
    showPeer(web != nullptr ? *web : net::WebPeer());
    for (QWidget* each : std::initializer_list<QWidget*>{name_, kind_, peers_, save_, remove_})
        each->setEnabled(!shown_.isManaged);
    remove_->setEnabled(source && !shown_.isManaged);
    showButtons();
    if (shown_.isManaged) remark_->setText(tr("Your administrator has set up this archive."));
}

// The way to sign in is set up by the command or the administrator.
void SourceDialog::showButtons() {
    const auto* web = std::get_if<net::WebPeer>(&shown_.peer);
    signInButton_->setVisible(web != nullptr && web->signIn == net::SignIn::device);
    signInButton_->setEnabled(!signIn_.running());
}

void SourceDialog::showPeer(const net::DimsePeer& peer) {
    setText(*host_, peer.host);
    port_->setValue(peer.port);
    setText(*calledAe_, peer.calledAe);
    setText(*callingAe_, peer.callingAe);
    retrieve_->setCurrentIndex(int(peer.retrieve));
    receiverPort_->setValue(peer.receiverPort);
    tls_->setChecked(peer.tls.isOn);
}

void SourceDialog::showPeer(const net::WebPeer& peer) {
    setText(*url_, peer.url);
    setText(*user_, peer.user);
    setText(*password_, kept_.password);
}

net::DimsePeer SourceDialog::dimsePeer() const {
    const auto* before = std::get_if<net::DimsePeer>(&shown_.peer);
    net::DimsePeer peer = before != nullptr ? *before : net::DimsePeer();
    peer.host = textOf(*host_);
    peer.port = std::uint16_t(port_->value());
    peer.calledAe = textOf(*calledAe_);
    peer.callingAe = textOf(*callingAe_);
    peer.retrieve = net::Retrieve(retrieve_->currentIndex());
    peer.receiverPort = std::uint16_t(receiverPort_->value());
    peer.tls.isOn = tls_->isChecked();
    return peer;
}

net::WebPeer SourceDialog::webPeer() const {
    const auto* before = std::get_if<net::WebPeer>(&shown_.peer);
    net::WebPeer peer = before != nullptr ? *before : net::WebPeer();
    peer.url = textOf(*url_);
    peer.user = textOf(*user_);
    // Other ways to sign in are set up by the command or the administrator, and stay.
    const bool byPassword = peer.signIn == net::SignIn::none || peer.signIn == net::SignIn::basic;
    if (byPassword) peer.signIn = peer.user.empty() ? net::SignIn::none : net::SignIn::basic;
    return peer;
}

net::Source SourceDialog::source() const {
    net::Source source = shown_;
    source.name = textOf(*name_);
    if (kind_->currentIndex() == 0)
        source.peer = dimsePeer();
    else
        source.peer = webPeer();
    return source;
}

net::Secrets SourceDialog::secrets() const {
    net::Secrets secrets = kept_;
    // A test or another window may have renewed the tokens since.
    if (const auto now = sources_.secretsOf(shown_); now && !now->refreshToken.empty()) {
        secrets.token = now->token;
        secrets.refreshToken = now->refreshToken;
    }
    if (kind_->currentIndex() == 1) secrets.password = password_->text().toStdString();
    return secrets;
}

void SourceDialog::say(const Result<void>& outcome, const QString& told) {
    remark_->setText(outcome ? told : inWindowsLanguage(outcome.error()));
}

bool SourceDialog::save() {
    const net::Source changed = source();
    if (const auto archive = net::archiveOf(changed, secrets()); !archive) {
        remark_->setText(inWindowsLanguage(archive.error()));
        return false;
    }
    const bool isOther = changed.name != shown_.name && sources_.find(changed.name).ok();
    if (isOther) {
        remark_->setText(tr("Another archive has this name already. Choose another name."));
        return false;
    }
    Result<void> done = sources_.put(changed);
    if (done) done = sources_.keep(changed, secrets());
    // Under another name it is another archive; the former one goes.
    if (done && !shown_.name.empty() && shown_.name != changed.name) done = sources_.remove(shown_.name);
    if (done) listSources(QString::fromStdString(changed.name));
    say(done, tr("Saved."));
    return done.ok();
}

void SourceDialog::test() {
    const net::Source changed = source();
    // Of what is kept as it is here, new tokens are kept too.
    const bool isKept = changed.name == shown_.name && net::toJson(changed) == net::toJson(shown_) &&
                        secrets().password == kept_.password;
    auto archive = isKept ? net::archiveOf(sources_, changed) : net::archiveOf(changed, secrets());
    if (!archive) return remark_->setText(inWindowsLanguage(archive.error()));
    remark_->setText(tr("Trying…"));
    test_->setEnabled(false);
    // A job is copied into its thread; an archive is not.
    job_.start([shared = std::shared_ptr<net::Archive>(*std::move(archive))](Progress& progress)
                   -> Result<std::vector<net::TestStep>> { return shared->test(progress); });
}

void SourceDialog::remove() {
    const Result<void> removed = sources_.remove(shown_.name);
    if (removed) listSources({});
    say(removed, tr("Removed."));
}

void SourceDialog::signIn() {
    remark_->setText(tr("Asking for a code…"));
    const NewestPosted<net::DeviceCode> codes(this, [this](const net::DeviceCode& code) { showCode(code); });
    signIn_.start([source = shown_, secrets = kept_, codes](Progress& progress) {
        return net::signInByDevice(source, secrets, codes, progress);
    });
    showButtons();
}

void SourceDialog::showCode(const net::DeviceCode& code) {
    if (!signIn_.running()) return;
    const QString address = QString::fromStdString(code.address);
    remark_->setText(tr("Sign in with a browser, on this device or another, at %1. The code is %2.")
                         .arg(address, QString::fromStdString(code.userCode)));
    const bool hasWhole = !code.wholeAddress.empty();
    QDesktopServices::openUrl(QUrl(hasWhole ? QString::fromStdString(code.wholeAddress) : address));
}

void SourceDialog::showSteps(const std::vector<net::TestStep>& steps) {
    QStringList lines;
    for (const net::TestStep& step : steps) {
        QString line =
            (step.passed ? QStringLiteral("✓ ") : QStringLiteral("✗ ")) + inWindowsLanguage(step.name);
        if (!step.detail.empty()) line += QStringLiteral(": ") + inWindowsLanguage(step.detail);
        if (!step.advice.empty()) line += QLatin1Char(' ') + inWindowsLanguage(step.advice);
        lines.append(line);
    }
    remark_->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace macula::viewer

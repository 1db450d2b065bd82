#include "viewer/settings/receive_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr int kHighestPort = 65535;
constexpr int kLongestTitle = 16;

// Which addresses of this machine others reach it at.
enum Place { thisMachineAlone, allAddresses, oneAddress };

Place placeOf(const QString& address) {
    if (address.isEmpty()) return allAddresses;
    return address == ReceiveSettings{}.address ? thisMachineAlone : oneAddress;
}

}  // namespace

ReceivePage::ReceivePage(const ReceiveSettings& settings, QWidget* parent)
    : QWidget(parent),
      title_(new QLineEdit(settings.title, this)),
      port_(new QSpinBox(this)),
      places_(new QComboBox(this)),
      address_(new QLineEdit(this)),
      limitGb_(new QSpinBox(this)),
      atStart_(new QCheckBox(tr("&Receive from the start of each window"), this)),
      trouble_(new QLabel(this)) {
    auto* form = new QFormLayout(this);
    describe(*title_, "receive-title", tr("AE title of Macula"),
             tr("The name that senders call; 1 to 16 letters, digits and signs"));
    title_->setMaxLength(kLongestTitle);
    form->addRow(tr("&AE title"), title_);
    describe(*port_, "receive-port", tr("Port"), tr("Where senders reach Macula, 1 to 65535; usually 11112"));
    port_->setRange(1, kHighestPort);
    port_->setValue(settings.port);
    form->addRow(tr("&Port"), port_);
    form->addRow(tr("Reached &at"), makePlace(settings));
    addCallers(*form, settings);
    certificate_ = addFile(*form, tr("&Certificate"), "receive-certificate",
                           tr("PEM file of a certificate of this machine: connections are encrypted then"),
                           settings.certificate);
    key_ = addFile(*form, tr("Its &key"), "receive-key", tr("PEM file of the key of the certificate"),
                   settings.key);
    authorities_ = addFile(*form, tr("A&uthorities"), "receive-authorities",
                           tr("PEM file of who may sign the certificates that senders then must show"),
                           settings.authorities);
    describe(*limitGb_, "receive-limit", tr("How much to take in all, in GB"),
             tr("While one window is open, 0 to %1 GB; 0 is no limit").arg(kMostReceivedGb));
    limitGb_->setRange(0, kMostReceivedGb);
    limitGb_->setSpecialValueText(tr("no limit"));
    limitGb_->setSuffix(tr(" GB"));
    limitGb_->setValue(settings.limitGb);
    form->addRow(tr("&Limit"), limitGb_);
    describe(*atStart_, "receive-at-start", tr("Receive from the start of each window"),
             tr("Otherwise nothing listens until File, Receive Studies is chosen"));
    atStart_->setChecked(settings.atStart);
    form->addRow(atStart_);
    makePlain(*trouble_, "receive-trouble");
    form->addRow(trouble_);
    for (QLineEdit* field : findChildren<QLineEdit*>())
        connect(field, &QLineEdit::textChanged, this, &ReceivePage::showWhatCannotWork);
    connect(anyone_, &QCheckBox::toggled, this, &ReceivePage::showWhatCannotWork);
    connect(places_, &QComboBox::currentIndexChanged, this, &ReceivePage::showWhatCannotWork);
    showWhatCannotWork();
}

QWidget* ReceivePage::makePlace(const ReceiveSettings& settings) {
    auto* box = new QWidget(this);
    describe(*places_, "receive-place", tr("Who reaches Macula"),
             tr("Programs of this machine alone, or other machines too"));
    places_->addItem(tr("This machine alone"), int(thisMachineAlone));
    places_->addItem(tr("All addresses of this machine"), int(allAddresses));
    places_->addItem(tr("One address of this machine"), int(oneAddress));
    const Place place = placeOf(settings.address);
    places_->setCurrentIndex(places_->findData(int(place)));
    describe(*address_, "receive-address", tr("Address of this machine"),
             tr("An IP address of this machine, at which senders reach Macula"));
    address_->setPlaceholderText(ReceiveSettings{}.address);
    if (place == oneAddress) address_->setText(settings.address);
    address_->setEnabled(place == oneAddress);
    connect(places_, &QComboBox::currentIndexChanged, address_,
            [this] { address_->setEnabled(places_->currentData().toInt() == oneAddress); });
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(places_, 1);
    row->addWidget(address_, 1);
    return box;
}

void ReceivePage::addCallers(QFormLayout& form, const ReceiveSettings& settings) {
    callers_ = addField(form, tr("&Who may send"), "receive-callers",
                        tr("TITLE, TITLE@ADDRESS or *@ADDRESS, several with commas between; an address may "
                           "be a range, as *@10.1.0.0/16. AE titles alone prove nothing."),
                        settings.callers.join(QStringLiteral(", ")));
    callers_->setPlaceholderText(tr("for example %1").arg(QStringLiteral("CT1@10.1.2.3, *@10.1.0.0/16")));
    anyone_ = new QCheckBox(tr("&Everybody who reaches this machine"), this);
    describe(*anyone_, "receive-anyone", tr("Everybody who reaches this machine may send"),
             tr("Whoever reaches the port may send, whatever stands above"));
    anyone_->setChecked(settings.admitsAnyone);
    form.addRow(QString(), anyone_);
}

QLineEdit* ReceivePage::addField(QFormLayout& form, const QString& label, const char* name,
                                 const QString& tip, const QString& text) {
    auto* field = new QLineEdit(text, this);
    describe(*field, name, QString(label).remove(QLatin1Char('&')), tip);
    field->setClearButtonEnabled(true);
    form.addRow(label, field);
    return field;
}

QLineEdit* ReceivePage::addFile(QFormLayout& form, const QString& label, const char* name, const QString& tip,
                                const QString& file) {
    auto* box = new QWidget(this);
    auto* field = new QLineEdit(file, box);
    const QString title = QString(label).remove(QLatin1Char('&'));
    describe(*field, name, title, tip);
    field->setClearButtonEnabled(true);
    auto* choose = new QPushButton(tr("Choose…"), box);
    choose->setObjectName(QString::fromLatin1(name) + QStringLiteral("-choose"));
    choose->setAccessibleName(tr("Choose the file of: %1").arg(title));
    choose->setToolTip(tip);
    connect(choose, &QPushButton::clicked, field, [this, field, title] {
        auto* dialog = new QFileDialog(this, title, field->text());
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->setFileMode(QFileDialog::ExistingFile);
        connect(dialog, &QFileDialog::fileSelected, field, &QLineEdit::setText);
        dialog->open();  // exec() would run a second event loop
    });
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(field, 1);
    row->addWidget(choose);
    auto* text = new QLabel(label, this);
    text->setBuddy(field);
    form.addRow(text, box);
    return field;
}

void ReceivePage::showWhatCannotWork() {
    const auto options = receivingOptions(settings());
    trouble_->setText(options ? tr("File, Receive Studies begins and ends it. Macula says what arrived, and "
                                   "opens nothing by itself.")
                              : inWindowsLanguage(options.error()));
}

ReceiveSettings ReceivePage::settings() const {
    ReceiveSettings now;
    now.atStart = atStart_->isChecked();
    now.title = title_->text().trimmed();
    now.port = port_->value();
    if (places_->currentData().toInt() == allAddresses) now.address.clear();
    // Without one only this machine reaches it: a field that was forgotten must not open a port to others.
    const QString address = address_->text().trimmed();
    if (places_->currentData().toInt() == oneAddress && !address.isEmpty()) now.address = address;
    for (const QString& each : callers_->text().split(QLatin1Char(','), Qt::SkipEmptyParts))
        if (!each.trimmed().isEmpty()) now.callers.append(each.trimmed());
    now.admitsAnyone = anyone_->isChecked();
    now.certificate = certificate_->text().trimmed();
    now.key = key_->text().trimmed();
    now.authorities = authorities_->text().trimmed();
    now.limitGb = limitGb_->value();
    return now;
}

}  // namespace macula::viewer

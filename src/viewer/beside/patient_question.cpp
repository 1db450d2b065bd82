#include "viewer/beside/patient_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>
#include <utility>

namespace macula::viewer {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("PatientQuestion", text);
}

}  // namespace

void askAboutPatient(QWidget* parent, const QStringList& differs, std::function<void()> open,
                     std::function<void()> leave) {
    auto* box =
        new QMessageBox(QMessageBox::Warning, tr("Another patient?"),
                        tr("The second volume is of another patient than the study. What differs: %1.")
                            .arg(differs.join(QStringLiteral(", "))),
                        QMessageBox::Cancel, parent);
    box->setObjectName(QStringLiteral("patient-question"));
    box->setInformativeText(tr(
        "Open it only if you know that both are of one patient, or mean to compare two patients. Pictures of "
        "it will say so."));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* yes = box->addButton(tr("&Open All the Same"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    QObject::connect(box, &QMessageBox::finished, box,
                     [box, yes, open = std::move(open), leave = std::move(leave)] {
                         if (box->clickedButton() == yes) {
                             open();
                         } else {
                             leave();
                         }
                     });
    box->open();  // exec() would run a second event loop
}

}  // namespace macula::viewer

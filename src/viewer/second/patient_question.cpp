#include "viewer/second/patient_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>
#include <array>
#include <utility>

namespace macula::viewer {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(PatientQuestion)

  public:
    // The attributes that study::whatDiffers may return.
    static constexpr std::array kAttributes{
        QT_TRANSLATE_NOOP("PatientQuestion", "ID"), QT_TRANSLATE_NOOP("PatientQuestion", "name"),
        QT_TRANSLATE_NOOP("PatientQuestion", "date of birth"), QT_TRANSLATE_NOOP("PatientQuestion", "sex")};
};

QString inWords(const QStringList& attributes) {
    QStringList all;
    for (const char* attribute : Words::kAttributes) {
        if (attributes.contains(QLatin1String(attribute))) all << Words::tr(attribute);
    }
    return all.join(QStringLiteral(", "));
}

}  // namespace

void askAboutPatient(QWidget* parent, const QStringList& differs, std::function<void()> open,
                     std::function<void()> leave) {
    auto* box =
        new QMessageBox(QMessageBox::Warning, Words::tr("Another patient?"),
                        Words::tr("The second volume is of another patient than the study. What differs: %1.")
                            .arg(inWords(differs)),
                        QMessageBox::Cancel, parent);
    box->setObjectName(QStringLiteral("patient-question"));
    box->setInformativeText(Words::tr(
        "Open it only if you know that both are of one patient, or mean to compare two patients. Pictures of "
        "it will say so."));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* yes = box->addButton(Words::tr("&Open All the Same"), QMessageBox::AcceptRole);
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

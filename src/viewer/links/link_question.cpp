#include "viewer/links/link_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QStringList>
#include <utility>

#include "study/open/identity.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

constexpr std::size_t kMostNamed = 4;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(LinkQuestion)
};

QString dayText(const std::string& day) {
    return QString::fromStdString(study::dateForPeople(day));
}

QString patientText(const study::StudyLink& link, bool showsNames) {
    QString text =
        !showsNames ? Words::tr("studies of a patient, whose ID is hidden with the names")
        : link.issuer.empty()
            ? Words::tr("studies of the patient with the ID %1").arg(QString::fromStdString(link.patientId))
            : Words::tr("studies of the patient with the ID %1 (issued by %2)")
                  .arg(QString::fromStdString(link.patientId), QString::fromStdString(link.issuer));
    if (link.mostRecent) text += Words::tr(", the %n most recent", nullptr, int(*link.mostRecent));
    if (!link.dateFrom.empty()) text += Words::tr(", from %1 on").arg(dayText(link.dateFrom));
    if (!link.dateTo.empty()) text += Words::tr(", up to %1").arg(dayText(link.dateTo));
    QStringList modalities;
    for (const std::string& each : link.modalities) modalities.append(QString::fromStdString(each));
    if (!modalities.isEmpty()) text += QStringLiteral(", ") + modalities.join(QStringLiteral(", "));
    return text;
}

QString whereText(const std::vector<net::Source>& sources) {
    if (sources.size() > kMostNamed)
        return Words::tr("Macula would ask %n archives.", nullptr, int(sources.size()));
    if (sources.size() == 1)
        return Words::tr("Macula would ask the archive %1.")
            .arg(QString::fromStdString(sources.front().name));
    QStringList names;
    for (const net::Source& each : sources) names.append(QString::fromStdString(each.name));
    return Words::tr("Macula would ask these archives: %1.").arg(names.join(QStringLiteral(", ")));
}

}  // namespace

QString whatIsAsked(const study::StudyLink& link, bool showsNames) {
    if (link.studyInstanceUids.size() == 1)
        return Words::tr("the study with the UID %1")
            .arg(QString::fromStdString(link.studyInstanceUids.front()));
    if (!link.studyInstanceUids.empty())
        return Words::tr("%n studies by their UIDs", nullptr, int(link.studyInstanceUids.size()));
    if (link.accessionNumbers.size() == 1 && showsNames)
        return Words::tr("the study with the accession number %1")
            .arg(QString::fromStdString(link.accessionNumbers.front()));
    if (!link.accessionNumbers.empty())
        return Words::tr("%n studies by their accession numbers", nullptr, int(link.accessionNumbers.size()));
    return patientText(link, showsNames);
}

QMessageBox* askToFetch(QWidget* parent, const study::StudyLink& link,
                        const std::vector<net::Source>& sources, bool showsNames,
                        std::function<void()> fetch) {
    auto* box =
        new QMessageBox(QMessageBox::Question, Words::tr("Fetch What a Link Asks For?"),
                        Words::tr("A link asks Macula to open %1.").arg(whatIsAsked(link, showsNames)) +
                            QLatin1Char(' ') + whereText(sources),
                        QMessageBox::Cancel, parent);
    box->setTextFormat(Qt::PlainText);  // a link chooses parts of it
    QStringList more = inWindowsLanguage(link.notDone);
    more.append(Words::tr("Any web page can make such a link: fetch only what you expect."));
    box->setInformativeText(more.join(QStringLiteral("\n")));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setObjectName(QStringLiteral("link-question"));
    QPushButton* yes = box->addButton(Words::tr("&Fetch"), QMessageBox::AcceptRole);
    yes->setObjectName(QStringLiteral("link-fetch"));
    box->setDefaultButton(QMessageBox::Cancel);
    QObject::connect(yes, &QPushButton::clicked, box, [fetch = std::move(fetch)] { fetch(); });
    box->open();  // exec() would run a second event loop
    return box;
}

}  // namespace macula::viewer

#include "viewer/documents/document_html.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "dicom/documents/document_text.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

constexpr int kIndentPx = 18;
constexpr int kDeepestIndent = 20;

QString escaped(const QString& text) {
    return text.toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br/>"));
}

QString escaped(const Text& text) {
    return escaped(inWindowsLanguage(text));
}

using Places = std::map<std::pair<std::string, std::vector<int>>, int>;

Places placesOf(const dicom::StudyDocument& document) {
    Places places;
    int next = 0;
    for (const dicom::DocumentReference& each : document.references())
        places.emplace(std::pair(each.sopInstanceUid, each.frames), next++);
    return places;
}

}  // namespace

QString htmlOf(const dicom::StudyDocument& document,
               const std::function<QString(const dicom::DocumentReference&)>& nameReference) {
    const Places places = placesOf(document);
    QString html;
    for (const dicom::DocumentEntry& entry : document.entries) {
        const QString heading = escaped(headingOf(entry));
        QString value = escaped(entry.value);
        for (const dicom::DocumentReference& each : entry.references) {
            const QString where = nameReference(each);
            if (where.isEmpty()) continue;
            const int place = places.at({each.sopInstanceUid, each.frames});
            value += QStringLiteral(" <a href=\"#%1\">%2</a>").arg(place).arg(escaped(where));
        }
        const int indentPx = kIndentPx * std::min(entry.depth, kDeepestIndent);
        const char* const begins = entry.isSection ? "<p style=\"margin-top:10px; margin-bottom:2px; "
                                                     "margin-left:%1px\"><b>"
                                                   : "<p style=\"margin-top:2px; margin-bottom:2px; "
                                                     "margin-left:%1px\">";
        html += QString::fromLatin1(begins).arg(indentPx);
        if (entry.isTechnical) html += QStringLiteral("<span style=\"color:gray\">");
        html += heading;
        if (!heading.isEmpty() && !value.isEmpty()) html += QStringLiteral(": ");
        // A value stands out from its heading.
        const bool isBold = !entry.isSection && !entry.isTechnical && !heading.isEmpty();
        html += isBold ? QStringLiteral("<b>") + value + QStringLiteral("</b>") : value;
        if (entry.isTechnical) html += QStringLiteral("</span>");
        html += entry.isSection ? QStringLiteral("</b></p>") : QStringLiteral("</p>");
    }
    return html;
}

}  // namespace macula::viewer

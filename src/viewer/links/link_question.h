// Asks whether what a link wants is to be fetched.
#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "net/archive/source.h"
#include "study/link/study_link.h"

class QMessageBox;
class QWidget;

namespace macula::viewer {

// Puts in words what the link asks for: "the study with the accession number 4711". Without names, the words
// hold no number and no ID.
QString whatIsAsked(const study::StudyLink& link, bool showsNames);

// Names what is asked for and from which archives, and returns at once. Calls `fetch` if the answer is yes;
// Cancel is what Enter and Escape mean, since nobody need have asked for the question. The box destroys
// itself.
QMessageBox* askToFetch(QWidget* parent, const study::StudyLink& link,
                        const std::vector<net::Source>& sources, bool showsNames,
                        std::function<void()> fetch);

}  // namespace macula::viewer

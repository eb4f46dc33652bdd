#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <vector>

namespace lessons {

/// A heading of a document with the lines below it, up to the next heading.
struct DocumentPart
{
    QString heading; ///< without its signs: "Try {#throw}"
    int line = 1;    ///< of the heading, from 1
    QStringList body = {};
};

/// A heading with `##`, and the headings with `###` below it.
struct DocumentSection
{
    DocumentPart part;
    std::vector<DocumentPart> fields = {};
};

/// The headings of a document.
struct ScannedDocument
{
    DocumentPart title; ///< the body is the story
    std::vector<DocumentSection> sections = {};
};

/// A piece of code between two fences, and the lines after it.
struct FencedCode
{
    bool isThere = false;
    QString code = {}; ///< may be empty
    QStringList after = {};
};

/// Splits a document at its headings. Lines of fenced code are never headings.
/// @throws DocumentError if the source is not UTF-8, has no title, a second one, or code without an end
ScannedDocument scanDocument(const QByteArray &source, const QString &file);

/// Returns lines as Markdown in which a paragraph is one line. List items, table rows, quotes and fenced code keep their
/// lines.
QString joinedText(const QStringList &lines);

/// Takes the first piece of fenced code from lines that begin with it.
FencedCode takeCode(const QStringList &lines);

}

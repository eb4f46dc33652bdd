#pragma once

#include "app/ui/theme/theme.h"

#include <QTextDocument>
#include <QUrl>

namespace app {

class Glossary;

/// How a piece of Markdown is set.
struct ProseStyle
{
    double size = 13;       ///< px, a whole number: Qt draws no others
    double lineHeight = 20; ///< px
    double paragraphGap = 6;
    QColor text;
    QColor bold;
    QFont::Weight boldWeight = QFont::DemiBold;
    double tracking = 0; ///< px between letters, added
};

/// Fills `document` with `markdown`. Style sheets cannot set line heights, so that is done here.
void setProse(QTextDocument &document, const QString &markdown, const ProseStyle &style, const Theme &theme);

/// The link to a word of the glossary, and the word that a link leads to: empty for any other link.
QUrl wordLink(const QString &name);
QString wordOf(const QUrl &link);

/// Makes links of the words of `glossary` where they stand first. They keep their colour: what is read stays calm.
void linkWords(QTextDocument &document, const Glossary &glossary, const Theme &theme);

/// The link to a step, and the ids that a link leads to: empty for any other link.
QUrl stepLink(const QString &lesson, const QString &step);
struct StepPlace
{
    QString lesson;
    QString step;
};
StepPlace stepOf(const QUrl &link);

/// Text without Markdown's marks, for screen readers.
QString plainText(const QString &markdown);

}

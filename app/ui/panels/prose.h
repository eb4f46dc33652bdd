#pragma once

#include "app/ui/theme/theme.h"

#include <QTextDocument>

namespace app {

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

/// Text without Markdown's marks, for screen readers.
QString plainText(const QString &markdown);

}

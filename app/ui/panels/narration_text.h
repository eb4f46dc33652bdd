#pragma once

#include "app/ui/theme/theme.h"

#include <QTextBrowser>

namespace app {

class Glossary;

/// A text in Markdown, as high as it needs to be. Links of https are opened; all others are told of.
class NarrationText : public QTextBrowser
{
    Q_OBJECT

public:
    enum class Kind {
        narration, ///< what a step tells
        aside,     ///< smaller: a hint, an answer, a word
    };

    explicit NarrationText(const Theme &theme, QWidget *parent = nullptr, Kind kind = Kind::narration);

    /// Words of this glossary become links, each where it stands first. It must outlive this.
    void setGlossary(const Glossary &glossary) { m_glossary = &glossary; }
    void setText(const QString &markdown);
    /// Larger type, for large windows.
    void setLarge(bool large);
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {120, 20}; }

signals:
    /// A link; for a word of the glossary as wordLink() makes it. `place`: under the link, on the screen.
    void asked(const QUrl &link, const QPoint &place);

private:
    void dress();
    void follow(const QUrl &link);

    const Theme &m_theme;
    const Glossary *m_glossary = nullptr;
    Kind m_kind;
    QString m_text;
    bool m_large = false;
};

}
